#include "lanes_avx2.hpp"
//
#include "kernels.hpp"
#include "rgimp/kernels/isa_tables.hpp"

namespace rgimp::kernels {

const KernelTable<2> kAvx2Kernels2 = make_table();

}  // namespace rgimp::kernels
