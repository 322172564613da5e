#include "src/lanes_baseline.hpp"
//
#include "kernel_parts_of.hpp"

namespace rgimp::bench {

const KernelParts kBaselineParts = kernels::make_parts();

}  // namespace rgimp::bench
