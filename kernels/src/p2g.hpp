#pragma once

#include "places.hpp"

/// P2G of a group of bins. Eight bins side by side give, per field and node row, three rows of sums
/// in registers: for the nodes below, at and above them along x. Shifted onto the same nodes they
/// reach memory once a group, in whole aligned groups but for the one node the group shares with
/// the one before; overlapping unaligned read-modify-writes instead cost a prototype 6.4 ns a
/// particle against 2.5 (stores cannot be forwarded to such loads).
namespace rgimp::kernels {
namespace {

/// Which fields a scatter adds to.
enum class Content { mass_momentum, force, momentum };

template <int Dim, Content What>
constexpr int kFields = What == Content::mass_momentum ? Dim + 1 : Dim;

/// What a batch of particles gives to its nodes, before weights.
template <int Dim>
struct Terms {
  AxisWeights axis[Dim];
  Batch mass;
  Batch momentum[Dim];                   // m v
  Batch loaded[kStressComponents<Dim>];  // -(V sigma - V q I) / L along x [Eq. 10]; no zz in 2D
};

template <Content... Whats>
constexpr bool kScattersForce = ((Whats == Content::force) || ...);
template <Content... Whats>
constexpr bool kScattersMomentum = ((Whats != Content::force) || ...);

template <int Dim, Content... Whats>
inline void find_terms(const ParticleView<Dim>& p, std::size_t index,
                       const BinOffsets<Dim>& offsets, const ShapeConstants<Dim>& shape,
                       Terms<Dim>& terms) {
  const Places<Dim> places(p, index, offsets, shape);
#pragma GCC unroll 3
  for (int a = 0; a < Dim; ++a) {
    find_axis_weights(places.axis[a], shape, terms.axis[a]);
  }
  if constexpr (kScattersMomentum<Whats...>) {
    terms.mass = Batch::load_aligned(p.mass + index);
#pragma GCC unroll 3
    for (int a = 0; a < Dim; ++a) {
      terms.momentum[a] = terms.mass * Batch::load_aligned(p.velocity[a] + index);
    }
  }
  if constexpr (kScattersForce<Whats...>) {
    // Slopes per cell along x on every axis, so that `loaded` serves all of them.
#pragma GCC unroll 2
    for (int a = 1; a < Dim; ++a) {
#pragma GCC unroll 3
      for (Batch& slope : terms.axis[a].slope) {
        slope = slope * Batch(shape.aspect[a]);
      }
    }
    const Batch volume = Batch::load_aligned(p.volume + index) * Batch(-shape.cells_per_metre[0]);
    const Batch viscous =
        Batch::load_aligned(p.viscous_energy + index) * Batch(shape.cells_per_metre[0]);
#pragma GCC unroll 6
    for (int c = 0; c < kStressComponents<Dim>; ++c) {
      if (Dim == 2 && c == 2) {
        continue;  // zz pulls at no node of the plane
      }
      const Batch stress = Batch::load_aligned(p.stress[c] + index);
      terms.loaded[c] = c < 3 ? fused(volume, stress, viscous) : volume * stress;
    }
  }
}

/// Sums of fields for the nodes below, at and above a batch of bins along x.
template <int Count>
struct Sums {
  Sums() {
#pragma GCC unroll 4
    for (int f = 0; f < Count; ++f) {
#pragma GCC unroll 3
      for (int k = 0; k < 3; ++k) {
        field[f][k] = Batch(0.0);
      }
    }
  }
  Batch field[Count][3];
};

/// Weights along all axes but x of one row of nodes.
template <int Dim>
inline Batch row_weight(const Terms<Dim>& terms, int row) {
  if constexpr (Dim == 2) {
    return terms.axis[1].value[row];
  } else {
    return terms.axis[1].value[row % 3] * terms.axis[2].value[row / 3];
  }
}

inline void add_weighted(Batch value, const AxisWeights& x, Batch (&sums)[3]) {
#pragma GCC unroll 3
  for (int k = 0; k < 3; ++k) {
    sums[k] = fused(value, x.value[k], sums[k]);
  }
}

/// m S and m v S of one node row [Eq. 8, 9].
template <int Dim, Content What>
inline void add_momentum(const Terms<Dim>& terms, int row, Sums<kFields<Dim, What>>& sums) {
  constexpr int kFirst = What == Content::mass_momentum ? 1 : 0;
  const Batch weight = row_weight(terms, row);
  if constexpr (What == Content::mass_momentum) {
    add_weighted(weight * terms.mass, terms.axis[0], sums.field[0]);
  }
#pragma GCC unroll 3
  for (int a = 0; a < Dim; ++a) {
    add_weighted(weight * terms.momentum[a], terms.axis[0], sums.field[kFirst + a]);
  }
}

/// -(V sigma - V q I) grad S of one node row but for the nodes at the bins, which get the rest:
/// weights along x sum to one and slopes to zero, so sums.field[a][1] only collects what all three
/// nodes share (see finish_force) [Eq. 10].
template <int Dim>
inline void add_force(const Terms<Dim>& terms, int row, Sums<Dim>& sums) {
  const Batch weight = row_weight(terms, row);
#pragma GCC unroll 3
  for (int a = 0; a < Dim; ++a) {
    const Batch along = terms.loaded[kStressColumn[a][0]] * weight;
    Batch across;
    if constexpr (Dim == 2) {
      across = terms.loaded[kStressColumn[a][1]] * terms.axis[1].slope[row];
    } else {
      const AxisWeights& y = terms.axis[1];
      const AxisWeights& z = terms.axis[2];
      across = fused(terms.loaded[kStressColumn[a][2]], y.value[row % 3] * z.slope[row / 3],
                     terms.loaded[kStressColumn[a][1]] * y.slope[row % 3] * z.value[row / 3]);
    }
    sums.field[a][1] = sums.field[a][1] + across;
#pragma GCC unroll 2
    for (int k = 0; k < 3; k += 2) {
      sums.field[a][k] = fused(along, terms.axis[0].slope[k],
                               fused(across, terms.axis[0].value[k], sums.field[a][k]));
    }
  }
}

template <int Dim>
inline void finish_force(Sums<Dim>& sums) {
#pragma GCC unroll 3
  for (int a = 0; a < Dim; ++a) {
    sums.field[a][1] = sums.field[a][1] - (sums.field[a][0] + sums.field[a][2]);
  }
}

/// Scatters the contents named, group by group along rows of bins, into `field` (in the order of
/// the contents).
template <int Dim, Content... Whats>
class Scatter {
 public:
  static constexpr int kCount = (kFields<Dim, Whats> + ...);

  Scatter(const ParticleView<Dim>& particles, const ShapeConstants<Dim>& shape,
          double* const (&field)[kCount])
      : particles_(particles), shape_(shape) {
    for (int f = 0; f < kCount; ++f) {
      field_[f] = field[f];
    }
  }

  /// The first group of a row that holds particles. Unless it is the row's first, its lowest nodes
  /// belong to the group before.
  void begin_row() {
    for (auto& row : carry_) {
      for (auto& upper : row) {
        Batch(0.0).store_aligned(upper.lane);
      }
    }
  }

  /// Finds the terms of a batch of lanes of a round of slots.
  void find(const GroupPlace<Dim>& place, Slots round, int part) {
    const BinOffsets<Dim> offsets = place.offsets(shape_, part);
    for (std::size_t slot = round.first; slot < round.last; ++slot) {
      find_terms<Dim, Whats...>(particles_, slot * kGroupWidth + part * kLanes, offsets, shape_,
                                terms_[part][slot - round.first]);
    }
  }

  /// The terms of all slots must be there if they fit in a round; else they are found here.
  void sum_group(const GroupPlace<Dim>& place, Slots slots) {
    for (int row = 0; row < kNeighbourRows<Dim>; ++row) {
      int first_field = 0;
      ((sum_row<Whats>(place, slots, row, first_field), first_field += kFields<Dim, Whats>), ...);
    }
  }

  /// What the last group gave to the node beyond it.
  void end_row(const GroupPlace<Dim>& beyond) {
    for (int row = 0; row < kNeighbourRows<Dim>; ++row) {
      for (int f = 0; f < kCount; ++f) {
        field_[f][beyond.first_node + beyond.row_offset[row]] += carry_[row][f].lane[kLanes - 1];
      }
    }
  }

 private:
  struct alignas(64) Lanes {
    double lane[kLanes];
  };

  template <Content What>
  void sum_row(const GroupPlace<Dim>& place, Slots slots, int row, int first_field) {
    Sums<kFields<Dim, What>> sums[kParts];
    for (int part = 0; part < kParts; ++part) {
      add_slots<What>(place, slots, part, row, sums[part]);
      if constexpr (What == Content::force) {
        finish_force<Dim>(sums[part]);
      }
    }
#pragma GCC unroll 4
    for (int f = 0; f < kFields<Dim, What>; ++f) {
      put_down(sums, f, place, carry_[row][first_field + f].lane,
               field_[first_field + f] + place.first_node + place.row_offset[row]);
    }
  }

  template <Content What>
  void add_slots(const GroupPlace<Dim>& place, Slots slots, int part, int row,
                 Sums<kFields<Dim, What>>& sums) {
    if (slots.count() <= kRound) {
      add_round<What>(slots.count(), part, row, sums);
      return;
    }
    for_each_round(slots, [&](Slots round) {
      find(place, round, part);
      add_round<What>(round.count(), part, row, sums);
    });
  }

  template <Content What>
  void add_round(std::size_t slots, int part, int row, Sums<kFields<Dim, What>>& sums) {
    for (std::size_t s = 0; s < slots; ++s) {
      if constexpr (What == Content::force) {
        add_force<Dim>(terms_[part][s], row, sums);
      } else {
        add_momentum<Dim, What>(terms_[part][s], row, sums);
      }
    }
  }

  /// Adds a group's sums of one field and node row to its nodes, with the highest bin of the group
  /// before (`carry`, then this group's), and its lowest bin's to the node below them.
  template <int Count>
  void put_down(const Sums<Count> (&sums)[kParts], int f, const GroupPlace<Dim>& place,
                double* carry, double* node) {
    Batch before = Batch::load_aligned(carry);
    for (int part = 0; part < kParts; ++part) {
      const Batch(&sum)[3] = sums[part].field[f];
      const Batch after =
          part + 1 < kParts ? sums[part + 1 < kParts ? part + 1 : part].field[f][0] : Batch(0.0);
      const Batch all = (sum[1] + shift_up(before, sum[2])) + shift_down(sum[0], after);
      double* const at = node + part * kLanes;
      (Batch::load_aligned(at) + all).store_aligned(at);
      before = sum[2];
    }
    before.store_aligned(carry);
    if (place.index[0] > 0) {
      node[-1] += first_lane(sums[0].field[f][0]);
    }
  }

  ParticleView<Dim> particles_;
  ShapeConstants<Dim> shape_;
  double* field_[kCount];
  Terms<Dim> terms_[kParts][kRound];
  Lanes carry_[kNeighbourRows<Dim>][kCount];
};

}  // namespace
}  // namespace rgimp::kernels
