#include "nodes.hpp"
#include "pass.hpp"
#include "rgimp/kernels/isa_tables.hpp"

namespace rgimp::kernels {

namespace {

template <int Dim>
constexpr KernelTable<Dim> make_table() {
  return {
      .scatter_all = reference::scatter_all<Dim>,
      .scatter_mass_momentum = reference::scatter_mass_momentum<Dim>,
      .accelerate = reference::accelerate_pass<Dim>,
      .strain_and_move = reference::strain_and_move_pass<Dim>,
      .accelerate_strain_and_move = reference::accelerate_strain_and_move_pass<Dim>,
      .strain = reference::strain_pass<Dim>,
      .accelerate_and_move = reference::accelerate_and_move_pass<Dim>,
      .update_nodes = reference::update_nodes<Dim>,
      .divide_by_mass = reference::divide_by_mass<Dim>,
  };
}

}  // namespace

const KernelTable<2> kReferenceKernels2 = make_table<2>();
const KernelTable<3> kReferenceKernels3 = make_table<3>();

}  // namespace rgimp::kernels
