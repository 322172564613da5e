#pragma once

#include "tensor.hpp"

namespace rgimp::kernels {
namespace {

/// Lanes this close to a limit go on to the exact test: the two may round differently.
constexpr double kNear = 1.0 - 1e-9;
/// In three dimensions the test without roots is a determinant, which near two equal principal
/// stresses is only good to the root of round-off.
constexpr double kRootOfRoundOff = 1e-7;

template <int Dim>
struct FailureTest;

/// Limits of a material as bounds on the radius r of Mohr's circle about the centre c.
template <>
struct FailureTest<2> {
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
inline Mask may_fail(const Stress<2>& s, const FailureTest<2>& test) {
  const Circle circle = circle_of(s);
  const Batch near(kNear);
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

/// Limits of a material for tests that need no principal stresses.
template <>
struct FailureTest<3> {
  explicit FailureTest(const FailureLimits& l)
      : tension_per_trace(l.tension_per_trace),
        tension(finite(l.tension * (1.0 - kRootOfRoundOff))),
        trace(l.trace),
        shear(finite(l.shear * kNear)),
        shear_per_trace((l.shear_minor - l.shear_major) / 3.0),
        shear_factor(4.0 / 3.0 *
                     (l.shear_major * l.shear_major + l.shear_minor * l.shear_minor +
                      l.shear_major * l.shear_minor)) {}

  /// The fourth power of a limit that is never reached must still be a number.
  static double finite(double limit) { return limit < 1e70 ? limit : 1e70; }

  double tension_per_trace;
  double tension;
  double trace;
  double shear;
  double shear_per_trace;
  double shear_factor;
};

/// Whether t I - s has only positive eigenvalues, so that all of s are below t (Sylvester's
/// criterion): without roots or divisions, and but for round-off exact.
inline Mask all_below(const Stress<3>& s, Batch t) {
  const Batch zero(0.0);
  const Batch x = t - s.xx;
  const Batch y = t - s.yy;
  const Batch z = t - s.zz;
  const Batch xy_minor = fused(x, y, -s.xy * s.xy);
  const Batch cross = fused(x, s.yz, s.xy * s.xz);
  // det times x: (x y - xy^2) (x z - xz^2) - (x yz + xy xz)^2.
  const Batch determinant = fused(xy_minor, fused(x, z, -s.xz * s.xz), -cross * cross);
  return (x > zero) & (xy_minor > zero) & (determinant > zero);
}

/// s1 and s3 about the mean are r cos(theta) and -r cos(pi / 3 - theta) with r^2 = 4/3 J2 and theta
/// from 0 to pi / 3, so a s1 - b s3 <= (a - b) tr s / 3 + r sqrt(a^2 + a b + b^2).
inline Mask may_fail(const Stress<3>& s, const FailureTest<3>& test) {
  const Batch tr = trace(s);
  const Batch tension = fused(Batch(test.tension_per_trace), tr, Batch(test.tension));
  const Batch below = fused(Batch(-kRootOfRoundOff), xsimd::abs(tr), tension);
  const Batch x = s.xx - s.yy;
  const Batch y = s.yy - s.zz;
  const Batch z = s.zz - s.xx;
  const Batch normal = fused(x, x, fused(y, y, z * z));
  const Batch second =
      fused(normal, Batch(1.0 / 6.0), fused(s.xy, s.xy, fused(s.yz, s.yz, s.xz * s.xz)));
  const Batch shear = fused(Batch(test.shear_per_trace), tr, Batch(test.shear));
  return (!all_below(s, below)) | (Batch(test.shear_factor) * second >= shear * xsimd::abs(shear)) |
         (tr >= Batch(test.trace));
}

/// A second look at lanes that may fail, still without principal stresses; in the plane those cost
/// no more.
inline Mask still_may_fail(const Stress<2>&, const FailureLimits&, Mask may_fail) {
  return may_fail;
}

/// Newton's method from above finds x >= s1, so a s1 - b s3 < k where s3 > (a x - k) / b. Under
/// uniaxial compression, s1 = s2, it comes within a sixth of the strength of the limit, where the
/// bound of may_fail is at 0.44: compressed to 0.8 of its strength a block spent 27 % of its time
/// on principal stresses without, 5 % with it.
inline Mask still_may_fail(const Stress<3>& s, const FailureLimits& l, Mask may_fail) {
  const FailureTest<3> test(l);
  const Batch tr = trace(s);
  const Batch mean = tr * Batch(1.0 / 3.0);
  const Batch xx = s.xx - mean;
  const Batch yy = s.yy - mean;
  const Batch zz = s.zz - mean;
  const Batch second = Batch(0.5) * fused(xx, xx, fused(yy, yy, zz * zz)) +
                       fused(s.xy, s.xy, fused(s.yz, s.yz, s.xz * s.xz));
  const Batch third = xx * fused(yy, zz, -s.yz * s.yz) - s.xy * fused(s.xy, zz, -s.yz * s.xz) +
                      s.xz * fused(s.xy, s.yz, -yy * s.xz);
  Batch root = xsimd::sqrt(Batch(4.0 / 3.0) * second);
  for (int step = 0; step < 3; ++step) {
    const Batch slope = fused(Batch(3.0) * root, root, -second);
    const Batch next = fused(Batch(2.0) * root * root, root, third);
    root = xsimd::select(slope > Batch(0.0),
                         next / xsimd::select(slope > Batch(0.0), slope, Batch(1.0)), root);
  }
  const Batch off = Batch(kRootOfRoundOff) * (xsimd::abs(tr) + root);
  const Batch least =
      (Batch(l.shear_major) * (mean + root + off) - Batch(test.shear)) * Batch(1.0 / l.shear_minor);
  const Stress<3> minus = scaled(s, Batch(-1.0), Batch(0.0));
  const Batch tension = fused(Batch(test.tension_per_trace), tr, Batch(test.tension)) - off;
  const Mask safe =
      all_below(s, tension) & all_below(minus, -least - off) & (tr < Batch(test.trace));
  return may_fail & !safe;
}

/// Tension first, then shear, on the principal stresses of the whole tensor [Eq. 20, 21].
inline Batch failure_mode(const Principal& s, Batch trace, const FailureLimits& l) {
  const Mask tension = (s.major >= fused(Batch(l.tension_per_trace), trace, Batch(l.tension))) |
                       (trace >= Batch(l.trace));
  const Mask shear =
      fused(Batch(l.shear_major), s.major, Batch(-l.shear_minor) * s.minor) >= Batch(l.shear);
  return xsimd::select(tension, Batch(kFailedInTension),
                       xsimd::select(shear, Batch(kFailedInShear), Batch(kIntact)));
}

template <int Dim>
inline Batch failure_mode(const Stress<Dim>& s, const FailureLimits& l) {
  return failure_mode(principal_stresses(s), trace(s), l);
}

/// No deviator; the pressure clamped to what the treatment leaves (section 3.2).
template <int Dim>
inline Stress<Dim> failed_stress(const Stress<Dim>& s, const MaterialConstants& material) {
  const Batch mean = trace(s) * Batch(1.0 / 3.0);
  return isotropic<Dim>(xsimd::max(xsimd::min(mean, Batch(-material.failed_pressure_min)),
                                   Batch(-material.failed_pressure_max)));
}

/// sigma : C^-1 : sigma / 2, J/m3.
template <int Dim>
inline Batch energy_density(const Stress<Dim>& s, const MaterialConstants& material) {
  const Batch tr = trace(s);
  return fused(Batch(material.energy_of_square), square(s),
               Batch(-material.energy_of_trace) * tr * tr);
}

}  // namespace
}  // namespace rgimp::kernels
