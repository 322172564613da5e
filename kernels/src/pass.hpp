#pragma once

#include "scatter.hpp"
#include "stress.hpp"

/// Passes over the particles: gather, update, scatter while a group's particles are in registers
/// and its nodes in the first cache. By itself this made USL 1.1 times as fast as a step
/// that read the particles once per gather and scatter, and MUSL no faster beyond the noise; both
/// need fewer phases, which two threads feel.
namespace rgimp::kernels {
namespace {

/// What a pass changes of its particles.
struct Changes {
  bool velocity;
  bool strain;
  bool position;
};

/// x += dt v, and how far from their bins' nodes that took the row's particles, on the grid they
/// are scattered to.
template <int Dim>
class Move {
 public:
  explicit Move(const ShapeConstants<Dim>& to) : to_(to) {}

  /// `dt` is 0 in padding, which the grid may leave behind.
  void batch(const ParticleView<Dim>& particles, std::size_t index, Batch dt,
             const Batch (&velocity)[Dim], const BinOffsets<Dim>& offsets) {
    Batch step2(0.0);
    Batch farthest(0.0);
#pragma GCC unroll 3
    for (int a = 0; a < Dim; ++a) {
      const Batch step = dt * velocity[a];
      double* const position = particles.position[a] + index;
      const Batch moved = Batch::load_aligned(position) + step;
      moved.store_aligned(position);
      step2 = fused(step, step, step2);
      farthest = xsimd::max(farthest, xsimd::abs(node_distance(moved, offsets, to_, a)));
    }
    const Batch present = xsimd::select(dt > Batch(0.0), farthest, Batch(0.0));
    distance_ = xsimd::max(distance_, present);
    step2_ = xsimd::max(step2_, step2);
  }

  Reach reach() const {
    return {largest(distance_), __builtin_sqrt(largest(step2_))};
  }

 private:
  ShapeConstants<Dim> to_;
  Batch step2_ = Batch(0.0);  // m2
  Batch distance_ = Batch(0.0);
};

/// Stress and failure where a pass strains, else nothing.
template <int Dim, Changes What>
struct StressPart {
  using Type = StressUpdate<Dim>;
};
struct NoStress {
  NoStress(const auto&, const ParticleUpdate&, auto&) {}
};
template <int Dim, Changes What>
requires(!What.strain) struct StressPart<Dim, What> {
  using Type = NoStress;
};

/// Gathers what the changes need and applies them, batch by batch.
template <int Dim, Changes What>
class Gather {
 public:
  Gather(const ParticleView<Dim>& particles, const GridView<Dim>& from,
         const ShapeConstants<Dim>& shape, const ShapeConstants<Dim>& shape_to,
         const ParticleUpdate& update, FailureLog<Dim>& log)
      : view_(particles),
        grid_(from),
        shape_(shape),
        shape_to_(shape_to),
        dt_(update.dt),
        stress_(particles, update, log),
        move_(shape_to) {}

  /// The fields of a batch of bins. A value, not a member: that the compiler would copy once more.
  struct Nodes {
    VectorCoefficients<Dim> acceleration;
    VectorCoefficients<Dim> velocity;
    VectorCoefficients<Dim> strain_velocity;
  };

  Nodes nodes_at(const GroupPlace<Dim>& place, int part) const {
    Nodes nodes;
    if constexpr (Dim == 3) {
      fetch_ahead(place);
    }
    if constexpr (What.velocity) {
      load_coefficients(grid_.force, place, part, nodes.acceleration);
    }
    if constexpr (What.position) {
      load_coefficients(grid_.momentum, place, part, nodes.velocity);
    }
    if constexpr (What.strain && !kStrainsWithNewVelocity) {
      load_coefficients(grid_.second_field, place, part, nodes.strain_velocity);
    }
    return nodes;
  }

  /// In two loops over the slots: one was as fast within the noise, but harder to follow.
  void round(const Nodes& nodes, const GroupPlace<Dim>& place, Slots slots, int part) {
    const BinOffsets<Dim> offsets = place.offsets(shape_, part);
    const BinOffsets<Dim> offsets_to = place.offsets(shape_to_, part);
    Increment<Dim> increment[kRound<Dim>];
    for (std::size_t slot = slots.first; slot < slots.last; ++slot) {
      const std::size_t index = slot * kGroupWidth + part * kLanes;
      batch(nodes, index, offsets, offsets_to, increment[slot - slots.first]);
    }
    if constexpr (What.strain) {
      for (std::size_t slot = slots.first; slot < slots.last; ++slot) {
        stress_.batch(slot * kGroupWidth + part * kLanes, part, increment[slot - slots.first]);
      }
    }
  }

  double viscous_work() const { return stress_.viscous_work(); }
  Reach reach() const { return move_.reach(); }

 private:
  static constexpr std::size_t kSlotsAhead = 8;
  // USL has no field of its own for strains.
  static constexpr bool kStrainsWithNewVelocity = What.velocity && What.strain;

  void batch(const Nodes& nodes, std::size_t index, const BinOffsets<Dim>& offsets,
             const BinOffsets<Dim>& offsets_to, Increment<Dim>& increment) {
    if constexpr (Dim == 3) {
      fetch_ahead(index);
    }
    const Places<Dim> places(view_, index, offsets, shape_);
    const Basis<Dim> basis(places, shape_);
    const Batch dt = where_present(view_, index, dt_);
    if constexpr (What.strain) {
      const VectorCoefficients<Dim>& velocity =
          kStrainsWithNewVelocity ? nodes.velocity : nodes.strain_velocity;
      increment = increment_at(velocity, basis, shape_, dt);
    }
    if constexpr (What.velocity) {
      accelerate(nodes.acceleration, index, dt, basis);
    }
    if constexpr (What.position) {
      Batch velocity[Dim];
#pragma GCC unroll 3
      for (int a = 0; a < Dim; ++a) {
        velocity[a] = value_at(nodes.velocity.component[a], basis);
      }
      move_.batch(view_, index, dt, velocity, offsets_to);
    }
  }

  void fetch_ahead(const GroupPlace<3>& place) const {
    if constexpr (What.velocity) {
      kernels::fetch_ahead<3>({grid_.force[0], grid_.force[1], grid_.force[2]}, place);
    }
    if constexpr (What.position) {
      kernels::fetch_ahead<3>({grid_.momentum[0], grid_.momentum[1], grid_.momentum[2]}, place);
    }
    if constexpr (What.strain && !kStrainsWithNewVelocity) {
      kernels::fetch_ahead<3>({grid_.second_field[0], grid_.second_field[1], grid_.second_field[2]},
                              place);
    }
  }

  /// Places, velocities and masses of the particles a group on: 4 % of USL. Asking for stresses too
  /// won nothing.
  void fetch_ahead(std::size_t index) const {
    const std::size_t ahead = index + kGroupWidth * kSlotsAhead;
    __builtin_prefetch(view_.mass + ahead);
    for (int a = 0; a < Dim; ++a) {
      __builtin_prefetch(view_.position[a] + ahead, 1);
      __builtin_prefetch(view_.velocity[a] + ahead, 1);
    }
  }

  /// v += dt a [Eq. 6].
  void accelerate(const VectorCoefficients<Dim>& acceleration, std::size_t index, Batch dt,
                  const Basis<Dim>& basis) {
#pragma GCC unroll 3
    for (int a = 0; a < Dim; ++a) {
      double* const velocity = view_.velocity[a] + index;
      fused(dt, value_at(acceleration.component[a], basis), Batch::load_aligned(velocity))
          .store_aligned(velocity);
    }
  }

  ParticleView<Dim> view_;
  GridView<Dim> grid_;
  ShapeConstants<Dim> shape_;
  ShapeConstants<Dim> shape_to_;
  double dt_;
  typename StressPart<Dim, What>::Type stress_;
  Move<Dim> move_;
};

/// A scatter alone.
template <int Dim>
class LeaveAlone {
 public:
  struct Nodes {};
  Nodes nodes_at(const GroupPlace<Dim>&, int) const { return {}; }
  void round(const Nodes&, const GroupPlace<Dim>&, Slots, int) {}
};

/// Groups of a row from the first to one past the last that holds particles.
struct ColumnRange {
  std::ptrdiff_t first;
  std::ptrdiff_t last;
};

inline ColumnRange occupied_columns(const std::uint32_t* row_begin, std::ptrdiff_t groups) {
  ColumnRange columns{0, groups};
  while (columns.first < columns.last && row_begin[columns.first] == row_begin[columns.first + 1]) {
    ++columns.first;
  }
  while (columns.first < columns.last && row_begin[columns.last - 1] == row_begin[columns.last]) {
    --columns.last;
  }
  return columns;
}

template <int Dim, typename Change, Content... Whats>
[[gnu::flatten]] void pass_group(const GroupPlace<Dim>& place, Slots slots, Change& change,
                                 Scatter<Dim, Whats...>& scatter) {
  for (int part = 0; part < kParts; ++part) {
    const typename Change::Nodes nodes = change.nodes_at(place, part);
    // In a group of several rounds the terms are overwritten, and found anew.
    for_each_round<Dim>(slots, [&](Slots round) {
      change.round(nodes, place, round, part);
      scatter.find(place, round, part);
    });
  }
  scatter.sum_group(place, slots);
}

template <int Dim, typename Change, Content... Whats>
void pass_row(const ParticleView<Dim>& particles, const GridView<Dim>& grid, std::ptrdiff_t row,
              Change& change, Scatter<Dim, Whats...>& scatter) {
  const std::uint32_t* begin = particles.group_begin + row * grid.groups_in_row;
  const ColumnRange columns = occupied_columns(begin, grid.groups_in_row);
  if (columns.first == columns.last) {
    return;
  }
  scatter.begin_row();
  for (std::ptrdiff_t column = columns.first; column < columns.last; ++column) {
    pass_group(GroupPlace<Dim>(grid, row, column), {begin[column], begin[column + 1]}, change,
               scatter);
  }
  if (columns.last < grid.groups_in_row) {
    scatter.end_row(GroupPlace<Dim>(grid, row, columns.last));
  }
}

/// Calls visit(row) for the rows of bins: in three dimensions all planes of a row along y before
/// the next, so that the nodes they share are still in the second cache. Plane by plane they are
/// not (USL of 2.1 million particles 49.8 ns a particle-step, 48.5 so).
template <int Dim, typename Visit>
inline void for_each_row(const GridView<Dim>& grid, RowRange bins, Visit visit) {
  if constexpr (Dim == 2) {
    for (std::ptrdiff_t row = bins.first; row < bins.last; ++row) {
      visit(row);
    }
  } else {
    const std::ptrdiff_t stride = grid.rows_in_plane;
    for (std::ptrdiff_t first = bins.first; first < bins.last && first < bins.first + stride;
         ++first) {
      for (std::ptrdiff_t row = first; row < bins.last; row += stride) {
        visit(row);
      }
    }
  }
}

/// The fields that a scatter of the contents adds to, in their order.
template <int Dim, Content... Whats>
struct Fields {
  explicit Fields(const GridView<Dim>& grid) {
    int next = 0;
    (add(Whats, grid, next), ...);
  }

  double* field[(kFields<Dim, Whats> + ...)];

 private:
  void add(Content what, const GridView<Dim>& grid, int& next) {
    if (what == Content::mass_momentum) {
      field[next++] = grid.mass;
    }
    for (int a = 0; a < Dim; ++a) {
      field[next++] = what == Content::force           ? grid.force[a]
                      : what == Content::mass_momentum ? grid.momentum[a]
                                                       : grid.second_field[a];
    }
  }
};

template <int Dim, Changes What, Content... Whats>
void pass(const ParticleView<Dim>& particles, const GridView<Dim>& from, const GridView<Dim>& to,
          const ParticleUpdate& update, RowRange bins) {
  const ShapeConstants<Dim> shape(from);
  const ShapeConstants<Dim> shape_to(to);
  const Fields<Dim, Whats...> fields(to);
  Scatter<Dim, Whats...> scatter(particles, shape_to, fields.field);
  for_each_row(from, bins, [&](std::ptrdiff_t row) {
    FailureLog<Dim> log(update.step);
    Gather<Dim, What> gather(particles, from, shape, shape_to, update, log);
    pass_row(particles, from, row, gather, scatter);
    if constexpr (What.strain) {
      update.sums[row] = {gather.viscous_work(), log.released(), log.tension(), log.shear()};
    }
    if constexpr (What.position) {
      update.reach[row] = gather.reach();
    }
  });
}

template <int Dim, Content... Whats>
void scatter_only(const ParticleView<Dim>& particles, const GridView<Dim>& to, RowRange bins) {
  const ShapeConstants<Dim> shape(to);
  const Fields<Dim, Whats...> fields(to);
  Scatter<Dim, Whats...> scatter(particles, shape, fields.field);
  LeaveAlone<Dim> nothing;
  for_each_row(to, bins,
               [&](std::ptrdiff_t row) { pass_row(particles, to, row, nothing, scatter); });
}

}  // namespace
}  // namespace rgimp::kernels
