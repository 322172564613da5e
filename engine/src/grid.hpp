#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "column.hpp"
#include "geometry.hpp"
#include "rgimp/kernels/views.hpp"

namespace rgimp {

/// Node fields of the background grid; layout and units as in kernels::GridView. It has two layers,
/// as one is gathered from while the next step's is scattered: each has momentum and force of its
/// own, and its own place, for the grid moves; all other fields are shared.
template <int Dim>
class Grid {
 public:
  static constexpr std::size_t kFields = 2 + 5 * Dim;

  /// `damping` is beta of local damping, on every node.
  Grid(const GridExtent& extent, int particles_per_cell, double damping);

  const GridExtent& extent(int layer = 0) const { return extent_[layer]; }
  /// The layer lies at `extent` from now on; its number of nodes is that of the start.
  void move(int layer, const GridExtent& extent) { extent_[layer] = extent; }
  std::ptrdiff_t groups_in_row() const { return groups_in_row_; }
  std::ptrdiff_t row_stride() const { return groups_in_row_ * kernels::kGroupWidth; }
  std::ptrdiff_t rows() const;
  /// Half a particle over a cell, l_p / L; the same for all particles and steps (uGIMP).
  double particle_half_size() const { return particle_half_size_; }

  Vector position(std::ptrdiff_t node, int layer = 0) const;
  /// Platen nodes are not damped, else reactions would be over-reported by 1 + beta.
  void clear_damping(std::ptrdiff_t node) { damping_[kHalo + node] = 0.0; }

  kernels::GridView<Dim> view(int layer = 0);
  /// Sets mass, and momentum and force of a layer, of node rows to zero.
  void clear(kernels::RowRange rows, int layer = 0);
  void clear_mass_momentum(kernels::RowRange rows, int layer);
  void clear_force(kernels::RowRange rows, int layer);
  void clear_second_field(kernels::RowRange rows);
  std::size_t memory_bytes() const;

  /// Calls visit(name, field) for what a step that is prepared in `layer` starts from.
  template <typename Visit>
  void for_each_prepared_field(int layer, Visit visit) {
    visit("node mass", mass_);
    for (int a = 0; a < Dim; ++a) {
      visit(axis_name("node momentum", a), momentum_[layer][a]);
      visit(axis_name("node force", a), force_[layer][a]);
      visit(axis_name("node second field", a), second_field_[a]);
    }
  }

 private:
  static constexpr std::ptrdiff_t kHalo = 8;  // readable doubles around each field
  using Field = Column<double>;

  static std::string axis_name(const char* field, int axis) {
    return std::string(field) + " " + "xyz"[axis];
  }
  void clear_rows(Field& field, kernels::RowRange rows);

  std::array<GridExtent, 2> extent_;  // by layer
  double particle_half_size_;
  std::ptrdiff_t groups_in_row_;
  Field mass_;
  std::array<std::array<Field, Dim>, 2> momentum_;  // by layer
  std::array<std::array<Field, Dim>, 2> force_;
  std::array<Field, Dim> second_field_;
  Field damping_;
};

}  // namespace rgimp
