#include "src/lanes_avx512.hpp"
//
#include "kernel_parts_of.hpp"

namespace rgimp::bench {

const KernelParts kAvx512Parts = kernels::make_parts();

}  // namespace rgimp::bench
