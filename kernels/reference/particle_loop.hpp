#pragma once

#include "rgimp/kernels/views.hpp"

namespace rgimp::kernels::reference {

template <int Dim>
std::ptrdiff_t row_stride(const GridView<Dim>& grid) {
  return grid.groups_in_row * kGroupWidth;
}

/// A bin's node: where it is in the fields and on the grid.
template <int Dim>
struct BinNode {
  std::ptrdiff_t node;
  double index[Dim];
};

template <int Dim>
BinNode<Dim> bin_node(const GridView<Dim>& grid, std::ptrdiff_t row, std::ptrdiff_t column) {
  BinNode<Dim> bin;
  bin.node = row * row_stride(grid) + column;
  bin.index[0] = static_cast<double>(column);
  bin.index[1] = static_cast<double>(Dim == 2 ? row : row % grid.rows_in_plane);
  if constexpr (Dim == 3) {
    const std::ptrdiff_t plane = row / grid.rows_in_plane;
    bin.index[2] = static_cast<double>(plane);
  }
  return bin;
}

/// Calls visit(particle, its bin's node, slot) for every particle of the bin rows, bin by bin of
/// a group; padding is passed over.
template <int Dim, typename Visit>
void for_each_particle(const ParticleView<Dim>& particles, const GridView<Dim>& grid, RowRange bins,
                       Visit visit) {
  for (std::ptrdiff_t row = bins.first; row < bins.last; ++row) {
    for (std::ptrdiff_t column = 0; column < row_stride(grid); ++column) {
      const std::ptrdiff_t group = row * grid.groups_in_row + column / kGroupWidth;
      const BinNode<Dim> bin = bin_node(grid, row, column);
      for (std::size_t slot = particles.group_begin[group]; slot < particles.group_begin[group + 1];
           ++slot) {
        const std::size_t particle =
            slot * kGroupWidth + static_cast<std::size_t>(column) % kGroupWidth;
        if (particles.failure_mode[particle] != kPadding) {
          visit(particle, bin, slot);
        }
      }
    }
  }
}

}  // namespace rgimp::kernels::reference
