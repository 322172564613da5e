#pragma once

#include "failure.hpp"

/// Softening by fracture energy: a crack band (Bazant & Oh, Crack band theory for fracture of
/// concrete, Materials and Structures 16, 1983) as scalar damage D of the effective stress s, the
/// stress that the material would carry unharmed. Our extension; the paper has none.
///
///   nominal stress   sigma = (1 - D) dev s + (tr s > 0 ? 1 - D : 1) tr s / 3 I
///   load             kappa = s1 / sigma_t in tension, Mohr-Coulomb's or Tresca's stress over its
///                    limit in shear; the mode is that of the onset
///   damage           D = max(D, (1 - 1 / kappa) / (1 - 1 / eta)): linear softening; D = 1: failed
///   dissipation      eta = 2 (lambda + 2 mu) G_f / (sigma_t^2 h), in shear 2 mu G_II / (c^2 h),
///                    so that the area under the curve times the band's width h is that energy
///
/// The width h of a band of cells whose normal is n is what a cell of size L covers along n,
/// h = L sum |n_i|. In the plane, n the direction of s1, (|n_x| + |n_y|)^2 = 1 + |sin 2 theta| with
/// |sin 2 theta| = |s_xy| / r, r the radius of Mohr's circle. In three dimensions the projection
/// onto that direction, P = (s - s2 I)(s - s3 I) / ((s1 - s2)(s1 - s3)) = n n^T, gives
/// |n_i| = sqrt(P_ii), so h = L (sqrt(P_xx) + sqrt(P_yy) + sqrt(P_zz)), at most sqrt(3) L; where
/// s1 = s2 no direction is marked and h = L, as here where r = 0. A band in shear runs along
/// neither principal direction: h = L. In plane strain a tensile s1 lies in the plane, as
/// s_zz = nu (s_xx + s_yy).
///
/// Particles hold the nominal stress, from which s is recovered, so that everything else that reads
/// stresses need not know of damage.
namespace rgimp::kernels {
namespace {

/// Mean stress where it is pressure, else 0.
template <int Dim>
inline Batch closed_part(const Stress<Dim>& s) {
  return xsimd::min(trace(s) * Batch(1.0 / 3.0), Batch(0.0));
}

template <int Dim>
inline Stress<Dim> nominal_stress(const Stress<Dim>& effective, Batch damage) {
  return scaled(effective, Batch(1.0) - damage, damage * closed_part(effective));
}

template <int Dim>
inline Stress<Dim> effective_stress(const Stress<Dim>& nominal, Batch damage) {
  const Batch factor = Batch(1.0) / (Batch(1.0) - damage);
  return scaled(nominal, factor, (Batch(1.0) - factor) * closed_part(nominal));
}

/// What the point gives back when it is unloaded, sigma : C^-1 : s / 2, J/m3.
template <int Dim>
inline Batch elastic_energy_density(const Stress<Dim>& effective, Batch damage,
                                    const MaterialConstants& material) {
  const Batch pressure = closed_part(effective);
  const Batch kept =
      Batch(3.0 * material.energy_of_square - 9.0 * material.energy_of_trace) * pressure * pressure;
  return fused(Batch(1.0) - damage, energy_density(effective, material) - kept, kept);
}

/// Width of a band across the major principal stress, in cells.
inline Batch band_width(const Stress<2>& s, const Principal&) {
  const Batch radius = xsimd::sqrt(circle_of(s).radius2);
  const Batch oblique =
      xsimd::abs(s.xy) / xsimd::max(radius, Batch(__DBL_MIN__));  // 0 where there is no circle
  return xsimd::sqrt(Batch(1.0) + oblique);
}

/// P_ii (s1 - s2) (s1 - s3): row i of s - s2 I times column i of s - s3 I.
inline Batch projection(Batch diagonal, Batch next, Batch other, const Principal& principal) {
  return fused(diagonal - principal.middle, diagonal - principal.minor,
               fused(next, next, other * other));
}

inline Batch band_width(const Stress<3>& s, const Principal& principal) {
  const Batch zero(0.0);
  const Batch one(1.0);
  const Batch gaps = (principal.major - principal.middle) * (principal.major - principal.minor);
  const Mask is_marked = gaps > zero;
  const Batch per_gaps = one / xsimd::select(is_marked, gaps, one);
  const auto component = [&](Batch projected) {
    return xsimd::sqrt(xsimd::min(xsimd::max(projected * per_gaps, zero), one));
  };
  const Batch width = component(projection(s.xx, s.xy, s.xz, principal)) +
                      component(projection(s.yy, s.xy, s.yz, principal)) +
                      component(projection(s.zz, s.xz, s.yz, principal));
  return xsimd::select(is_marked, width, one);
}

/// What a batch of lanes has become.
struct Softened {
  Batch mode;
  Batch damage;
};

/// `mode` and `damage` are those before; lanes that have failed stay as they are.
template <int Dim>
inline Softened grow_damage(const Stress<Dim>& s, Batch mode, Batch damage,
                            const MaterialConstants& material) {
  const FailureLimits& l = material.limits;
  const Principal principal = principal_stresses(s);
  const Batch onset = failure_mode(principal, trace(s), l);
  const Mask was_intact = mode == Batch(kIntact);
  const Mask in_tension =
      (mode == Batch(kSofteningInTension)) | (was_intact & (onset == Batch(kFailedInTension)));
  const Mask in_shear =
      (mode == Batch(kSofteningInShear)) | (was_intact & (onset == Batch(kFailedInShear)));

  const Batch sheared =
      fused(Batch(l.shear_major), principal.major, Batch(-l.shear_minor) * principal.minor);
  const Batch load = xsimd::select(in_tension, principal.major, sheared);
  const Batch limit = xsimd::select(in_tension, Batch(l.tension), Batch(l.shear));
  const Batch brittleness =
      xsimd::select(in_tension, band_width(s, principal) * Batch(material.softening.tension),
                    Batch(material.softening.shear));
  const Mask grows = (in_tension | in_shear) & (load >= limit);
  const Mask gradual = brittleness < Batch(1.0);
  // Lanes whose result is not taken divide by 1: tests trap divisions by zero.
  const Batch left = Batch(1.0) - limit / xsimd::select(grows, load, Batch(1.0));
  const Batch grown =
      xsimd::min(left / xsimd::select(gradual, Batch(1.0) - brittleness, Batch(1.0)), Batch(1.0));
  const Batch reached = xsimd::select(gradual, grown, Batch(1.0));
  const Batch now = xsimd::select(grows, xsimd::max(damage, reached), damage);

  const Mask fails = now >= Batch(1.0);
  const Batch tension_mode =
      xsimd::select(fails, Batch(kFailedInTension), Batch(kSofteningInTension));
  const Batch shear_mode = xsimd::select(fails, Batch(kFailedInShear), Batch(kSofteningInShear));
  return {xsimd::select(in_tension, tension_mode, xsimd::select(in_shear, shear_mode, mode)), now};
}

}  // namespace
}  // namespace rgimp::kernels
