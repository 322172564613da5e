#include "rgimp/kernels/isa_tables.hpp"

namespace rgimp::kernels {

// Every flag that the unit of an ISA is compiled with.
bool available(Isa isa) {
  switch (isa) {
    case Isa::reference:
    case Isa::baseline:
      return true;
    case Isa::avx2:
      return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
    case Isa::avx512:
      return available(Isa::avx2) && __builtin_cpu_supports("avx512f") &&
             __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512cd") &&
             __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512vl");
  }
  return false;
}

Isa best_isa() {
  Isa best = Isa::baseline;
  for (const Isa isa : kAllIsas) {  // slowest first
    best = available(isa) ? isa : best;
  }
  return best;
}

const char* name(Isa isa) {
  switch (isa) {
    case Isa::reference:
      return "reference";
    case Isa::baseline:
      return "baseline";
    case Isa::avx2:
      return "avx2";
    case Isa::avx512:
      return "avx512";
  }
  return "unknown";
}

template <>
const KernelTable<2>& kernels_for<2>(Isa isa) {
  switch (isa) {
    case Isa::reference:
      return kReferenceKernels2;
    case Isa::baseline:
      return kBaselineKernels2;
    case Isa::avx2:
      return kAvx2Kernels2;
    case Isa::avx512:
      return kAvx512Kernels2;
  }
  return kReferenceKernels2;
}

template <>
const KernelTable<3>& kernels_for<3>(Isa isa) {
  switch (isa) {
    case Isa::reference:
      return kReferenceKernels3;
    case Isa::baseline:
      return kBaselineKernels3;
    case Isa::avx2:
      return kAvx2Kernels3;
    case Isa::avx512:
      return kAvx512Kernels3;
  }
  return kReferenceKernels3;
}

}  // namespace rgimp::kernels
