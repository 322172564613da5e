#pragma once

#include "failure.hpp"
#include "g2p.hpp"
#include "softening.hpp"

namespace rgimp::kernels::reference {

/// Strain and rotation of a step in the plane.
struct PlaneIncrement {
  double xx;        ///< 1
  double yy;        ///< 1
  double xy;        ///< 1, engineering shear
  double rotation;  ///< rad, dt (dvx/dy - dvy/dx) / 2
};

inline PlaneIncrement plane_increment(const Gradient<2>& velocity, double dt) {
  const auto& g = velocity.value;
  return {dt * g[0][0], dt * g[1][1], dt * (g[0][1] + g[1][0]), 0.5 * dt * (g[0][1] - g[1][0])};
}

/// Hooke's law in plane strain with the Jaumann rate, sigma += C : D dt + W sigma - sigma W.
inline PlaneStress elastic_stress(const PlaneStress& s, const PlaneIncrement& e,
                                  const MaterialConstants& material) {
  const double volumetric = material.lambda * (e.xx + e.yy);
  const double shear = material.shear_modulus;
  const double turned = 2.0 * e.rotation * s.xy;
  return {s.xx + volumetric + 2.0 * shear * e.xx + turned,
          s.yy + volumetric + 2.0 * shear * e.yy - turned, s.zz + volumetric,
          s.xy + shear * e.xy + e.rotation * (s.yy - s.xx)};
}

/// Half the work of the dropped stress on the step's strain, J/m3: the stress rose to its trial
/// value during the step, so this part was never put in.
inline double half_work(const PlaneStress& s, const PlaneStress& left, const PlaneIncrement& e) {
  return 0.5 * ((s.xx - left.xx) * e.xx + (s.yy - left.yy) * e.yy + (s.xy - left.xy) * e.xy);
}

/// Volume and bulk viscosity: q V = m (c0 L^2 (tr D)^2 + c1 L c |tr D|) in compression.
inline void update_volume(const ParticleView<2>& particles, std::size_t p, double trace, double dt,
                          const MaterialConstants& material) {
  const double closing = std::min(trace, 0.0) / dt;
  particles.viscous_energy[p] =
      particles.mass[p] * closing *
      (material.quadratic_viscosity * closing - material.linear_viscosity);
  particles.volume[p] += particles.volume[p] * trace;
}

/// The point's failure mode, from now on; `mode` is one of the two failed ones.
inline void note_failure(const ParticleView<2>& particles, std::size_t p, double mode,
                         std::int32_t step, ParticleSums& sums) {
  particles.failure_mode[p] = mode;
  particles.failure_step[p] = step;
  sums.failed_tension += mode == kFailedInTension ? 1 : 0;
  sums.failed_shear += mode == kFailedInShear ? 1 : 0;
}

/// The stress left to a point of a material that fails at once.
inline PlaneStress fail(const ParticleView<2>& particles, std::size_t p, const PlaneStress& stress,
                        const PlaneIncrement& increment, const MaterialConstants& material,
                        std::int32_t step, ParticleSums& sums) {
  if (particles.failure_mode[p] == kIntact) {
    const double mode = failure_mode(stress, material.limits);
    if (mode == kIntact) {
      return stress;
    }
    note_failure(particles, p, mode, step, sums);
  }
  const PlaneStress left = failed_stress(stress, material);
  sums.released_energy +=
      particles.volume[p] * (energy_density(stress, material) - energy_density(left, material) -
                             half_work(stress, left, increment));
  return left;
}

/// The stress left to a point of a material that softens, one that has not failed yet; `before` is
/// its stress at the start of the step.
inline PlaneStress soften(const ParticleView<2>& particles, std::size_t p,
                          const PlaneStress& before, const PlaneIncrement& increment,
                          const MaterialConstants& material, std::int32_t step,
                          ParticleSums& sums) {
  double& mode = particles.failure_mode[p];
  double& damage = particles.damage[p];
  const double old_damage = damage;
  const PlaneStress s = elastic_stress(effective_stress(before, damage), increment, material);
  if (mode == kIntact) {
    const double onset = failure_mode(s, material.limits);
    if (onset == kIntact) {
      return s;
    }
    mode = onset == kFailedInTension ? kSofteningInTension : kSofteningInShear;
  }
  damage = std::max(damage, damage_of(s, mode, material));
  PlaneStress left = nominal_stress(s, damage);
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

inline void update_particle(const ParticleView<2>& particles, std::size_t p,
                            const Gradient<2>& gradient, const MaterialConstants& material,
                            double dt, std::int32_t step, ParticleSums& sums) {
  const PlaneIncrement increment = plane_increment(gradient, dt);
  const double trace = increment.xx + increment.yy;
  sums.viscous_work -= particles.viscous_energy[p] * trace;
  update_volume(particles, p, trace, dt, material);

  const PlaneStress before = {particles.stress[0][p], particles.stress[1][p],
                              particles.stress[2][p], particles.stress[3][p]};
  const bool may_soften = material.softens && particles.failure_mode[p] < kFailedInTension;
  const PlaneStress stress = may_soften
                                 ? soften(particles, p, before, increment, material, step, sums)
                                 : fail(particles, p, elastic_stress(before, increment, material),
                                        increment, material, step, sums);
  particles.stress[0][p] = stress.xx;
  particles.stress[1][p] = stress.yy;
  particles.stress[2][p] = stress.zz;
  particles.stress[3][p] = stress.xy;
}

}  // namespace rgimp::kernels::reference
