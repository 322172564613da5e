#pragma once

#include "g2p.hpp"
#include "nodes.hpp"
#include "p2g.hpp"
#include "rgimp/kernels/table.hpp"
#include "stress.hpp"

/// All kernels of one ISA. Include a lanes_*.hpp first: it says what a Batch is.
namespace rgimp::kernels {
namespace {

constexpr KernelTable<2> make_table() {
  return {.scatter_all = scatter_all<2>,
          .scatter_mass_momentum = scatter_mass_momentum<2>,
          .scatter_force = scatter_force<2>,
          .scatter_second_momentum = scatter_second_momentum<2>,
          .update_nodes = update_nodes<2>,
          .divide_by_mass = divide_by_mass<2>,
          .gather_velocity = gather_velocity<2>,
          .gather_position = gather_position<2>,
          .update_stress = update_stress};
}

}  // namespace
}  // namespace rgimp::kernels
