#include "lanes_baseline.hpp"
//
#include "kernels.hpp"
#include "rgimp/kernels/isa_tables.hpp"

namespace rgimp::kernels {

const KernelTable<2> kBaselineKernels2 = make_table<2>();
const KernelTable<3> kBaselineKernels3 = make_table<3>();

}  // namespace rgimp::kernels
