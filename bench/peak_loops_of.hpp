#pragma once

#include <xsimd/xsimd.hpp>

#include "peak_loops.hpp"

// All internal to the unit that includes it: units compiled for different ISAs must share no code.
namespace rgimp::bench {
namespace {

/// More than a core has in flight (latency times issue width: 8 for fused multiply-adds, 12 for
/// separate ones on Zen); with the two constants they fill the 16 registers of the baseline.
constexpr int kChains = 14;

template <typename Batch>
double fma_chains(std::int64_t rounds) {
  const Batch factor(0.999);
  const Batch summand(1e-3);  // towards 1: nothing overflows, nothing gets tiny
  Batch chain[kChains];
  for (int i = 0; i < kChains; ++i) {
    chain[i] = Batch(static_cast<double>(rounds + i));  // no value the compiler could fold
  }
  for (std::int64_t round = 0; round < rounds; ++round) {
#pragma GCC unroll 14
    for (int i = 0; i < kChains; ++i) {
      chain[i] = chain[i] * factor + summand;  // contracted where the ISA can
    }
  }
  Batch sum(0.0);
  for (const Batch& one : chain) {
    sum += one;
  }
  return xsimd::hadd(sum);
}

void triad(double* __restrict a, const double* __restrict b, const double* __restrict c,
           std::ptrdiff_t first, std::ptrdiff_t last) {
  for (std::ptrdiff_t i = first; i < last; ++i) {
    a[i] = b[i] + 3.0 * c[i];
  }
}

template <typename Batch>
constexpr PeakLoops loops_of() {
  return {fma_chains<Batch>, 2.0 * kChains * Batch::size, triad};
}

}  // namespace
}  // namespace rgimp::bench
