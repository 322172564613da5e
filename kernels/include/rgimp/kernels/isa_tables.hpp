#pragma once

#include "rgimp/kernels/table.hpp"

/// One table per translation unit; a unit compiled for an ISA exports nothing else.
namespace rgimp::kernels {

extern const KernelTable<2> kReferenceKernels2;
extern const KernelTable<2> kBaselineKernels2;
extern const KernelTable<2> kAvx2Kernels2;
extern const KernelTable<2> kAvx512Kernels2;

}  // namespace rgimp::kernels
