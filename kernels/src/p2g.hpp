#pragma once

#include "shape.hpp"

/// P2G: nodes are summed in registers over the slots of a group and go to memory once a group.
/// Eight bins side by side give three rows of sums: for the nodes below, at and above them along x.
/// They are shifted onto the same nodes with what the neighbouring groups carry over, so that
/// memory is read and written in whole aligned groups; overlapping unaligned read-modify-writes
/// instead cost 6.4 ns a particle against 2.5 (stores cannot be forwarded to such loads).
namespace rgimp::kernels {
namespace {

/// Which fields a scatter adds to.
enum class Content { mass_momentum, force, momentum };

template <int Dim, Content What>
constexpr int kFields = What == Content::mass_momentum ? Dim + 1 : Dim;

/// Slots whose weights are kept at a time; more slots in a group are done in further rounds.
constexpr std::size_t kRound = 16;

template <int Dim>
struct SlotWeights {
  AxisWeights axis[Dim];
};

/// Sums of one field of one node row for a group: for nodes below, at and above each bin along x.
struct alignas(64) RowSums {
  double to_node[3][kGroupWidth];
};

/// Product of the weights along all axes but x, and with the slope along one of them.
template <int Dim>
struct RowWeights {
  Batch value;
  Batch slope[Dim];  // [0] unused
};

template <int Dim>
inline RowWeights<Dim> row_weights(const SlotWeights<Dim>& weights, int row) {
  RowWeights<Dim> w;
  if constexpr (Dim == 2) {
    w.value = weights.axis[1].value[row];
    w.slope[1] = weights.axis[1].slope[row];
  } else {
    const AxisWeights& y = weights.axis[1];
    const AxisWeights& z = weights.axis[2];
    w.value = y.value[row % 3] * z.value[row / 3];
    w.slope[1] = y.slope[row % 3] * z.value[row / 3];
    w.slope[2] = y.value[row % 3] * z.slope[row / 3];
  }
  return w;
}

/// Column of stress component (a, b).
template <int Dim>
constexpr int stress_column(int a, int b) {
  constexpr int kMixed[4] = {0, 3, 5, 4};  // by a + b: xy = 1, xz = 2, yz = 3
  return a == b ? a : kMixed[a + b];
}

/// Adds a slot's particles to the sums of one node row: m S and m v S [Eq. 8, 9].
template <int Dim, Content What>
inline void add_momentum(const ParticleView<Dim>& particles, std::size_t index,
                         const SlotWeights<Dim>& weights, int row,
                         Batch (&sums)[kFields<Dim, What>][3]) {
  const Batch mass = Batch::load_aligned(particles.mass + index) * row_weights(weights, row).value;
  constexpr int kFirstMomentum = What == Content::mass_momentum ? 1 : 0;
  if constexpr (What == Content::mass_momentum) {
#pragma GCC unroll 3
    for (int k = 0; k < 3; ++k) {
      sums[0][k] = fused(mass, weights.axis[0].value[k], sums[0][k]);
    }
  }
#pragma GCC unroll 3
  for (int a = 0; a < Dim; ++a) {
    const Batch momentum = mass * Batch::load_aligned(particles.velocity[a] + index);
#pragma GCC unroll 3
    for (int k = 0; k < 3; ++k) {
      sums[kFirstMomentum + a][k] =
          fused(momentum, weights.axis[0].value[k], sums[kFirstMomentum + a][k]);
    }
  }
}

/// Adds a slot's internal force -(V sigma - V q I) grad S [Eq. 10].
template <int Dim>
inline void add_force(const ParticleView<Dim>& particles, std::size_t index,
                      const SlotWeights<Dim>& weights, int row, Batch (&sums)[Dim][3]) {
  const RowWeights<Dim> w = row_weights(weights, row);
  const Batch minus_volume = -Batch::load_aligned(particles.volume + index);
  const Batch viscous = Batch::load_aligned(particles.viscous_energy + index);
#pragma GCC unroll 3
  for (int a = 0; a < Dim; ++a) {
    Batch loaded[Dim];
#pragma GCC unroll 3
    for (int b = 0; b < Dim; ++b) {
      const Batch stress = Batch::load_aligned(particles.stress[stress_column<Dim>(a, b)] + index);
      loaded[b] = a == b ? fused(minus_volume, stress, viscous) : minus_volume * stress;
    }
    const Batch along = loaded[0] * w.value;
    Batch across = loaded[1] * w.slope[1];
    if constexpr (Dim == 3) {
      across = fused(loaded[2], w.slope[2], across);
    }
#pragma GCC unroll 3
    for (int k = 0; k < 3; ++k) {
      sums[a][k] = fused(along, weights.axis[0].slope[k],
                         fused(across, weights.axis[0].value[k], sums[a][k]));
    }
  }
}

/// Sums one node row over some slots of one batch of bins, on top of what `rows` holds.
template <int Dim, Content What>
inline void sum_row(const ParticleView<Dim>& particles, std::size_t first_slot, std::size_t slots,
                    int part, const SlotWeights<Dim>* weights, int row, RowSums* fields) {
  constexpr int kCount = kFields<Dim, What>;
  Batch sums[kCount][3];
#pragma GCC unroll 4
  for (int f = 0; f < kCount; ++f) {
#pragma GCC unroll 3
    for (int k = 0; k < 3; ++k) {
      sums[f][k] = Batch::load_aligned(fields[f].to_node[k] + part * kLanes);
    }
  }
  for (std::size_t s = 0; s < slots; ++s) {
    const std::size_t index = (first_slot + s) * kGroupWidth + part * kLanes;
    if constexpr (What == Content::force) {
      add_force<Dim>(particles, index, weights[s], row, sums);
    } else {
      add_momentum<Dim, What>(particles, index, weights[s], row, sums);
    }
  }
#pragma GCC unroll 4
  for (int f = 0; f < kCount; ++f) {
#pragma GCC unroll 3
    for (int k = 0; k < 3; ++k) {
      sums[f][k].store_aligned(fields[f].to_node[k] + part * kLanes);
    }
  }
}

/// What a group leaves to its right neighbour, for one field of one node row.
struct alignas(64) Carry {
  double partial[kGroupWidth];  // the group's nodes, but for what the next group adds
  double to_lower[kGroupWidth];
  double to_upper[kGroupWidth];
};

/// Finishes the group before `node` (its last node gets this group's lowest share) and starts this
/// one (its first node gets the previous group's highest share).
inline void pass_on(const RowSums& here, Carry& carry, double* before) {
#pragma GCC unroll 4
  for (int part = 0; part < kParts; ++part) {
    const int lane = part * kLanes;
    const Batch lower = Batch::load_aligned(carry.to_lower + lane);
    const Batch lower_next = part + 1 < kParts ? Batch::load_aligned(carry.to_lower + lane + kLanes)
                                               : Batch::load_aligned(here.to_node[0]);
    const Batch finished =
        Batch::load_aligned(carry.partial + lane) + shift_down(lower, lower_next);
    if (before != nullptr) {
      (Batch::load_aligned(before + lane) + finished).store_aligned(before + lane);
    }
  }
  Batch upper_before = Batch::load_aligned(carry.to_upper + kGroupWidth - kLanes);
#pragma GCC unroll 4
  for (int part = 0; part < kParts; ++part) {
    const int lane = part * kLanes;
    const Batch upper = Batch::load_aligned(here.to_node[2] + lane);
    const Batch partial =
        Batch::load_aligned(here.to_node[1] + lane) + shift_up(upper_before, upper);
    partial.store_aligned(carry.partial + lane);
    Batch::load_aligned(here.to_node[0] + lane).store_aligned(carry.to_lower + lane);
    upper.store_aligned(carry.to_upper + lane);
    upper_before = upper;
  }
}

/// Non-empty groups of a row: first to one past the last.
struct ColumnRange {
  std::ptrdiff_t first;
  std::ptrdiff_t last;
};

template <int Dim>
ColumnRange occupied_columns(const ParticleView<Dim>& particles, const GridView<Dim>& grid,
                             std::ptrdiff_t row) {
  const std::uint32_t* begin = particles.group_begin + row * grid.groups_in_row;
  ColumnRange columns{0, grid.groups_in_row};
  while (columns.first < columns.last && begin[columns.first] == begin[columns.first + 1]) {
    ++columns.first;
  }
  while (columns.first < columns.last && begin[columns.last - 1] == begin[columns.last]) {
    --columns.last;
  }
  return columns;
}

/// Scatters the contents named, row by row of bins, into `field` (in the order of the contents).
template <int Dim, Content... Whats>
class Scatter {
 public:
  static constexpr int kCount = (kFields<Dim, Whats> + ...);

  Scatter(const ParticleView<Dim>& particles, const GridView<Dim>& grid,
          double* const (&field)[kCount])
      : particles_(particles), grid_(grid), shape_(grid), field_(field) {}

  void row(std::ptrdiff_t row) {
    const ColumnRange columns = occupied_columns(particles_, grid_, row);
    if (columns.first == columns.last) {
      return;
    }
    for (auto& fields : carry_) {
      for (Carry& carry : fields) {
        carry = Carry{};
      }
    }
    for (std::ptrdiff_t column = columns.first; column < columns.last; ++column) {
      const GroupPlace<Dim> place(grid_, row, column);
      sum_group(place);
      pass_all_on(place, column > 0);
    }
    const GroupPlace<Dim> end(grid_, row, columns.last);
    clear_sums();
    pass_all_on(end, true);
    if (columns.last < grid_.groups_in_row) {
      add_partial(end);
    }
  }

 private:
  void clear_sums() {
    for (auto& fields : sums_) {
      for (RowSums& sums : fields) {
        sums = RowSums{};
      }
    }
  }

  void sum_group(const GroupPlace<Dim>& place) {
    const std::uint32_t* begin = particles_.group_begin + place.first_node / kGroupWidth;
    clear_sums();
    for (std::size_t first = begin[0]; first < begin[1]; first += kRound) {
      const std::size_t slots = begin[1] - first < kRound ? begin[1] - first : kRound;
      for (int part = 0; part < kParts; ++part) {
        find_weights(place, first, slots, part);
        for (int row = 0; row < kNeighbourRows<Dim>; ++row) {
          int field = 0;
          ((sum_row<Dim, Whats>(particles_, first, slots, part, weights_, row, sums_[row] + field),
            field += kFields<Dim, Whats>),
           ...);
        }
      }
    }
  }

  void find_weights(const GroupPlace<Dim>& place, std::size_t first, std::size_t slots, int part) {
    const BinOffsets<Dim> offsets = place.offsets(shape_, part);
    for (std::size_t s = 0; s < slots; ++s) {
      const std::size_t index = (first + s) * kGroupWidth + part * kLanes;
#pragma GCC unroll 3
      for (int a = 0; a < Dim; ++a) {
        weights_[s].axis[a] =
            axis_weights(node_distance(particles_, index, offsets, shape_, a), shape_);
      }
    }
  }

  void pass_all_on(const GroupPlace<Dim>& place, bool has_group_before) {
    for (int row = 0; row < kNeighbourRows<Dim>; ++row) {
      const std::ptrdiff_t before = place.first_node + place.row_offset[row] - kGroupWidth;
      for (int f = 0; f < kCount; ++f) {
        pass_on(sums_[row][f], carry_[row][f], has_group_before ? field_[f] + before : nullptr);
      }
    }
  }

  void add_partial(const GroupPlace<Dim>& place) {
    for (int row = 0; row < kNeighbourRows<Dim>; ++row) {
      for (int f = 0; f < kCount; ++f) {
        double* node = field_[f] + place.first_node + place.row_offset[row];
        for (int lane = 0; lane < kGroupWidth; ++lane) {
          node[lane] += carry_[row][f].partial[lane];
        }
      }
    }
  }

  const ParticleView<Dim>& particles_;
  const GridView<Dim>& grid_;
  ShapeConstants<Dim> shape_;
  double* const (&field_)[kCount];
  SlotWeights<Dim> weights_[kRound];
  RowSums sums_[kNeighbourRows<Dim>][kCount];
  Carry carry_[kNeighbourRows<Dim>][kCount];
};

template <int Dim, Content... Whats, int Count>
void scatter(const ParticleView<Dim>& particles, const GridView<Dim>& grid,
             double* const (&field)[Count], RowRange bins) {
  Scatter<Dim, Whats...> scatter(particles, grid, field);
  for (std::ptrdiff_t row = bins.first; row < bins.last; ++row) {
    scatter.row(row);
  }
}

template <int Dim>
void scatter_all(const ParticleView<Dim>& particles, const GridView<Dim>& grid, RowRange bins) {
  double* field[2 * Dim + 1] = {grid.mass};
  for (int a = 0; a < Dim; ++a) {
    field[1 + a] = grid.momentum[a];
    field[1 + Dim + a] = grid.force[a];
  }
  scatter<Dim, Content::mass_momentum, Content::force>(particles, grid, field, bins);
}

template <int Dim>
void scatter_mass_momentum(const ParticleView<Dim>& particles, const GridView<Dim>& grid,
                           RowRange bins) {
  double* field[Dim + 1] = {grid.mass};
  for (int a = 0; a < Dim; ++a) {
    field[1 + a] = grid.momentum[a];
  }
  scatter<Dim, Content::mass_momentum>(particles, grid, field, bins);
}

template <int Dim>
void scatter_force(const ParticleView<Dim>& particles, const GridView<Dim>& grid, RowRange bins) {
  scatter<Dim, Content::force>(particles, grid, grid.force, bins);
}

template <int Dim>
void scatter_second_momentum(const ParticleView<Dim>& particles, const GridView<Dim>& grid,
                             RowRange bins) {
  scatter<Dim, Content::momentum>(particles, grid, grid.second_field, bins);
}

}  // namespace
}  // namespace rgimp::kernels
