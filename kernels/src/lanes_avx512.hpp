#pragma once

#include <xsimd/xsimd.hpp>

namespace rgimp::kernels {
namespace {

using Batch = xsimd::batch<double, xsimd::avx512dq>;

/// a b + c, rounded once. xsimd 8.1 has no AVX-512 kernel for it and would round twice.
inline Batch fused(Batch a, Batch b, Batch c) {
  return _mm512_fmadd_pd(a, b, c);
}

/// The last lane of `before`, then all but the last of `here`.
inline Batch shift_up(Batch before, Batch here) {
  return _mm512_castsi512_pd(
      _mm512_alignr_epi64(_mm512_castpd_si512(here), _mm512_castpd_si512(before), 7));
}

/// All but the first lane of `here`, then the first of `after`.
inline Batch shift_down(Batch here, Batch after) {
  return _mm512_castsi512_pd(
      _mm512_alignr_epi64(_mm512_castpd_si512(after), _mm512_castpd_si512(here), 1));
}

inline double first_lane(Batch values) {
  return _mm512_cvtsd_f64(values);
}

}  // namespace
}  // namespace rgimp::kernels
