#pragma once

#include "tensor.hpp"

namespace rgimp::kernels::reference {

/// Tension first, then shear, on the principal stresses of the whole tensor [Eq. 20, 21].
template <int Dim>
double failure_mode(const Stress<Dim>& s, const FailureLimits& limits) {
  const Principal principal = principal_stresses(s);
  if (principal.major >= limits.tension + limits.tension_per_trace * trace(s) ||
      trace(s) >= limits.trace) {
    return kFailedInTension;
  }
  if (limits.shear_major * principal.major - limits.shear_minor * principal.minor >= limits.shear) {
    return kFailedInShear;
  }
  return kIntact;
}

/// No deviator; the pressure clamped to what the treatment leaves (section 3.2).
template <int Dim>
Stress<Dim> failed_stress(const Stress<Dim>& s, const MaterialConstants& material) {
  const double pressure =
      std::clamp(-trace(s) / 3.0, material.failed_pressure_min, material.failed_pressure_max);
  return {{-pressure, -pressure, -pressure}};
}

/// sigma : C^-1 : sigma / 2, J/m3.
template <int Dim>
double energy_density(const Stress<Dim>& s, const MaterialConstants& material) {
  return material.energy_of_square * square(s) - material.energy_of_trace * trace(s) * trace(s);
}

}  // namespace rgimp::kernels::reference
