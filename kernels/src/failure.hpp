#pragma once

#include "shape.hpp"

namespace rgimp::kernels {
namespace {

/// Stress in plane strain; xz = yz = 0.
struct PlaneStress {
  Batch xx;
  Batch yy;
  Batch zz;
  Batch xy;
};

using Mask = xsimd::batch_bool<double, Batch::arch_type>;

inline Batch trace(const PlaneStress& s) {
  return s.xx + s.yy + s.zz;
}

/// Centre and squared radius of Mohr's circle in the plane.
struct Circle {
  Batch centre;
  Batch radius2;
};

inline Circle circle_of(const PlaneStress& s) {
  const Batch half = Batch(0.5) * (s.xx - s.yy);
  return {Batch(0.5) * (s.xx + s.yy), fused(half, half, s.xy * s.xy)};
}

/// Limits of a material, with what the root-free test divides by.
struct FailureTest {
  explicit FailureTest(const FailureLimits& given)
      : limits(given),
        per_major(1.0 / given.shear_major),
        per_minor(1.0 / given.shear_minor),
        per_both(1.0 / (given.shear_major + given.shear_minor)) {}

  FailureLimits limits;
  double per_major;
  double per_minor;
  double per_both;
};

/// A limit a s1 - b s3 >= c on principal stresses is a bound on the radius r for each pair that can
/// be (s1, s3): centre +- r, or one of them and zz. So r >= bound, the least of the bounds, decides
/// without a root; the two sides may round differently, hence `kNear`: lanes at the limit within
/// it go on to the exact test.
inline Mask may_fail(const PlaneStress& s, const Circle& circle, const FailureTest& test) {
  constexpr double kNear = 1.0 - 1e-9;
  const FailureLimits& l = test.limits;
  const Batch tr = trace(s);
  const Batch tension = fused(Batch(l.tension_per_trace), tr, Batch(l.tension));
  const Batch shear(l.shear);
  const Batch in_plane =
      fused(Batch(l.shear_minor - l.shear_major), circle.centre, shear) * Batch(test.per_both);
  const Batch zz_major =
      fused(Batch(-l.shear_major), s.zz, shear) * Batch(test.per_minor) + circle.centre;
  const Batch zz_minor =
      fused(Batch(l.shear_minor), s.zz, shear) * Batch(test.per_major) - circle.centre;
  const Batch bound =
      xsimd::min(xsimd::min(tension - circle.centre, in_plane), xsimd::min(zz_major, zz_minor)) *
      Batch(kNear);
  return (circle.radius2 >= bound * bound) | (bound <= Batch(0.0)) |
         (s.zz >= tension * Batch(kNear)) | (tr >= Batch(l.trace));
}

/// Tension first, then shear, on the principal stresses of the whole tensor [Eq. 20, 21].
inline Batch failure_mode(const PlaneStress& s, const Circle& circle, const FailureLimits& l) {
  const Batch radius = xsimd::sqrt(circle.radius2);
  const Batch major = xsimd::max(circle.centre + radius, s.zz);
  const Batch minor = xsimd::min(circle.centre - radius, s.zz);
  const Mask tension = (major >= fused(Batch(l.tension_per_trace), trace(s), Batch(l.tension))) |
                       (trace(s) >= Batch(l.trace));
  const Mask shear =
      fused(Batch(l.shear_major), major, Batch(-l.shear_minor) * minor) >= Batch(l.shear);
  return xsimd::select(tension, Batch(kFailedInTension),
                       xsimd::select(shear, Batch(kFailedInShear), Batch(kIntact)));
}

/// No deviator; the pressure clamped to what the treatment leaves (section 3.2).
inline PlaneStress failed_stress(const PlaneStress& s, const MaterialConstants& material) {
  const Batch mean = trace(s) * Batch(1.0 / 3.0);
  const Batch left = xsimd::max(xsimd::min(mean, Batch(-material.failed_pressure_min)),
                                Batch(-material.failed_pressure_max));
  return {left, left, left, Batch(0.0)};
}

/// sigma : C^-1 : sigma / 2, J/m3.
inline Batch energy_density(const PlaneStress& s, const MaterialConstants& material) {
  const Batch square =
      fused(s.xx, s.xx, fused(s.yy, s.yy, fused(s.zz, s.zz, Batch(2.0) * s.xy * s.xy)));
  const Batch tr = trace(s);
  return fused(Batch(material.energy_of_square), square,
               Batch(-material.energy_of_trace) * tr * tr);
}

}  // namespace
}  // namespace rgimp::kernels
