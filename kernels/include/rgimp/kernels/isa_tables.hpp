#pragma once

#include "rgimp/kernels/table.hpp"

/// One table per translation unit; a unit compiled for an ISA exports nothing else.
namespace rgimp::kernels {

extern const KernelTable<2> kReferenceKernels2;
extern const KernelTable<2> kBaselineKernels2;
extern const KernelTable<2> kAvx2Kernels2;
extern const KernelTable<2> kAvx512Kernels2;
extern const KernelTable<3> kReferenceKernels3;
extern const KernelTable<3> kBaselineKernels3;
extern const KernelTable<3> kAvx2Kernels3;
extern const KernelTable<3> kAvx512Kernels3;

}  // namespace rgimp::kernels
