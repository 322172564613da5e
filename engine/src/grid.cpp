#include "grid.hpp"

#include <algorithm>

namespace rgimp {

template <int Dim>
Grid<Dim>::Grid(const GridExtent& extent, int particles_per_cell, double damping)
    : extent_{extent, extent},
      particle_half_size_(0.5 / particles_per_cell),
      groups_in_row_((extent.nodes[0] + kernels::kGroupWidth - 1) / kernels::kGroupWidth) {
  const std::size_t size = static_cast<std::size_t>(rows() * row_stride() + 2 * kHalo);
  mass_.assign(size, 0.0);
  damping_.assign(size, damping);
  for (int a = 0; a < Dim; ++a) {
    for (int layer = 0; layer < 2; ++layer) {
      momentum_[layer][a].assign(size, 0.0);
      force_[layer][a].assign(size, 0.0);
    }
    second_field_[a].assign(size, 0.0);
  }
}

template <int Dim>
std::ptrdiff_t Grid<Dim>::rows() const {
  return extent().nodes[1] * extent().nodes[2];
}

template <int Dim>
Vector Grid<Dim>::position(std::ptrdiff_t node, int layer) const {
  const GridExtent& extent = extent_[layer];
  const std::ptrdiff_t row = node / row_stride();
  const std::ptrdiff_t plane = row / extent.nodes[1];
  const Vector index(static_cast<double>(node % row_stride()),
                     static_cast<double>(row % extent.nodes[1]), static_cast<double>(plane));
  return extent.origin + extent.spacing.cwiseProduct(index);
}

template <int Dim>
kernels::GridView<Dim> Grid<Dim>::view(int layer) {
  kernels::GridView<Dim> v{};
  for (int a = 0; a < Dim; ++a) {
    v.origin[a] = extent_[layer].origin[a];
    v.spacing[a] = extent_[layer].spacing[a];
    v.momentum[a] = momentum_[layer][a].data() + kHalo;
    v.force[a] = force_[layer][a].data() + kHalo;
    v.second_field[a] = second_field_[a].data() + kHalo;
  }
  v.particle_half_size = particle_half_size_;
  v.groups_in_row = groups_in_row_;
  v.rows_in_plane = extent().nodes[1];
  v.mass = mass_.data() + kHalo;
  v.damping = damping_.data() + kHalo;
  return v;
}

template <int Dim>
void Grid<Dim>::clear_rows(Field& field, kernels::RowRange rows) {
  std::fill(field.begin() + kHalo + rows.first * row_stride(),
            field.begin() + kHalo + rows.last * row_stride(), 0.0);
}

template <int Dim>
void Grid<Dim>::clear(kernels::RowRange rows, int layer) {
  clear_mass_momentum(rows, layer);
  clear_force(rows, layer);
}

template <int Dim>
void Grid<Dim>::clear_mass_momentum(kernels::RowRange rows, int layer) {
  clear_rows(mass_, rows);
  for (auto& field : momentum_[layer]) {
    clear_rows(field, rows);
  }
}

template <int Dim>
void Grid<Dim>::clear_force(kernels::RowRange rows, int layer) {
  for (auto& field : force_[layer]) {
    clear_rows(field, rows);
  }
}

template <int Dim>
void Grid<Dim>::clear_second_field(kernels::RowRange rows) {
  for (auto& field : second_field_) {
    clear_rows(field, rows);
  }
}

template <int Dim>
std::size_t Grid<Dim>::memory_bytes() const {
  return kFields * mass_.capacity() * sizeof(double);
}

template class Grid<2>;
template class Grid<3>;

}  // namespace rgimp
