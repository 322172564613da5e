#pragma once

#include "failure.hpp"
#include "g2p.hpp"
#include "nodes.hpp"
#include "softening.hpp"

/// Stress and failure of a batch of particles from the gradient of their velocity.
namespace rgimp::kernels {
namespace {

/// Strain of a step, with engineering shears, and twice its rotation.
template <int Dim>
struct Increment;

template <>
struct Increment<2> {
  Batch xx;
  Batch yy;
  Batch xy;
  Batch turn_xy;  // dt (dvx/dy - dvy/dx)
};

template <>
struct Increment<3> {
  Batch xx;
  Batch yy;
  Batch zz;
  Batch xy;
  Batch yz;
  Batch xz;
  Batch turn_xy;
  Batch turn_yz;  // dt (dvy/dz - dvz/dy)
  Batch turn_xz;  // dt (dvx/dz - dvz/dx)
};

inline Batch trace(const Increment<2>& e) {
  return e.xx + e.yy;
}

inline Batch trace(const Increment<3>& e) {
  return e.xx + e.yy + e.zz;
}

/// `dt` is 0 in padding. Slopes along y are first turned into slopes per two cells along x.
inline Increment<2> increment_at(const VectorCoefficients<2>& velocity, const Basis<2>& basis,
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

/// As in the plane; slopes along z likewise.
inline Increment<3> increment_at(const VectorCoefficients<3>& velocity, const Basis<3>& basis,
                                 const ShapeConstants<3>& shape, Batch dt) {
  const Batch along_x = dt * Batch(0.5 * shape.cells_per_metre[0]);
  const Batch along_y = along_x * Batch(shape.aspect[1]);
  const Batch along_z = along_x * Batch(shape.aspect[2]);
  Batch x[3];
  Batch y[3];
  Batch z[3];
  gradient_at(velocity.component[0], basis, x);
  gradient_at(velocity.component[1], basis, y);
  gradient_at(velocity.component[2], basis, z);
  const Batch x_by_y = along_y * x[1];
  const Batch x_by_z = along_z * x[2];
  const Batch y_by_z = along_z * y[2];
  return {along_x * x[0],
          along_y * y[1],
          along_z * z[2],
          fused(along_x, y[0], x_by_y),
          fused(along_y, z[1], y_by_z),
          fused(along_x, z[0], x_by_z),
          fused(-along_x, y[0], x_by_y),
          fused(-along_y, z[1], y_by_z),
          fused(-along_x, z[0], x_by_z)};
}

struct Elasticity {
  explicit Elasticity(const MaterialConstants& material)
      : lambda(material.lambda), shear_modulus(material.shear_modulus) {}

  double lambda;
  double shear_modulus;
};

/// A material's constants as a step needs them.
template <int Dim>
struct StepMaterial {
  StepMaterial(const MaterialConstants& material, double dt)
      : elasticity(material),
        quadratic_viscosity(material.quadratic_viscosity / (dt * dt)),
        linear_viscosity(material.linear_viscosity / dt),
        test(material.limits) {}

  Elasticity elasticity;
  double quadratic_viscosity;  // m2/s2, per squared strain of a step
  double linear_viscosity;     // m2/s2, per strain of a step
  FailureTest<Dim> test;
};

/// Hooke's law in plane strain with the Jaumann rate, sigma += C : D dt + W sigma - sigma W.
inline Stress<2> elastic_stress(const Stress<2>& s, const Increment<2>& e, Batch strain_trace,
                                const Elasticity& material) {
  const Batch lambda(material.lambda);
  const Batch twice_shear(2.0 * material.shear_modulus);
  const Batch turned = e.turn_xy * s.xy;
  const Batch half_difference = Batch(0.5) * (s.yy - s.xx);
  return {fused(twice_shear, e.xx, fused(lambda, strain_trace, s.xx)) + turned,
          fused(twice_shear, e.yy, fused(lambda, strain_trace, s.yy)) - turned,
          fused(lambda, strain_trace, s.zz),
          fused(Batch(material.shear_modulus), e.xy, fused(e.turn_xy, half_difference, s.xy))};
}

/// The same in three dimensions.
inline Stress<3> elastic_stress(const Stress<3>& s, const Increment<3>& e, Batch strain_trace,
                                const Elasticity& material) {
  const Batch half(0.5);
  const Batch shear(material.shear_modulus);
  const Batch twice_shear(2.0 * material.shear_modulus);
  const Batch volumetric = Batch(material.lambda) * strain_trace;
  const Batch xy = half * e.turn_xy;
  const Batch yz = half * e.turn_yz;
  const Batch xz = half * e.turn_xz;
  const Batch in_xy = e.turn_xy * s.xy;
  const Batch in_yz = e.turn_yz * s.yz;
  const Batch in_xz = e.turn_xz * s.xz;
  return {fused(twice_shear, e.xx, s.xx + volumetric) + (in_xy + in_xz),
          fused(twice_shear, e.yy, s.yy + volumetric) + (in_yz - in_xy),
          fused(twice_shear, e.zz, s.zz + volumetric) - (in_xz + in_yz),
          fused(shear, e.xy, fused(xy, s.yy - s.xx, s.xy)) + fused(xz, s.yz, yz * s.xz),
          fused(shear, e.yz, fused(yz, s.zz - s.yy, s.yz)) - fused(xy, s.xz, xz * s.xy),
          fused(shear, e.xz, fused(xz, s.zz - s.xx, s.xz)) + fused(xy, s.yz, -yz * s.xy)};
}

/// A batch of lanes whose elastic stress is known and which holds failed or failing particles.
template <int Dim>
struct Trial {
  Stress<Dim> stress;
  Increment<Dim> increment;
  Batch mode;
  Batch volume;
  Mask may_fail;
};

/// Half the work of the dropped stress on the step's strain, J/m3: the stress rose to its trial
/// value during the step, so this part was never put in. Booked as released it would grow with
/// every step of a failed particle, without bound.
inline Batch half_work(const Stress<2>& s, const Stress<2>& left, const Increment<2>& e) {
  return Batch(0.5) *
         fused(s.xx - left.xx, e.xx, fused(s.yy - left.yy, e.yy, (s.xy - left.xy) * e.xy));
}

inline Batch half_work(const Stress<3>& s, const Stress<3>& left, const Increment<3>& e) {
  const Batch normal =
      fused(s.xx - left.xx, e.xx, fused(s.yy - left.yy, e.yy, (s.zz - left.zz) * e.zz));
  const Batch shear =
      fused(s.xy - left.xy, e.xy, fused(s.yz - left.yz, e.yz, (s.xz - left.xz) * e.xz));
  return Batch(0.5) * (normal + shear);
}

/// Failures of a row of bins. Apart from StressUpdate, as its functions are not inlined: what they
/// can reach, the compiler reads anew after every store.
template <int Dim>
class FailureLog {
 public:
  explicit FailureLog(std::int32_t step) : step_(step) {}

  /// The stress left to the lanes that have failed or fail now.
  [[gnu::noinline]] Stress<Dim> fail(ParticleView<Dim> particles, std::size_t index, int part,
                                     const Trial<Dim>& trial, const MaterialConstants& material) {
    const Stress<Dim>& s = trial.stress;
    Batch now = trial.mode;
    // Most batches that come here only hold what failed long ago.
    Mask in_question = trial.may_fail & (trial.mode == Batch(kIntact));
    if (xsimd::any(in_question)) {
      in_question = still_may_fail(s, material.limits, in_question);
    }
    if (xsimd::any(in_question)) {
      now = xsimd::select(in_question, failure_mode(s, material.limits), trial.mode);
      note_new(particles, index, trial.mode, now);
    }
    const Mask failed = now > Batch(kIntact);
    const Stress<Dim> left = failed_stress(s, material);
    const Batch released =
        trial.volume * (energy_density(s, material) - energy_density(left, material) -
                        half_work(s, left, trial.increment));
    released_.add(xsimd::select(failed, released, Batch(0.0)), part);
    return choose(failed, left, s);
  }

  /// The same for a material that softens. The trial stress holds for lanes that are not softening
  /// yet; the others take their step from the effective stress.
  [[gnu::noinline]] Stress<Dim> soften(ParticleView<Dim> particles, std::size_t index, int part,
                                       const Trial<Dim>& trial, const MaterialConstants& material) {
    const Mask softening = (trial.mode > Batch(kIntact)) & (trial.mode < Batch(kFailedInTension));
    const Batch damage =
        xsimd::select(softening, Batch::load_aligned(particles.damage + index), Batch(0.0));
    const Stress<Dim> resumed =
        elastic_stress(effective_stress(load_stress(particles, index), damage), trial.increment,
                       trace(trial.increment), Elasticity(material));
    const Stress<Dim> s = choose(softening, resumed, trial.stress);
    const Softened now = grow_damage(s, trial.mode, damage, material);
    note_new(particles, index, trial.mode, now.mode);
    const Mask failed = now.mode >= Batch(kFailedInTension);
    xsimd::select(failed, Batch(1.0), now.damage).store_aligned(particles.damage + index);

    const Stress<Dim> carried = nominal_stress(s, now.damage);
    const Stress<Dim> left = choose(failed, failed_stress(carried, material), carried);
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
  void note_new(const ParticleView<Dim>& particles, std::size_t index, Batch before, Batch now) {
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
template <int Dim>
class StressUpdate {
 public:
  StressUpdate(const ParticleView<Dim>& particles, const ParticleUpdate& update,
               FailureLog<Dim>& log)
      : p_(particles),
        materials_(update.materials),
        dt_(update.dt),
        log_(&log),
        last_(update.materials),
        constants_(*last_, update.dt) {}

  /// V, q V and sigma at the end of the step.
  void batch(std::size_t index, int part, const Increment<Dim>& e) {
    const MaterialConstants& material = materials_[p_.slot_material[index / kGroupWidth]];
    use(material);
    const Batch strain_trace = trace(e);
    const Batch volume = update_volume(index, part, strain_trace);
    Stress<Dim> s = elastic_stress(load_stress(p_, index), e, strain_trace, constants_.elasticity);
    const Batch mode = Batch::load_aligned(p_.failure_mode + index);
    // Rare: a handful of particles in a hundred thousand.
    const Mask in_danger = may_fail(s, constants_.test);
    if (xsimd::any(in_danger | (mode > Batch(kIntact)))) {
      const Trial<Dim> trial{s, e, mode, volume, in_danger};
      s = material.softens ? log_->soften(p_, index, part, trial, material)
                           : log_->fail(p_, index, part, trial, material);
    }
    store_stress(p_, index, s);
  }

  double viscous_work() const { return -viscous_work_.total(); }

 private:
  /// The constants of a slot's material, made anew only where the material changes.
  void use(const MaterialConstants& material) {
    if (&material != last_) {
      last_ = &material;
      constants_ = StepMaterial<Dim>(material, dt_);
    }
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

  ParticleView<Dim> p_;
  const MaterialConstants* materials_;
  double dt_;
  FailureLog<Dim>* log_;
  const MaterialConstants* last_;
  StepMaterial<Dim> constants_;
  LaneSum viscous_work_;
};

}  // namespace
}  // namespace rgimp::kernels
