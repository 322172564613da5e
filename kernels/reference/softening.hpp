#pragma once

#include "failure.hpp"

/// The scalar twin of softening by fracture energy; src/softening.hpp states the law.
namespace rgimp::kernels::reference {

/// Mean stress where it is pressure, else 0.
template <int Dim>
double closed_part(const Stress<Dim>& s) {
  return std::min(trace(s) / 3.0, 0.0);
}

/// sigma = (1 - D) s, but for the pressure, which is carried in full.
template <int Dim>
Stress<Dim> nominal_stress(const Stress<Dim>& s, double damage) {
  const double spared = damage * closed_part(s);
  Stress<Dim> nominal;
  for (int c = 0; c < kStressComponents<Dim>; ++c) {
    nominal.value[c] = (1.0 - damage) * s.value[c] + (c < 3 ? spared : 0.0);
  }
  return nominal;
}

template <int Dim>
Stress<Dim> effective_stress(const Stress<Dim>& nominal, double damage) {
  const double spared = damage * closed_part(nominal);
  Stress<Dim> effective;
  for (int c = 0; c < kStressComponents<Dim>; ++c) {
    effective.value[c] = (nominal.value[c] - (c < 3 ? spared : 0.0)) / (1.0 - damage);
  }
  return effective;
}

/// sigma : C^-1 : s / 2, J/m3.
template <int Dim>
double elastic_energy_density(const Stress<Dim>& s, double damage,
                              const MaterialConstants& material) {
  const double pressure = closed_part(s);
  const double kept = energy_density(Stress<Dim>{{pressure, pressure, pressure}}, material);
  return (1.0 - damage) * (energy_density(s, material) - kept) + kept;
}

/// Width of a band across the major principal stress, in cells.
inline double band_width(const Stress<2>& s, const Principal&) {
  const double difference = s.value[0] - s.value[1];
  const double radius = std::sqrt(0.25 * difference * difference + s.value[3] * s.value[3]);
  const double oblique = radius > 0.0 ? std::abs(s.value[3]) / radius : 0.0;
  return std::sqrt(1.0 + oblique);
}

/// The sum of the sizes of its direction's components, or 1 where no direction is marked.
inline double band_width(const Stress<3>& s, const Principal& principal) {
  const double gaps = (principal.major - principal.middle) * (principal.major - principal.minor);
  if (gaps <= 0.0) {
    return 1.0;
  }
  double width = 0.0;
  for (int a = 0; a < 3; ++a) {
    double projected = 0.0;
    for (int b = 0; b < 3; ++b) {
      const double component = s.value[kStressColumn[a][b]];
      projected += a == b ? (component - principal.middle) * (component - principal.minor)
                          : component * component;
    }
    width += std::sqrt(std::clamp(projected / gaps, 0.0, 1.0));
  }
  return width;
}

/// Damage that the load of a softening point asks for, 0 below its limit.
template <int Dim>
double damage_of(const Stress<Dim>& s, double mode, const MaterialConstants& material) {
  const FailureLimits& limits = material.limits;
  const Principal principal = principal_stresses(s);
  const bool in_tension = mode == kSofteningInTension;
  const double kappa =
      in_tension ? principal.major / limits.tension
                 : (limits.shear_major * principal.major - limits.shear_minor * principal.minor) /
                       limits.shear;
  const double brittleness =
      in_tension ? band_width(s, principal) * material.softening.tension : material.softening.shear;
  if (kappa < 1.0) {
    return 0.0;
  }
  return brittleness < 1.0 ? std::min((1.0 - 1.0 / kappa) / (1.0 - brittleness), 1.0) : 1.0;
}

}  // namespace rgimp::kernels::reference
