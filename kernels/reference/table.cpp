#include "nodes.hpp"
#include "pass.hpp"
#include "rgimp/kernels/isa_tables.hpp"

namespace rgimp::kernels {

const KernelTable<2> kReferenceKernels2 = {
    .scatter_all = reference::scatter_all<2>,
    .scatter_mass_momentum = reference::scatter_mass_momentum<2>,
    .accelerate = reference::accelerate_pass<2>,
    .strain_and_move = reference::strain_and_move_pass,
    .accelerate_strain_and_move = reference::accelerate_strain_and_move_pass,
    .strain = reference::strain_pass,
    .accelerate_and_move = reference::accelerate_and_move_pass<2>,
    .update_nodes = reference::update_nodes<2>,
    .divide_by_mass = reference::divide_by_mass<2>,
};

}  // namespace rgimp::kernels
