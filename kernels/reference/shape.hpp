#pragma once

#include <algorithm>
#include <cmath>

#include "particle_loop.hpp"

namespace rgimp::kernels::reference {

/// Weights of the three nodes around the nearest one along an axis, lower node first.
struct AxisWeights {
  double value[3];
  double slope[3];  ///< per cell
};

/// Eq. 18 without branches, about the nearest node. `offset` is (x - x_nearest) / L, exact while
/// |offset| <= 1 - half_size. Eq. 18 as printed is wrong: its fourth range swallows the flank.
inline AxisWeights axis_weights(double offset, double half_size) {
  const double core = std::clamp(offset, -half_size, half_size);
  const double flank = offset - core;
  const double up = core + half_size;
  const double down = half_size - core;
  AxisWeights w;
  w.value[2] = up * up / (4.0 * half_size) + std::max(flank, 0.0);
  w.value[0] = down * down / (4.0 * half_size) - std::min(flank, 0.0);
  w.value[1] = 1.0 - w.value[2] - w.value[0];
  w.slope[2] = up / (2.0 * half_size);
  w.slope[0] = -down / (2.0 * half_size);
  w.slope[1] = -(w.slope[2] + w.slope[0]);
  return w;
}

/// Node indices along each axis of a node.
template <int Dim>
void node_indices(const GridView<Dim>& grid, std::ptrdiff_t node, std::ptrdiff_t (&index)[Dim]) {
  const std::ptrdiff_t stride = row_stride(grid);
  const std::ptrdiff_t row = node / stride;
  index[0] = node % stride;
  index[1] = Dim == 2 ? row : row % grid.rows_in_plane;
  if constexpr (Dim == 3) {
    index[2] = row / grid.rows_in_plane;
  }
}

/// Tensor product of the axes' weights [Eq. 19].
template <int Dim>
Stencil<Dim> stencil_of(const ParticleView<Dim>& particles, const GridView<Dim>& grid,
                        std::size_t particle, std::ptrdiff_t nearest) {
  std::ptrdiff_t index[Dim];
  node_indices(grid, nearest, index);
  AxisWeights axis[Dim];
  for (int a = 0; a < Dim; ++a) {
    const double cells = (particles.position[a][particle] - grid.origin[a]) / grid.cell_size;
    axis[a] = axis_weights(cells - static_cast<double>(index[a]), grid.particle_half_size);
  }
  const std::ptrdiff_t stride[3] = {1, row_stride(grid), row_stride(grid) * grid.rows_in_plane};
  Stencil<Dim> stencil;
  for (int n = 0; n < kStencil<Dim>; ++n) {
    const int step[3] = {n % 3, n / 3 % 3, n / 9};
    stencil.node[n] = nearest;
    stencil.weight[n] = 1.0;
    for (int a = 0; a < Dim; ++a) {
      stencil.node[n] += (step[a] - 1) * stride[a];
      stencil.weight[n] *= axis[a].value[step[a]];
      stencil.gradient[n][a] = 1.0 / grid.cell_size;
      for (int b = 0; b < Dim; ++b) {
        stencil.gradient[n][a] *= a == b ? axis[b].slope[step[b]] : axis[b].value[step[b]];
      }
    }
  }
  return stencil;
}

}  // namespace rgimp::kernels::reference
