#pragma once

#include <string>
#include <vector>

#include "grid.hpp"
#include "kernel_parts.hpp"
#include "particles.hpp"
#include "rgimp/kernels/table.hpp"

namespace rgimp::bench {

/// All that kernels read and write: example 1 on its lattice, in motion, in the first layer of the
/// grid what a step starts from.
struct KernelState {
  KernelState();

  /// So that a kernel may run any number of times: time all but stands still, so that particles
  /// stay in their bins and intact; nodes weigh 1 kg, so that dividing by mass again and again
  /// leaves a size as it is, and no force acts on them that would grow. What scatters add grows in
  /// proportion to the runs, which is harmless. No kernel takes another path for it.
  void hold_still();
  /// Stresses so large that some of the particles fail.
  void load_to_failure();

  kernels::RowRange nodes() const { return {0, grid.rows()}; }
  kernels::RowRange bins() const { return {1, grid.rows() - 1}; }
  std::size_t node_count() const;
  std::size_t slots() const { return particles.lanes() / kernels::kGroupWidth; }
  kernels::ParticleUpdate update();
  PartInput part_input();

  Particles<2> particles;
  Grid<2> grid;
  std::vector<kernels::MaterialConstants> materials;
  kernels::NodeUpdate<2> node_update;
  std::vector<kernels::NodeSums> node_sums;  // by row

 private:
  std::vector<kernels::ParticleSums> sums_;  // by row
  std::vector<kernels::Reach> reach_;        // by row
};

/// The state that all kernels start from, computed once.
const KernelState& initial_state();

/// Empty where particles and nodes are equal to round-off, else what differs.
std::string difference(KernelState& got, KernelState& expected);
/// The same of columns that a part wrote for all slots of the state.
std::string difference(const KernelState& state, const Column<double>& got,
                       const Column<double>& expected, std::size_t columns);

}  // namespace rgimp::bench
