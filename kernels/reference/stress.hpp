#pragma once

#include "failure.hpp"
#include "g2p.hpp"
#include "softening.hpp"

namespace rgimp::kernels::reference {

/// Strain and rotation of a step.
template <int Dim>
struct Increment;

template <>
struct Increment<2> {
  double xx;        ///< 1
  double yy;        ///< 1
  double xy;        ///< 1, engineering shear
  double rotation;  ///< rad, dt (dvx/dy - dvy/dx) / 2
};

template <>
struct Increment<3> {
  double strain[3][3];    ///< 1, D dt
  double rotation[3][3];  ///< rad, W dt
};

inline Increment<2> increment_of(const Gradient<2>& velocity, double dt) {
  const auto& g = velocity.value;
  return {dt * g[0][0], dt * g[1][1], dt * (g[0][1] + g[1][0]), 0.5 * dt * (g[0][1] - g[1][0])};
}

inline Increment<3> increment_of(const Gradient<3>& velocity, double dt) {
  Increment<3> e;
  for (int a = 0; a < 3; ++a) {
    for (int b = 0; b < 3; ++b) {
      e.strain[a][b] = 0.5 * dt * (velocity.value[a][b] + velocity.value[b][a]);
      e.rotation[a][b] = 0.5 * dt * (velocity.value[a][b] - velocity.value[b][a]);
    }
  }
  return e;
}

inline double trace(const Increment<2>& e) {
  return e.xx + e.yy;
}

inline double trace(const Increment<3>& e) {
  return e.strain[0][0] + e.strain[1][1] + e.strain[2][2];
}

/// Hooke's law in plane strain with the Jaumann rate, sigma += C : D dt + W sigma - sigma W.
inline Stress<2> elastic_stress(const Stress<2>& s, const Increment<2>& e,
                                const MaterialConstants& material) {
  const double volumetric = material.lambda * trace(e);
  const double shear = material.shear_modulus;
  const double turned = 2.0 * e.rotation * s.value[3];
  return {{s.value[0] + volumetric + 2.0 * shear * e.xx + turned,
           s.value[1] + volumetric + 2.0 * shear * e.yy - turned, s.value[2] + volumetric,
           s.value[3] + shear * e.xy + e.rotation * (s.value[1] - s.value[0])}};
}

/// The same in three dimensions.
inline Stress<3> elastic_stress(const Stress<3>& s, const Increment<3>& e,
                                const MaterialConstants& material) {
  Stress<3> result = s;
  for (int a = 0; a < 3; ++a) {
    for (int b = a; b < 3; ++b) {
      double& component = result.value[kStressColumn[a][b]];
      component += 2.0 * material.shear_modulus * e.strain[a][b];
      component += a == b ? material.lambda * trace(e) : 0.0;
      for (int k = 0; k < 3; ++k) {
        component += e.rotation[a][k] * s.value[kStressColumn[k][b]] -
                     s.value[kStressColumn[a][k]] * e.rotation[k][b];
      }
    }
  }
  return result;
}

/// Half the work of the dropped stress on the step's strain, J/m3: the stress rose to its trial
/// value during the step, so this part was never put in.
inline double half_work(const Stress<2>& s, const Stress<2>& left, const Increment<2>& e) {
  return 0.5 * ((s.value[0] - left.value[0]) * e.xx + (s.value[1] - left.value[1]) * e.yy +
                (s.value[3] - left.value[3]) * e.xy);
}

inline double half_work(const Stress<3>& s, const Stress<3>& left, const Increment<3>& e) {
  double work = 0.0;
  for (int a = 0; a < 3; ++a) {
    for (int b = 0; b < 3; ++b) {
      const int c = kStressColumn[a][b];
      work += 0.5 * (s.value[c] - left.value[c]) * e.strain[a][b];
    }
  }
  return work;
}

/// Volume and bulk viscosity: q V = m (c0 L^2 (tr D)^2 + c1 L c |tr D|) in compression.
template <int Dim>
void update_volume(const ParticleView<Dim>& particles, std::size_t p, double trace, double dt,
                   const MaterialConstants& material) {
  const double closing = std::min(trace, 0.0) / dt;
  particles.viscous_energy[p] =
      particles.mass[p] * closing *
      (material.quadratic_viscosity * closing - material.linear_viscosity);
  particles.volume[p] += particles.volume[p] * trace;
}

/// The point's failure mode, from now on; `mode` is one of the two failed ones.
template <int Dim>
void note_failure(const ParticleView<Dim>& particles, std::size_t p, double mode, std::int32_t step,
                  ParticleSums& sums) {
  particles.failure_mode[p] = mode;
  particles.failure_step[p] = step;
  sums.failed_tension += mode == kFailedInTension ? 1 : 0;
  sums.failed_shear += mode == kFailedInShear ? 1 : 0;
}

/// The stress left to a point of a material that fails at once.
template <int Dim>
Stress<Dim> fail(const ParticleView<Dim>& particles, std::size_t p, const Stress<Dim>& stress,
                 const Increment<Dim>& increment, const MaterialConstants& material,
                 std::int32_t step, ParticleSums& sums) {
  if (particles.failure_mode[p] == kIntact) {
    const double mode = failure_mode(stress, material.limits);
    if (mode == kIntact) {
      return stress;
    }
    note_failure(particles, p, mode, step, sums);
  }
  const Stress<Dim> left = failed_stress(stress, material);
  sums.released_energy +=
      particles.volume[p] * (energy_density(stress, material) - energy_density(left, material) -
                             half_work(stress, left, increment));
  return left;
}

/// The stress left to a point of a material that softens, one that has not failed yet; `before` is
/// its stress at the start of the step.
template <int Dim>
Stress<Dim> soften(const ParticleView<Dim>& particles, std::size_t p, const Stress<Dim>& before,
                   const Increment<Dim>& increment, const MaterialConstants& material,
                   std::int32_t step, ParticleSums& sums) {
  double& mode = particles.failure_mode[p];
  double& damage = particles.damage[p];
  const double old_damage = damage;
  const Stress<Dim> s = elastic_stress(effective_stress(before, damage), increment, material);
  if (mode == kIntact) {
    const double onset = failure_mode(s, material.limits);
    if (onset == kIntact) {
      return s;
    }
    mode = onset == kFailedInTension ? kSofteningInTension : kSofteningInShear;
  }
  damage = std::max(damage, damage_of(s, mode, material));
  Stress<Dim> left = nominal_stress(s, damage);
  double energy_left = elastic_energy_density(s, damage, material);
  if (damage >= 1.0) {
    note_failure(particles, p, mode == kSofteningInTension ? kFailedInTension : kFailedInShear,
                 step, sums);
    left = failed_stress(left, material);
    energy_left = energy_density(left, material);
  }
  sums.released_energy +=
      particles.volume[p] * (elastic_energy_density(s, old_damage, material) - energy_left -
                             half_work(nominal_stress(s, old_damage), left, increment));
  return left;
}

template <int Dim>
void update_particle(const ParticleView<Dim>& particles, std::size_t p,
                     const Gradient<Dim>& gradient, const MaterialConstants& material, double dt,
                     std::int32_t step, ParticleSums& sums) {
  const Increment<Dim> increment = increment_of(gradient, dt);
  sums.viscous_work -= particles.viscous_energy[p] * trace(increment);
  update_volume(particles, p, trace(increment), dt, material);

  const Stress<Dim> before = load_stress(particles, p);
  const bool may_soften = material.softens && particles.failure_mode[p] < kFailedInTension;
  store_stress(particles, p,
               may_soften ? soften(particles, p, before, increment, material, step, sums)
                          : fail(particles, p, elastic_stress(before, increment, material),
                                 increment, material, step, sums));
}

}  // namespace rgimp::kernels::reference
