#pragma once

#include <algorithm>
#include <cmath>

#include "particle_loop.hpp"

namespace rgimp::kernels::reference {

/// What the weights need of the grid, divisions done once.
template <int Dim>
struct Shape {
  explicit Shape(const GridView<Dim>& grid)
      : half(grid.particle_half_size),
        per_quad_half(0.25 / grid.particle_half_size),
        stride{1, row_stride(grid), row_stride(grid) * grid.rows_in_plane} {
    for (int a = 0; a < Dim; ++a) {
      cells_per_metre[a] = 1.0 / grid.spacing[a];
      slope[a] = 0.5 / (grid.particle_half_size * grid.spacing[a]);
      origin_cells[a] = grid.origin[a] * cells_per_metre[a];
    }
  }
  double cells_per_metre[Dim];
  double half;           ///< cells
  double per_quad_half;  ///< 1 / 4l
  double slope[Dim];     ///< 1/m, 1 / 2lL
  std::ptrdiff_t stride[3];
  double origin_cells[Dim];
};

/// Weights of the three nodes around the nearest one along an axis, lower node first.
struct AxisWeights {
  double value[3];
  double slope[3];  ///< 1/m
};

/// Eq. 18 without branches, about the nearest node. `offset` is (x - x_nearest) / L, exact while
/// |offset| <= 1 - half. Eq. 18 as printed is wrong: its fourth range swallows the linear flank.
template <int Dim>
AxisWeights axis_weights(double offset, const Shape<Dim>& shape, int axis) {
  const double core = std::min(std::max(offset, -shape.half), shape.half);
  const double flank = offset - core;
  const double up = core + shape.half;
  const double down = shape.half - core;
  AxisWeights w;
  w.value[2] = up * up * shape.per_quad_half + std::max(flank, 0.0);
  w.value[0] = down * down * shape.per_quad_half - std::min(flank, 0.0);
  w.value[1] = 1.0 - w.value[2] - w.value[0];
  w.slope[2] = up * shape.slope[axis];
  w.slope[0] = -down * shape.slope[axis];
  w.slope[1] = -(w.slope[2] + w.slope[0]);
  return w;
}

/// A particle's weights along each axis and its lowest node.
template <int Dim>
struct Stencil {
  std::ptrdiff_t lowest;
  AxisWeights axis[Dim];
};

/// Distance of a particle from its bin's node along an axis, in cells.
template <int Dim>
double node_distance(const ParticleView<Dim>& particles, std::size_t particle,
                     const BinNode<Dim>& bin, const Shape<Dim>& shape, int axis) {
  return particles.position[axis][particle] * shape.cells_per_metre[axis] -
         shape.origin_cells[axis] - bin.index[axis];
}

template <int Dim>
Stencil<Dim> stencil_of(const ParticleView<Dim>& particles, std::size_t particle,
                        const BinNode<Dim>& bin, const Shape<Dim>& shape) {
  Stencil<Dim> stencil;
  stencil.lowest = bin.node;
  for (int a = 0; a < Dim; ++a) {
    stencil.axis[a] = axis_weights(node_distance(particles, particle, bin, shape, a), shape, a);
    stencil.lowest -= shape.stride[a];
  }
  return stencil;
}

/// Calls visit(node, S, dS/dx) for the stencil's nodes; tensor products of the axes' weights
/// [Eq. 19].
template <int Dim, typename Visit>
void for_each_node(const Stencil<Dim>& stencil, const Shape<Dim>& shape, Visit visit) {
  const AxisWeights& x = stencil.axis[0];
  const AxisWeights& y = stencil.axis[1];
  constexpr int kPlanes = Dim == 2 ? 1 : 3;
  for (int k = 0; k < kPlanes; ++k) {
    for (int j = 0; j < 3; ++j) {
      for (int i = 0; i < 3; ++i) {
        const std::ptrdiff_t node = stencil.lowest + i + j * shape.stride[1] + k * shape.stride[2];
        if constexpr (Dim == 2) {
          const double gradient[2] = {x.slope[i] * y.value[j], x.value[i] * y.slope[j]};
          visit(node, x.value[i] * y.value[j], gradient);
        } else {
          const AxisWeights& z = stencil.axis[2];
          const double gradient[3] = {x.slope[i] * y.value[j] * z.value[k],
                                      x.value[i] * y.slope[j] * z.value[k],
                                      x.value[i] * y.value[j] * z.slope[k]};
          visit(node, x.value[i] * y.value[j] * z.value[k], gradient);
        }
      }
    }
  }
}

}  // namespace rgimp::kernels::reference
