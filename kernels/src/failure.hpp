#pragma once

#include "places.hpp"

namespace rgimp::kernels {
namespace {

/// Stress in plane strain; xz = yz = 0.
struct PlaneStress {
  Batch xx;
  Batch yy;
  Batch zz;
  Batch xy;
};

inline Batch trace(const PlaneStress& s) {
  return s.xx + s.yy + s.zz;
}

inline PlaneStress choose(Mask condition, const PlaneStress& yes, const PlaneStress& no) {
  return {xsimd::select(condition, yes.xx, no.xx), xsimd::select(condition, yes.yy, no.yy),
          xsimd::select(condition, yes.zz, no.zz), xsimd::select(condition, yes.xy, no.xy)};
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

/// Limits of a material as bounds on the radius r of Mohr's circle about the centre c.
struct FailureTest {
  explicit FailureTest(const FailureLimits& l)
      : tension_per_trace(l.tension_per_trace * kNear),
        tension(l.tension * kNear),
        trace(l.trace),
        in_plane_slope((l.shear_minor - l.shear_major) / (l.shear_major + l.shear_minor) * kNear),
        in_plane(l.shear / (l.shear_major + l.shear_minor) * kNear),
        zz_major_slope(-l.shear_major / l.shear_minor * kNear),
        zz_major(l.shear / l.shear_minor * kNear),
        zz_minor_slope(l.shear_minor / l.shear_major * kNear),
        zz_minor(l.shear / l.shear_major * kNear) {}

  /// Lanes this close to a limit go on to the exact test: the two may round differently.
  static constexpr double kNear = 1.0 - 1e-9;

  double tension_per_trace;
  double tension;
  double trace;
  double in_plane_slope;
  double in_plane;
  double zz_major_slope;
  double zz_major;
  double zz_minor_slope;
  double zz_minor;
};

/// A limit a s1 - b s3 >= k on principal stresses is a bound on the radius r for each pair that can
/// be (s1, s3): c +- r, or one of them and zz. So r >= bound, the least of the bounds, decides
/// without a root; r^2 >= bound |bound| also where the bound is negative.
inline Mask may_fail(const PlaneStress& s, const Circle& circle, const FailureTest& test) {
  const Batch near(FailureTest::kNear);
  const Batch tr = trace(s);
  const Batch centre = circle.centre * near;
  const Batch tension = fused(Batch(test.tension_per_trace), tr, Batch(test.tension));
  const Batch in_plane = fused(Batch(test.in_plane_slope), circle.centre, Batch(test.in_plane));
  const Batch zz_major = fused(Batch(test.zz_major_slope), s.zz, Batch(test.zz_major)) + centre;
  const Batch zz_minor = fused(Batch(test.zz_minor_slope), s.zz, Batch(test.zz_minor)) - centre;
  const Batch bound =
      xsimd::min(xsimd::min(tension - centre, in_plane), xsimd::min(zz_major, zz_minor));
  return (circle.radius2 >= bound * xsimd::abs(bound)) | (s.zz >= tension) |
         (tr >= Batch(test.trace));
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
