#pragma once

#include "rgimp/kernels/views.hpp"

namespace rgimp::kernels::reference {

template <int Dim>
inline constexpr int kStencil = Dim == 2 ? 9 : 27;

template <int Dim>
std::ptrdiff_t row_stride(const GridView<Dim>& grid) {
  return grid.groups_in_row * kGroupWidth;
}

/// One particle's nodes and weights.
template <int Dim>
struct Stencil {
  std::ptrdiff_t node[kStencil<Dim>];
  double weight[kStencil<Dim>];
  double gradient[kStencil<Dim>][Dim];  ///< 1/m
};

/// Calls visit(index, nearest_node, slot) for every particle of the bin rows; padding is passed
/// over.
template <int Dim, typename Visit>
void for_each_particle(const ParticleView<Dim>& particles, const GridView<Dim>& grid, RowRange bins,
                       Visit visit) {
  for (std::ptrdiff_t row = bins.first; row < bins.last; ++row) {
    for (std::ptrdiff_t column = 0; column < grid.groups_in_row; ++column) {
      const std::ptrdiff_t group = row * grid.groups_in_row + column;
      for (std::size_t slot = particles.group_begin[group]; slot < particles.group_begin[group + 1];
           ++slot) {
        for (int lane = 0; lane < kGroupWidth; ++lane) {
          const std::size_t index = slot * kGroupWidth + lane;
          if (particles.failure_mode[index] != kPadding) {
            visit(index, group * kGroupWidth + lane, slot);
          }
        }
      }
    }
  }
}

}  // namespace rgimp::kernels::reference
