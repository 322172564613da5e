#pragma once

#include "scatter_sums.hpp"

/// P2G: nodes are summed in registers over the slots of a group and go to memory once a group (see
/// scatter_sums.hpp).
namespace rgimp::kernels {
namespace {

/// Which fields a scatter adds to.
enum class Content { mass_momentum, force, momentum };

template <int Dim, Content What>
constexpr int kFields = What == Content::mass_momentum ? Dim + 1 : Dim;

/// Slots whose weights are kept at a time; groups with more find theirs anew for every row.
constexpr std::size_t kRound = 16;

template <int Dim>
struct SlotWeights {
  AxisWeights axis[Dim];
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
      const Batch stress = Batch::load_aligned(particles.stress[kStressColumn[a][b]] + index);
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
    *here_ = GroupSums{};
    for (std::ptrdiff_t column = columns.first; column < columns.last; ++column) {
      const std::uint32_t* begin = particles_.group_begin + row * grid_.groups_in_row + column;
      sum_group(GroupPlace<Dim>(grid_, row, column), {begin[0], begin[1]},
                column > 0 ? Before::group : Before::edge);
    }
    const GroupPlace<Dim> end(grid_, row, columns.last);
    sum_group(end, {0, 0}, Before::group);
    if (columns.last < grid_.groups_in_row) {
      add_settled(end);
    }
  }

 private:
  struct Slots {
    std::size_t first;
    std::size_t last;
  };
  struct GroupSums {
    FieldSums row[kNeighbourRows<Dim>][kCount];
  };

  enum class Before { group, edge };  // what lies to the left of a group

  void sum_group(const GroupPlace<Dim>& place, Slots slots, Before left) {
    GroupSums* const before = here_;
    here_ = before == sums_ ? sums_ + 1 : sums_;
    for (int part = 0; part < kParts; ++part) {
      for (int row = 0; row < kNeighbourRows<Dim>; ++row) {
        int first_field = 0;
        ((sum_row<Whats>(place, slots, part, row, first_field, *before, left),
          first_field += kFields<Dim, Whats>),
         ...);
      }
    }
  }

  /// Sums the fields of one content of one node row over a batch of bins, and puts them down.
  template <Content What>
  void sum_row(const GroupPlace<Dim>& place, Slots slots, int part, int row, int first_field,
               const GroupSums& before, Before left) {
    constexpr int kContentFields = kFields<Dim, What>;
    Sums<kContentFields> sums;
    const bool all_at_once = slots.last - slots.first <= kRound;
    for (std::size_t first = slots.first; first < slots.last; first += kRound) {
      const std::size_t last = all_at_once ? slots.last : min(slots.last, first + kRound);
      if (!all_at_once || (row == 0 && first_field == 0)) {
        find_weights(place, {first, last}, part);
      }
      for (std::size_t slot = first; slot < last; ++slot) {
        const std::size_t index = slot * kGroupWidth + part * kLanes;
        if constexpr (What == Content::force) {
          add_force<Dim>(particles_, index, weights_[slot - first], row, sums.field);
        } else {
          add_momentum<Dim, What>(particles_, index, weights_[slot - first], row, sums.field);
        }
      }
    }
    const std::ptrdiff_t node_before = place.first_node + place.row_offset[row] - kGroupWidth;
#pragma GCC unroll 4
    for (int f = 0; f < kContentFields; ++f) {
      settle(sums.field[f], part, before.row[row][first_field + f],
             here_->row[row][first_field + f],
             left == Before::group ? field_[first_field + f] + node_before : nullptr);
    }
  }

  static std::size_t min(std::size_t a, std::size_t b) {
    return a < b ? a : b;
  }

  void find_weights(const GroupPlace<Dim>& place, Slots slots, int part) {
    const BinOffsets<Dim> offsets = place.offsets(shape_, part);
    for (std::size_t slot = slots.first; slot < slots.last; ++slot) {
      const std::size_t index = slot * kGroupWidth + part * kLanes;
#pragma GCC unroll 3
      for (int a = 0; a < Dim; ++a) {
        weights_[slot - slots.first].axis[a] =
            axis_weights(node_distance(particles_, index, offsets, shape_, a), shape_);
      }
    }
  }

  /// What the last group of a row gave to the nodes beyond it.
  void add_settled(const GroupPlace<Dim>& place) {
    for (int row = 0; row < kNeighbourRows<Dim>; ++row) {
      for (int f = 0; f < kCount; ++f) {
        double* node = field_[f] + place.first_node + place.row_offset[row];
        for (int lane = 0; lane < kGroupWidth; ++lane) {
          node[lane] += here_->row[row][f].settled[lane];
        }
      }
    }
  }

  const ParticleView<Dim>& particles_;
  const GridView<Dim>& grid_;
  ShapeConstants<Dim> shape_;
  double* const (&field_)[kCount];
  SlotWeights<Dim> weights_[kRound];
  GroupSums sums_[2];
  GroupSums* here_ = sums_;
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
