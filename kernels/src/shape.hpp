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
      : cells_per_metre(1.0 / grid.cell_size),
        half(grid.particle_half_size),
        per_quad_half(0.25 / grid.particle_half_size),
        per_double_half(0.5 / grid.particle_half_size) {
    for (int a = 0; a < Dim; ++a) {
      origin_cells[a] = grid.origin[a] / grid.cell_size;
    }
  }
  double cells_per_metre;  ///< 1/m
  double half;             ///< cells, l
  double per_quad_half;    ///< 1 / 4l
  double per_double_half;  ///< 1 / 2l
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

/// Calls visit(place) for the groups of a row of bins that hold particles.
template <int Dim, typename Visit>
inline void for_each_group(const ParticleView<Dim>& particles, const GridView<Dim>& grid,
                           std::ptrdiff_t row, Visit visit) {
  const std::uint32_t* begin = particles.group_begin + row * grid.groups_in_row;
  for (std::ptrdiff_t column = 0; column < grid.groups_in_row; ++column) {
    if (begin[column] != begin[column + 1]) {
      visit(GroupPlace<Dim>(grid, row, column));
    }
  }
}

/// Distance from the bin's node along an axis, in cells.
template <int Dim>
inline Batch node_distance(const ParticleView<Dim>& particles, std::size_t index,
                           const BinOffsets<Dim>& offsets, const ShapeConstants<Dim>& shape,
                           int axis) {
  return fused(Batch::load_aligned(particles.position[axis] + index), Batch(shape.cells_per_metre),
               offsets.minus_node[axis]);
}

/// Weights of the lower, nearest and upper node along an axis, and their slopes in 1/m.
struct AxisWeights {
  Batch value[3];
  Batch slope[3];
};

/// The form about the nearest node, without branches. Weights are squares of small distances, not
/// differences of moments, which were off by 2e-9 at nearly empty nodes in a prototype.
template <int Dim>
inline AxisWeights axis_weights(Batch distance, const ShapeConstants<Dim>& shape) {
  const Batch half(shape.half);
  const Batch zero(0.0);
  const Batch core = xsimd::min(xsimd::max(distance, -half), half);
  const Batch flank = distance - core;
  const Batch up = core + half;
  const Batch down = half - core;
  const Batch quad(shape.per_quad_half);
  const Batch slope(shape.per_double_half * shape.cells_per_metre);
  AxisWeights w;
  w.value[2] = fused(up * quad, up, xsimd::max(flank, zero));
  w.value[0] = fused(down * quad, down, -xsimd::min(flank, zero));
  w.value[1] = Batch(1.0) - w.value[2] - w.value[0];
  w.slope[2] = up * slope;
  w.slope[0] = -down * slope;
  w.slope[1] = -(w.slope[2] + w.slope[0]);
  return w;
}

}  // namespace
}  // namespace rgimp::kernels
