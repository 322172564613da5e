#pragma once

#include "tensor.hpp"

namespace rgimp::kernels::reference {

/// Whether the second invariant alone tells that no limit is reached: about the mean, principal
/// stresses are at most r = sqrt(4/3 J2), and a s1 - b s3 at most r sqrt(a^2 + a b + b^2). Without
/// it, finding principal stresses took more than half of a step. In the plane they are cheap.
inline bool is_far_from_failure(const Stress<3>& s, const FailureLimits& limits) {
  const double mean = trace(s) / 3.0;
  const double radius = std::sqrt(std::max(2.0 / 3.0 * (square(s) - 3.0 * mean * mean), 0.0));
  const double a = limits.shear_major;
  const double b = limits.shear_minor;
  constexpr double kRoundOff = 1e-9;
  const double margin = kRoundOff * (std::abs(mean) + radius);
  return mean + radius + margin < limits.tension + limits.tension_per_trace * trace(s) &&
         trace(s) < limits.trace &&
         (a - b) * mean + (radius + margin) * std::sqrt(a * a + a * b + b * b) < limits.shear;
}

inline bool is_far_from_failure(const Stress<2>&, const FailureLimits&) {
  return false;
}

/// Tension first, then shear, on the principal stresses of the whole tensor [Eq. 20, 21].
template <int Dim>
double failure_mode(const Stress<Dim>& s, const FailureLimits& limits) {
  if (is_far_from_failure(s, limits)) {
    return kIntact;
  }
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
