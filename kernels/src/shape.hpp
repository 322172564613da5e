#pragma once

#include "rgimp/kernels/views.hpp"

/// GIMP weights of a batch of particles about their bins' nodes [Eq. 18]. Everything here has
/// internal linkage: each ISA's unit compiles its own copy (see lanes_*.hpp).
namespace rgimp::kernels {
namespace {

constexpr int kLanes = static_cast<int>(Batch::size);
/// Batches of a group of eight bins.
constexpr int kParts = kGroupWidth / kLanes;

template <int Dim>
constexpr int kNeighbourRows = Dim == 2 ? 3 : 9;

/// What the weights need of the grid, the same for a whole call.
template <int Dim>
struct ShapeConstants {
  explicit ShapeConstants(const GridView<Dim>& grid)
      : half(grid.particle_half_size), per_half(1.0 / grid.particle_half_size) {
    for (int a = 0; a < Dim; ++a) {
      cells_per_metre[a] = 1.0 / grid.spacing[a];
      aspect[a] = cells_per_metre[a] / cells_per_metre[0];
      origin_cells[a] = grid.origin[a] / grid.spacing[a];
    }
  }
  double cells_per_metre[Dim];  ///< 1/m
  double aspect[Dim];           ///< cells along x over those along the axis, in length
  double half;                  ///< cells, l
  double per_half;              ///< 1 / l
  double origin_cells[Dim];
};

/// Where a batch's bins lie: minus their nodes' grid coordinates, in cells.
template <int Dim>
struct BinOffsets {
  Batch minus_node[Dim];
};

/// Node rows a group's bins reach: pointers are base + row_offset[j] + first node of the batch.
template <int Dim>
struct GroupPlace {
  GroupPlace(const GridView<Dim>& grid, std::ptrdiff_t row, std::ptrdiff_t column)
      : first_node((row * grid.groups_in_row + column) * kGroupWidth) {
    const std::ptrdiff_t stride = grid.groups_in_row * kGroupWidth;
    index[0] = column * kGroupWidth;
    index[1] = Dim == 2 ? row : row % grid.rows_in_plane;
    if constexpr (Dim == 3) {
      index[2] = row / grid.rows_in_plane;
    }
    for (int j = 0; j < kNeighbourRows<Dim>; ++j) {
      row_offset[j] = (j % 3 - 1) * stride;
      if constexpr (Dim == 3) {
        row_offset[j] += (j / 3 - 1) * stride * grid.rows_in_plane;
      }
    }
  }

  BinOffsets<Dim> offsets(const ShapeConstants<Dim>& shape, int part) const {
    alignas(64) double lane[kGroupWidth] = {0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0};
    BinOffsets<Dim> offsets;
    const double first = -(shape.origin_cells[0] + static_cast<double>(index[0]));
    offsets.minus_node[0] = Batch(first) - Batch::load_aligned(lane + part * kLanes);
    for (int a = 1; a < Dim; ++a) {
      offsets.minus_node[a] = Batch(-(shape.origin_cells[a] + static_cast<double>(index[a])));
    }
    return offsets;
  }

  std::ptrdiff_t first_node;
  std::ptrdiff_t index[Dim];
  std::ptrdiff_t row_offset[kNeighbourRows<Dim>];
};

/// Groups of bins that nodes are asked for ahead, in three dimensions, where a group's twelve rows
/// of new nodes were not there in time (USL of 2.1 million particles 46.0 ns a particle-step
/// without, 43.3 one group ahead, 41.5 two). In the plane asking made no difference.
constexpr std::ptrdiff_t kGroupsAhead = 2;

/// Asks for the nodes of a later group in the rows above along y; those below were met before.
template <int Count>
inline void fetch_ahead(const double* const (&field)[Count], const GroupPlace<3>& place) {
  for (int row = 2; row < kNeighbourRows<3>; row += 3) {
    const std::ptrdiff_t node =
        place.first_node + place.row_offset[row] + kGroupsAhead * kGroupWidth;
    for (const double* const values : field) {
      __builtin_prefetch(values + node);
    }
  }
}

struct Slots {
  std::size_t first;
  std::size_t last;

  std::size_t count() const { return last - first; }
};

/// Slots that a group works on at a time, so that what is found of them stays in the first cache;
/// in three dimensions in the second, for groups of more are dear there.
template <int Dim>
constexpr std::size_t kRound = Dim == 2 ? 16 : 64;

template <int Dim, typename Visit>
inline void for_each_round(Slots slots, Visit visit) {
  for (std::size_t first = slots.first; first < slots.last; first += kRound<Dim>) {
    visit(Slots{first, slots.last - first < kRound<Dim> ? slots.last : first + kRound<Dim>});
  }
}

/// Distance from the bin's node along an axis, in cells.
template <int Dim>
inline Batch node_distance(Batch position, const BinOffsets<Dim>& offsets,
                           const ShapeConstants<Dim>& shape, int axis) {
  return fused(position, Batch(shape.cells_per_metre[axis]), offsets.minus_node[axis]);
}

/// A distance d from the node, in cells, cut where Eq. 18 changes its form: |core| <= l, and what
/// lies beyond l on either side, both >= 0.
struct AxisPlace {
  Batch d;
  Batch core;
  Batch above;
  Batch below;
};

template <int Dim>
inline AxisPlace axis_place(Batch distance, const ShapeConstants<Dim>& shape) {
  const Batch capped = xsimd::min(distance, Batch(shape.half));
  const Batch core = xsimd::max(capped, Batch(-shape.half));
  return {distance, core, distance - capped, core - capped};
}

/// Weights of the lower, nearest and upper node along an axis, and their slopes per cell.
struct AxisWeights {
  Batch value[3];
  Batch slope[3];
};

/// The form about the nearest node, without branches. Weights are squares of small distances, not
/// differences of moments, which were off by 2e-9 at nearly empty nodes in a prototype.
template <int Dim>
inline void find_axis_weights(const AxisPlace& place, const ShapeConstants<Dim>& shape,
                              AxisWeights& weights) {
  const Batch half(shape.half);
  const Batch per_double_half(0.5 * shape.per_half);
  const Batch up = fused(place.core, per_double_half, Batch(0.5));
  const Batch down = fused(place.core, per_double_half, Batch(-0.5));
  const Batch upper = fused(up * half, up, place.above);
  const Batch lower = fused(down * half, down, place.below);
  weights.slope[0] = down;
  weights.slope[1] = -(up + down);
  weights.slope[2] = up;
  weights.value[0] = lower;
  weights.value[1] = Batch(1.0) - upper - lower;
  weights.value[2] = upper;
}

}  // namespace
}  // namespace rgimp::kernels
