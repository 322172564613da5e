#pragma once

#include <algorithm>
#include <cmath>

#include "rgimp/kernels/views.hpp"

namespace rgimp::kernels::reference {

/// Stress in plane strain, Pa, tension positive; xz = yz = 0.
struct PlaneStress {
  double xx;
  double yy;
  double zz;
  double xy;
};

inline double trace(const PlaneStress& s) {
  return s.xx + s.yy + s.zz;
}

/// Tension first, then shear, on the principal stresses of the whole tensor [Eq. 20, 21].
inline double failure_mode(const PlaneStress& s, const FailureLimits& limits) {
  const double centre = 0.5 * (s.xx + s.yy);
  const double radius = std::sqrt(0.25 * (s.xx - s.yy) * (s.xx - s.yy) + s.xy * s.xy);
  const double major = std::max(centre + radius, s.zz);
  const double minor = std::min(centre - radius, s.zz);
  if (major >= limits.tension + limits.tension_per_trace * trace(s) || trace(s) >= limits.trace) {
    return kFailedInTension;
  }
  if (limits.shear_major * major - limits.shear_minor * minor >= limits.shear) {
    return kFailedInShear;
  }
  return kIntact;
}

/// No deviator; the pressure clamped to what the treatment leaves (section 3.2).
inline PlaneStress failed_stress(const PlaneStress& s, const MaterialConstants& material) {
  const double pressure =
      std::clamp(-trace(s) / 3.0, material.failed_pressure_min, material.failed_pressure_max);
  return {-pressure, -pressure, -pressure, 0.0};
}

/// sigma : C^-1 : sigma / 2, J/m3.
inline double energy_density(const PlaneStress& s, const MaterialConstants& material) {
  const double square = s.xx * s.xx + s.yy * s.yy + s.zz * s.zz + 2.0 * s.xy * s.xy;
  return material.energy_of_square * square - material.energy_of_trace * trace(s) * trace(s);
}

}  // namespace rgimp::kernels::reference
