#pragma once

#include "failure.hpp"
#include "g2p.hpp"
#include "nodes.hpp"
#include "softening.hpp"

/// Stress and failure of a batch of particles from the gradient of their velocity.
namespace rgimp::kernels {
namespace {

/// Strain and rotation of a step in the plane: exx, eyy, engineering shear, and
/// dt (dvx/dy - dvy/dx), twice the rotation.
struct PlaneIncrement {
  Batch xx;
  Batch yy;
  Batch xy;
  Batch turn;
};

/// `dt` is 0 in padding. Slopes along y are first turned into slopes per two cells along x.
inline PlaneIncrement increment_at(const VectorCoefficients<2>& velocity, const Basis<2>& basis,
                                   const ShapeConstants<2>& shape, Batch dt) {
  const Batch dt_per_two_cells = dt * Batch(0.5 * shape.cells_per_metre[0]);
  const Batch aspect(shape.aspect[1]);
  Batch x[2];
  Batch y[2];
  gradient_at(velocity.component[0], basis, x);
  gradient_at(velocity.component[1], basis, y);
  return {dt_per_two_cells * x[0], dt_per_two_cells * (aspect * y[1]),
          dt_per_two_cells * fused(aspect, x[1], y[0]),
          dt_per_two_cells * fused(aspect, x[1], -y[0])};
}

struct Elasticity {
  explicit Elasticity(const MaterialConstants& material)
      : lambda(material.lambda), shear_modulus(material.shear_modulus) {}

  double lambda;
  double shear_modulus;
};

/// A material's constants as a step needs them.
struct StepMaterial {
  StepMaterial(const MaterialConstants& material, double dt)
      : elasticity(material),
        quadratic_viscosity(material.quadratic_viscosity / (dt * dt)),
        linear_viscosity(material.linear_viscosity / dt),
        test(material.limits) {}

  Elasticity elasticity;
  double quadratic_viscosity;  // m2/s2, per squared strain of a step
  double linear_viscosity;     // m2/s2, per strain of a step
  FailureTest test;
};

/// Hooke's law in plane strain with the Jaumann rate, sigma += C : D dt + W sigma - sigma W.
inline PlaneStress elastic_stress(const PlaneStress& s, const PlaneIncrement& e, Batch strain_trace,
                                  const Elasticity& material) {
  const Batch lambda(material.lambda);
  const Batch twice_shear(2.0 * material.shear_modulus);
  const Batch turned = e.turn * s.xy;
  const Batch half_difference = Batch(0.5) * (s.yy - s.xx);
  return {fused(twice_shear, e.xx, fused(lambda, strain_trace, s.xx)) + turned,
          fused(twice_shear, e.yy, fused(lambda, strain_trace, s.yy)) - turned,
          fused(lambda, strain_trace, s.zz),
          fused(Batch(material.shear_modulus), e.xy, fused(e.turn, half_difference, s.xy))};
}

inline PlaneStress load_stress(const ParticleView<2>& p, std::size_t index) {
  return {Batch::load_aligned(p.stress[0] + index), Batch::load_aligned(p.stress[1] + index),
          Batch::load_aligned(p.stress[2] + index), Batch::load_aligned(p.stress[3] + index)};
}

/// A batch of lanes whose elastic stress is known and which holds failed or failing particles.
struct Trial {
  PlaneStress stress;
  PlaneIncrement increment;
  Circle circle;
  Batch mode;
  Batch volume;
};

/// Half the work of the dropped stress on the step's strain, J/m3: the stress rose to its trial
/// value during the step, so this part was never put in. Booked as released it would grow with
/// every step of a failed particle, without bound.
inline Batch half_work(const PlaneStress& s, const PlaneStress& left, const PlaneIncrement& e) {
  return Batch(0.5) *
         fused(s.xx - left.xx, e.xx, fused(s.yy - left.yy, e.yy, (s.xy - left.xy) * e.xy));
}

/// Failures of a row of bins. Apart from StressUpdate, as its functions are not inlined: what they
/// can reach, the compiler reads anew after every store.
class FailureLog {
 public:
  explicit FailureLog(std::int32_t step) : step_(step) {}

  /// The stress left to the lanes that have failed or fail now.
  [[gnu::noinline]] PlaneStress fail(ParticleView<2> particles, std::size_t index, int part,
                                     const Trial& trial, const MaterialConstants& material) {
    const PlaneStress& s = trial.stress;
    const Batch now = xsimd::select(trial.mode == Batch(kIntact),
                                    failure_mode(s, trial.circle, material.limits), trial.mode);
    note_new(particles, index, trial.mode, now);
    const Mask failed = now > Batch(kIntact);
    const PlaneStress left = failed_stress(s, material);
    const Batch released =
        trial.volume * (energy_density(s, material) - energy_density(left, material) -
                        half_work(s, left, trial.increment));
    released_.add(xsimd::select(failed, released, Batch(0.0)), part);
    return choose(failed, left, s);
  }

  /// The same for a material that softens. The trial stress holds for lanes that are not softening
  /// yet; the others take their step from the effective stress.
  [[gnu::noinline]] PlaneStress soften(ParticleView<2> particles, std::size_t index, int part,
                                       const Trial& trial, const MaterialConstants& material) {
    const Mask softening = (trial.mode > Batch(kIntact)) & (trial.mode < Batch(kFailedInTension));
    const Batch damage =
        xsimd::select(softening, Batch::load_aligned(particles.damage + index), Batch(0.0));
    const PlaneStress resumed =
        elastic_stress(effective_stress(load_stress(particles, index), damage), trial.increment,
                       trial.increment.xx + trial.increment.yy, Elasticity(material));
    const PlaneStress s = choose(softening, resumed, trial.stress);
    const Softened now = grow_damage(s, trial.mode, damage, material);
    note_new(particles, index, trial.mode, now.mode);
    const Mask failed = now.mode >= Batch(kFailedInTension);
    xsimd::select(failed, Batch(1.0), now.damage).store_aligned(particles.damage + index);

    const PlaneStress carried = nominal_stress(s, now.damage);
    const PlaneStress left = choose(failed, failed_stress(carried, material), carried);
    const Batch energy_left = xsimd::select(failed, energy_density(left, material),
                                            elastic_energy_density(s, now.damage, material));
    const Batch released =
        trial.volume * (elastic_energy_density(s, damage, material) - energy_left -
                        half_work(nominal_stress(s, damage), left, trial.increment));
    const Mask not_intact = now.mode > Batch(kIntact);
    released_.add(xsimd::select(not_intact, released, Batch(0.0)), part);
    return choose(not_intact, left, s);
  }

  double released() const { return released_.total(); }
  std::int64_t tension() const { return tension_; }
  std::int64_t shear() const { return shear_; }

 private:
  void note_new(const ParticleView<2>& particles, std::size_t index, Batch before, Batch now) {
    alignas(64) double was[kLanes];
    alignas(64) double is[kLanes];
    before.store_aligned(was);
    now.store_aligned(is);
    now.store_aligned(particles.failure_mode + index);
    for (int lane = 0; lane < kLanes; ++lane) {
      if (was[lane] != is[lane] && is[lane] >= kFailedInTension) {
        particles.failure_step[index + lane] = step_;
        tension_ += is[lane] == kFailedInTension ? 1 : 0;
        shear_ += is[lane] == kFailedInShear ? 1 : 0;
      }
    }
  }

  std::int32_t step_;
  LaneSum released_;
  std::int64_t tension_ = 0;
  std::int64_t shear_ = 0;
};

/// Stress of the particles of a row of bins, and what they add to the row's sums.
class StressUpdate {
 public:
  StressUpdate(const ParticleView<2>& particles, const ParticleUpdate& update, FailureLog& log)
      : p_(particles),
        materials_(update.materials),
        dt_(update.dt),
        log_(&log),
        last_(update.materials),
        constants_(*last_, update.dt) {}

  /// V, q V and sigma at the end of the step.
  void batch(std::size_t index, int part, const PlaneIncrement& e) {
    const MaterialConstants& material = materials_[p_.slot_material[index / kGroupWidth]];
    use(material);
    const Batch strain_trace = e.xx + e.yy;
    const Batch volume = update_volume(index, part, strain_trace);
    PlaneStress s = elastic_stress(load_stress(p_, index), e, strain_trace, constants_.elasticity);
    const Circle circle = circle_of(s);
    const Batch mode = Batch::load_aligned(p_.failure_mode + index);
    // Rare: a handful of particles in a hundred thousand.
    if (xsimd::any(may_fail(s, circle, constants_.test) | (mode > Batch(kIntact)))) {
      const Trial trial{s, e, circle, mode, volume};
      s = material.softens ? log_->soften(p_, index, part, trial, material)
                           : log_->fail(p_, index, part, trial, material);
    }
    store(index, s);
  }

  double viscous_work() const { return -viscous_work_.total(); }

 private:
  /// The constants of a slot's material, made anew only where the material changes.
  void use(const MaterialConstants& material) {
    if (&material != last_) {
      last_ = &material;
      constants_ = StepMaterial(material, dt_);
    }
  }

  void store(std::size_t index, const PlaneStress& s) const {
    s.xx.store_aligned(p_.stress[0] + index);
    s.yy.store_aligned(p_.stress[1] + index);
    s.zz.store_aligned(p_.stress[2] + index);
    s.xy.store_aligned(p_.stress[3] + index);
  }

  /// V and q V = m (c0 L^2 (tr D)^2 + c1 L c |tr D|) in compression; returns V.
  Batch update_volume(std::size_t index, int part, Batch strain_trace) {
    const Batch viscous_energy = Batch::load_aligned(p_.viscous_energy + index);
    viscous_work_.add(viscous_energy * strain_trace, part);
    const Batch closing = xsimd::min(strain_trace, Batch(0.0));
    const Batch rate =
        fused(Batch(constants_.quadratic_viscosity), closing, Batch(-constants_.linear_viscosity));
    (Batch::load_aligned(p_.mass + index) * closing * rate)
        .store_aligned(p_.viscous_energy + index);
    const Batch old = Batch::load_aligned(p_.volume + index);
    const Batch volume = fused(old, strain_trace, old);
    volume.store_aligned(p_.volume + index);
    return volume;
  }

  ParticleView<2> p_;
  const MaterialConstants* materials_;
  double dt_;
  FailureLog* log_;
  const MaterialConstants* last_;
  StepMaterial constants_;
  LaneSum viscous_work_;
};

}  // namespace
}  // namespace rgimp::kernels
