#pragma once

#include "failure.hpp"

/// The scalar twin of softening by fracture energy; src/softening.hpp states the law.
namespace rgimp::kernels::reference {

/// Mean stress where it is pressure, else 0.
inline double closed_part(const PlaneStress& s) {
  return std::min(trace(s) / 3.0, 0.0);
}

/// sigma = (1 - D) s, but for the pressure, which is carried in full.
inline PlaneStress nominal_stress(const PlaneStress& s, double damage) {
  const double spared = damage * closed_part(s);
  return {(1.0 - damage) * s.xx + spared, (1.0 - damage) * s.yy + spared,
          (1.0 - damage) * s.zz + spared, (1.0 - damage) * s.xy};
}

inline PlaneStress effective_stress(const PlaneStress& nominal, double damage) {
  const double spared = damage * closed_part(nominal);
  return {(nominal.xx - spared) / (1.0 - damage), (nominal.yy - spared) / (1.0 - damage),
          (nominal.zz - spared) / (1.0 - damage), nominal.xy / (1.0 - damage)};
}

/// sigma : C^-1 : s / 2, J/m3.
inline double elastic_energy_density(const PlaneStress& s, double damage,
                                     const MaterialConstants& material) {
  const double pressure = closed_part(s);
  const double kept = energy_density({pressure, pressure, pressure, 0.0}, material);
  return (1.0 - damage) * (energy_density(s, material) - kept) + kept;
}

/// Damage that the load of a softening point asks for, 0 below its limit.
inline double damage_of(const PlaneStress& s, double mode, const MaterialConstants& material) {
  const FailureLimits& limits = material.limits;
  const double radius = std::sqrt(0.25 * (s.xx - s.yy) * (s.xx - s.yy) + s.xy * s.xy);
  const double major = std::max(0.5 * (s.xx + s.yy) + radius, s.zz);
  const double minor = std::min(0.5 * (s.xx + s.yy) - radius, s.zz);
  const bool in_tension = mode == kSofteningInTension;
  const double kappa =
      in_tension ? major / limits.tension
                 : (limits.shear_major * major - limits.shear_minor * minor) / limits.shear;
  const double oblique = radius > 0.0 ? std::abs(s.xy) / radius : 0.0;
  const double brittleness =
      in_tension ? std::sqrt(1.0 + oblique) * material.softening.tension : material.softening.shear;
  if (kappa < 1.0) {
    return 0.0;
  }
  return brittleness < 1.0 ? std::min((1.0 - 1.0 / kappa) / (1.0 - brittleness), 1.0) : 1.0;
}

}  // namespace rgimp::kernels::reference
