#pragma once

#include <xsimd/xsimd.hpp>

namespace rgimp::kernels {
namespace {

using Batch = xsimd::batch<double, xsimd::sse2>;

/// a b + c, rounded once where the ISA can; every other operation is rounded on its own.
inline Batch fused(Batch a, Batch b, Batch c) {
  return a * b + c;
}

/// The last lane of `before`, then all but the last of `here`.
inline Batch shift_up(Batch before, Batch here) {
  return _mm_shuffle_pd(before, here, 0b01);
}

/// All but the first lane of `here`, then the first of `after`.
inline Batch shift_down(Batch here, Batch after) {
  return _mm_shuffle_pd(here, after, 0b01);
}

inline double first_lane(Batch values) {
  return _mm_cvtsd_f64(values);
}

}  // namespace
}  // namespace rgimp::kernels
