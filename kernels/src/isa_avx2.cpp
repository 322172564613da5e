#include "lanes_avx2.hpp"
//
#include "kernels.hpp"
#include "rgimp/kernels/isa_tables.hpp"

namespace rgimp::kernels {

const KernelTable<2> kAvx2Kernels2 = make_table<2>();
const KernelTable<3> kAvx2Kernels3 = make_table<3>();

}  // namespace rgimp::kernels
