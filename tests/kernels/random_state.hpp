#pragma once

#include <random>
#include <vector>

#include "grid.hpp"
#include "particles.hpp"

namespace rgimp::tests {

/// How a random state fills its groups.
struct Filling {
  std::uint32_t most_slots = 6;     ///< slots of a group: 0 to this
  double occupied = 0.7;            ///< share of lanes with a particle
  bool only_one_per_group = false;  ///< all other lanes padding
  double initial_stress = 3e6;      ///< Pa, spread of the components
  bool softens = false;             ///< both materials have fracture energies
};

/// m; the sizes of masses and forces in three dimensions, in a slab of a cell, are those of two
/// dimensions, per metre, times this.
template <int Dim>
inline constexpr double kThickness = Dim == 2 ? 1.0 : 0.5e-3;

/// A grid and particles anywhere in the range a particle may drift before its bin is wrong,
/// |x - x_node| <= (1 - l) L of the first layer, two materials, some failed, padding in between.
/// The layers differ in origin and spacing, axis by axis.
template <int Dim>
struct RandomState {
  RandomState(unsigned seed, int particles_per_cell, const Filling& filling);

  Grid<Dim> grid;
  Particles<Dim> particles;
  std::vector<kernels::MaterialConstants> materials;

  /// Rows of bins that may hold particles, with the rows in between.
  kernels::RowRange bin_rows() const;
  std::size_t nodes() const { return static_cast<std::size_t>(grid.rows() * grid.row_stride()); }
  /// Random momenta, forces, damping and masses on the nodes, some of them empty.
  void randomise_nodes();

 private:
  void place_slots(const Filling& filling);
  bool is_inside(std::ptrdiff_t row) const;
  void set_damage(std::size_t index);
  void fill_lane(std::size_t index, const Filling& filling);
  double uniform(double low, double high);

  std::mt19937_64 random_;
};

}  // namespace rgimp::tests
