#pragma once

#include <cstddef>
#include <cstdint>

namespace rgimp::bench {

/// The two loops that peaks are measured with, compiled once per ISA.
struct PeakLoops {
  /// Rounds of multiply-adds in registers; the sum of the chains.
  double (*fma)(std::int64_t rounds);
  double flops_per_round;
  /// a = b + 3 c, from `first` to one before `last`.
  void (*triad)(double* a, const double* b, const double* c, std::ptrdiff_t first,
                std::ptrdiff_t last);
};

extern const PeakLoops kBaselineLoops;
extern const PeakLoops kAvx2Loops;
extern const PeakLoops kAvx512Loops;

}  // namespace rgimp::bench
