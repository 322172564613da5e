#pragma once

#include "nodes.hpp"
#include "pass.hpp"
#include "rgimp/kernels/table.hpp"

/// All kernels of one ISA. Include a lanes_*.hpp first: it says what a Batch is.
namespace rgimp::kernels {
namespace {

template <int Dim>
constexpr KernelTable<Dim> make_table() {
  using enum Content;
  constexpr Changes kAccelerate{.velocity = true, .strain = false, .position = false};
  constexpr Changes kStrain{.velocity = false, .strain = true, .position = false};
  constexpr Changes kStrainAndMove{.velocity = false, .strain = true, .position = true};
  constexpr Changes kAccelerateAndMove{.velocity = true, .strain = false, .position = true};
  constexpr Changes kAll{.velocity = true, .strain = true, .position = true};
  return {.scatter_all = scatter_only<Dim, mass_momentum, force>,
          .scatter_mass_momentum = scatter_only<Dim, mass_momentum>,
          .accelerate = pass<Dim, kAccelerate, momentum>,
          .strain_and_move = pass<Dim, kStrainAndMove, mass_momentum, force>,
          .accelerate_strain_and_move = pass<Dim, kAll, mass_momentum, force>,
          .strain = pass<Dim, kStrain, force>,
          .accelerate_and_move = pass<Dim, kAccelerateAndMove, mass_momentum>,
          .update_nodes = update_nodes<Dim>,
          .divide_by_mass = divide_by_mass<Dim>};
}

}  // namespace
}  // namespace rgimp::kernels
