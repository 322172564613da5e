#pragma once

#include <xsimd/xsimd.hpp>

namespace rgimp::kernels {
namespace {

using Batch = xsimd::batch<double, xsimd::fma3<xsimd::avx2>>;

/// a b + c, rounded once.
inline Batch fused(Batch a, Batch b, Batch c) {
  return _mm256_fmadd_pd(a, b, c);
}

/// The last lane of `before`, then all but the last of `here`.
inline Batch shift_up(Batch before, Batch here) {
  const __m256d middle = _mm256_permute2f128_pd(before, here, 0x21);
  return _mm256_shuffle_pd(middle, here, 0b0101);
}

/// All but the first lane of `here`, then the first of `after`.
inline Batch shift_down(Batch here, Batch after) {
  const __m256d middle = _mm256_permute2f128_pd(here, after, 0x21);
  return _mm256_shuffle_pd(here, middle, 0b0101);
}

inline double first_lane(Batch values) {
  return _mm256_cvtsd_f64(values);
}

}  // namespace
}  // namespace rgimp::kernels
