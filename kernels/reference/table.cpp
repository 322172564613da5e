#include "g2p.hpp"
#include "nodes.hpp"
#include "p2g.hpp"
#include "rgimp/kernels/isa_tables.hpp"
#include "stress.hpp"

namespace rgimp::kernels {

const KernelTable<2> kReferenceKernels2 = {
    reference::scatter_all<2>,     reference::scatter_mass_momentum<2>,
    reference::scatter_force<2>,   reference::scatter_second_momentum<2>,
    reference::update_nodes<2>,    reference::divide_by_mass<2>,
    reference::gather_velocity<2>, reference::gather_position<2>,
    reference::update_stress,
};

}  // namespace rgimp::kernels
