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

/// A grid and particles anywhere in the range a particle may drift before its bin is wrong,
/// |x - x_node| <= (1 - l) L of the first layer, two materials, some failed, padding in between.
/// The layers differ in origin and spacing, axis by axis.
struct RandomState {
  RandomState(unsigned seed, int particles_per_cell, const Filling& filling);

  Grid<2> grid;
  Particles<2> particles;
  std::vector<kernels::MaterialConstants> materials;

  /// Random momenta, forces, damping and masses on the nodes, some of them empty.
  void randomise_nodes();

 private:
  void place_slots(const Filling& filling);
  void set_damage(std::size_t index);
  void fill_lane(std::size_t index, const Filling& filling);
  double uniform(double low, double high);

  std::mt19937_64 random_;
};

}  // namespace rgimp::tests
