#include "lanes_avx512.hpp"
//
#include "kernels.hpp"
#include "rgimp/kernels/isa_tables.hpp"

namespace rgimp::kernels {

const KernelTable<2> kAvx512Kernels2 = make_table<2>();
const KernelTable<3> kAvx512Kernels3 = make_table<3>();

}  // namespace rgimp::kernels
