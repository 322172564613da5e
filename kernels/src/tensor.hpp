#pragma once

#include "places.hpp"

/// Symmetric stresses of a batch of particles and what is asked of them.
namespace rgimp::kernels {
namespace {

template <int Dim>
struct Stress;

/// Plane strain; xz = yz = 0.
template <>
struct Stress<2> {
  Batch xx;
  Batch yy;
  Batch zz;
  Batch xy;
};

template <>
struct Stress<3> {
  Batch xx;
  Batch yy;
  Batch zz;
  Batch xy;
  Batch yz;
  Batch xz;
};

inline Stress<2> load_stress(const ParticleView<2>& p, std::size_t index) {
  return {Batch::load_aligned(p.stress[0] + index), Batch::load_aligned(p.stress[1] + index),
          Batch::load_aligned(p.stress[2] + index), Batch::load_aligned(p.stress[3] + index)};
}

inline Stress<3> load_stress(const ParticleView<3>& p, std::size_t index) {
  return {Batch::load_aligned(p.stress[0] + index), Batch::load_aligned(p.stress[1] + index),
          Batch::load_aligned(p.stress[2] + index), Batch::load_aligned(p.stress[3] + index),
          Batch::load_aligned(p.stress[4] + index), Batch::load_aligned(p.stress[5] + index)};
}

template <int Dim>
inline void store_stress(const ParticleView<Dim>& p, std::size_t index, const Stress<Dim>& s) {
  s.xx.store_aligned(p.stress[0] + index);
  s.yy.store_aligned(p.stress[1] + index);
  s.zz.store_aligned(p.stress[2] + index);
  s.xy.store_aligned(p.stress[3] + index);
  if constexpr (Dim == 3) {
    s.yz.store_aligned(p.stress[4] + index);
    s.xz.store_aligned(p.stress[5] + index);
  }
}

template <int Dim>
inline Batch trace(const Stress<Dim>& s) {
  return s.xx + s.yy + s.zz;
}

inline Stress<2> choose(Mask condition, const Stress<2>& yes, const Stress<2>& no) {
  return {xsimd::select(condition, yes.xx, no.xx), xsimd::select(condition, yes.yy, no.yy),
          xsimd::select(condition, yes.zz, no.zz), xsimd::select(condition, yes.xy, no.xy)};
}

inline Stress<3> choose(Mask condition, const Stress<3>& yes, const Stress<3>& no) {
  return {xsimd::select(condition, yes.xx, no.xx), xsimd::select(condition, yes.yy, no.yy),
          xsimd::select(condition, yes.zz, no.zz), xsimd::select(condition, yes.xy, no.xy),
          xsimd::select(condition, yes.yz, no.yz), xsimd::select(condition, yes.xz, no.xz)};
}

/// factor s + spared I.
inline Stress<2> scaled(const Stress<2>& s, Batch factor, Batch spared) {
  return {fused(factor, s.xx, spared), fused(factor, s.yy, spared), fused(factor, s.zz, spared),
          factor * s.xy};
}

inline Stress<3> scaled(const Stress<3>& s, Batch factor, Batch spared) {
  return {fused(factor, s.xx, spared),
          fused(factor, s.yy, spared),
          fused(factor, s.zz, spared),
          factor * s.xy,
          factor * s.yz,
          factor * s.xz};
}

template <int Dim>
inline Stress<Dim> isotropic(Batch mean) {
  if constexpr (Dim == 2) {
    return {mean, mean, mean, Batch(0.0)};
  } else {
    return {mean, mean, mean, Batch(0.0), Batch(0.0), Batch(0.0)};
  }
}

/// s : s.
inline Batch square(const Stress<2>& s) {
  return fused(s.xx, s.xx, fused(s.yy, s.yy, fused(s.zz, s.zz, Batch(2.0) * s.xy * s.xy)));
}

inline Batch square(const Stress<3>& s) {
  const Batch shear = fused(s.xy, s.xy, fused(s.yz, s.yz, s.xz * s.xz));
  return fused(s.xx, s.xx, fused(s.yy, s.yy, fused(s.zz, s.zz, Batch(2.0) * shear)));
}

/// Principal stresses, of the three-dimensional tensor also in plane strain.
struct Principal {
  Batch major;
  Batch middle;
  Batch minor;
};

/// Centre and squared radius of Mohr's circle in the plane.
struct Circle {
  Batch centre;
  Batch radius2;
};

inline Circle circle_of(const Stress<2>& s) {
  const Batch half = Batch(0.5) * (s.xx - s.yy);
  return {Batch(0.5) * (s.xx + s.yy), fused(half, half, s.xy * s.xy)};
}

inline Principal sorted(Batch a, Batch b, Batch c) {
  const Batch low = xsimd::min(a, b);
  const Batch high = xsimd::max(a, b);
  return {xsimd::max(high, c), xsimd::max(low, xsimd::min(high, c)), xsimd::min(low, c)};
}

inline Principal principal_stresses(const Stress<2>& s) {
  const Circle circle = circle_of(s);
  const Batch radius = xsimd::sqrt(circle.radius2);
  return sorted(circle.centre - radius, circle.centre + radius, s.zz);
}

/// Turns the axes a and b so that `ab` vanishes; `ac` and `bc` are their products with the third.
inline void turn(Batch& aa, Batch& bb, Batch& ab, Batch& ac, Batch& bc) {
  const Batch zero(0.0);
  const Batch one(1.0);
  const Batch difference = bb - aa;
  const Batch twice = Batch(2.0) * ab;
  const Batch size =
      xsimd::abs(difference) + xsimd::sqrt(fused(difference, difference, twice * twice));
  const Mask turns = size > zero;
  const Batch tangent = xsimd::select(turns, twice / xsimd::select(turns, size, one), zero) *
                        xsimd::select(difference < zero, -one, one);
  const Batch cosine = one / xsimd::sqrt(fused(tangent, tangent, one));
  const Batch sine = tangent * cosine;
  aa = fused(-tangent, ab, aa);
  bb = fused(tangent, ab, bb);
  ab = zero;
  const Batch was = ac;
  ac = fused(cosine, was, -sine * bc);
  bc = fused(sine, was, cosine * bc);
}

/// Jacobi's method, which is as exact for equal principal stresses as for any; the roots of the
/// characteristic polynomial lose half the digits there. Four sweeps leave nothing above round-off,
/// and a fixed number makes a lane's result independent of the others'.
inline Principal principal_stresses(const Stress<3>& stress) {
  Stress<3> s = stress;
  for (int sweep = 0; sweep < 4; ++sweep) {
    turn(s.xx, s.yy, s.xy, s.xz, s.yz);
    turn(s.yy, s.zz, s.yz, s.xy, s.xz);
    turn(s.xx, s.zz, s.xz, s.xy, s.yz);
  }
  return sorted(s.xx, s.yy, s.zz);
}

}  // namespace
}  // namespace rgimp::kernels
