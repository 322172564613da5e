#include "lanes_baseline.hpp"
//
#include "kernels.hpp"
#include "rgimp/kernels/isa_tables.hpp"

namespace rgimp::kernels {

const KernelTable<2> kBaselineKernels2 = make_table();

}  // namespace rgimp::kernels
