#include "src/lanes_avx2.hpp"
//
#include "kernel_parts_of.hpp"

namespace rgimp::bench {

const KernelParts kAvx2Parts = kernels::make_parts();

}  // namespace rgimp::bench
