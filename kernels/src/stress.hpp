#pragma once

#include "failure.hpp"
#include "g2p.hpp"
#include "nodes.hpp"

/// Strain from the node velocities, then stress and failure as a second loop over the slots.
namespace rgimp::kernels {
namespace {

/// Strain and rotation of a step in the plane: exx, eyy, engineering shear, and
/// dt (dvx/dy - dvy/dx) / 2.
struct PlaneIncrement {
  Batch xx;
  Batch yy;
  Batch xy;
  Batch rotation;
};

/// Slots whose increments are kept between the two loops.
constexpr std::size_t kStrainRound = 16;

inline PlaneIncrement increment_at(const FieldCoefficients<2> (&velocity)[2], const Basis<2>& basis,
                                   Batch dt_per_cell) {
  Batch x[2];
  Batch y[2];
  gradient_at(velocity[0], basis, x);
  gradient_at(velocity[1], basis, y);
  return {dt_per_cell * x[0], dt_per_cell * y[1], dt_per_cell * (x[1] + y[0]),
          Batch(0.5) * dt_per_cell * (x[1] - y[0])};
}

/// Hooke's law in plane strain with the Jaumann rate, sigma += C : D dt + W sigma - sigma W.
inline PlaneStress elastic_stress(const PlaneStress& s, const PlaneIncrement& e,
                                  const MaterialConstants& material) {
  const Batch volumetric = Batch(material.lambda) * (e.xx + e.yy);
  const Batch twice_shear(2.0 * material.shear_modulus);
  const Batch turned = Batch(2.0) * e.rotation * s.xy;
  return {fused(twice_shear, e.xx, s.xx + volumetric) + turned,
          fused(twice_shear, e.yy, s.yy + volumetric) - turned, s.zz + volumetric,
          fused(Batch(material.shear_modulus), e.xy, fused(e.rotation, s.yy - s.xx, s.xy))};
}

/// Stress and failure of the particles of a row of bins, and what they add to the row's sums.
class StressUpdate {
 public:
  StressUpdate(const ParticleView<2>& particles, const MaterialConstants* materials, double dt,
               std::int32_t step)
      : p_(particles),
        tested_(materials),
        test_(materials->limits),
        per_dt_(1.0 / dt),
        step_(step) {}

  void slot(std::size_t index, const PlaneIncrement& e, const MaterialConstants& material) {
    const Batch trace_of_strain = e.xx + e.yy;
    const Batch volume = update_volume(index, trace_of_strain, material);
    PlaneStress s = elastic_stress(load(index), e, material);
    const Circle circle = circle_of(s);
    const Batch mode = Batch::load_aligned(p_.failure_mode + index);
    const Mask intact = mode == Batch(kIntact);
    const Mask failing = may_fail(s, circle, test_of(material)) & intact;
    // Rare: a handful of particles in a hundred thousand.
    if (xsimd::any(failing | (mode > Batch(kIntact)))) {
      s = fail(index, {s, e, circle, mode, volume}, material);
    }
    store(index, s);
  }

  ParticleSums sums() const { return {viscous_work_.total(), released_.total(), tension_, shear_}; }

  int part = 0;  ///< which batch of the group

 private:
  /// The test of a slot's material, made anew only where the material changes.
  const FailureTest& test_of(const MaterialConstants& material) {
    if (&material != tested_) {
      tested_ = &material;
      test_ = FailureTest(material.limits);
    }
    return test_;
  }

  PlaneStress load(std::size_t index) const {
    return {Batch::load_aligned(p_.stress[0] + index), Batch::load_aligned(p_.stress[1] + index),
            Batch::load_aligned(p_.stress[2] + index), Batch::load_aligned(p_.stress[3] + index)};
  }

  void store(std::size_t index, const PlaneStress& s) const {
    s.xx.store_aligned(p_.stress[0] + index);
    s.yy.store_aligned(p_.stress[1] + index);
    s.zz.store_aligned(p_.stress[2] + index);
    s.xy.store_aligned(p_.stress[3] + index);
  }

  /// V and q V = m (c0 L^2 (tr D)^2 + c1 L c |tr D|) in compression; returns V.
  Batch update_volume(std::size_t index, Batch trace_of_strain, const MaterialConstants& material) {
    const Batch viscous = Batch::load_aligned(p_.viscous_energy + index);
    viscous_work_.add(-viscous * trace_of_strain, part);
    const Batch closing = xsimd::min(trace_of_strain, Batch(0.0)) * Batch(per_dt_);
    const Batch rate =
        fused(Batch(material.quadratic_viscosity), closing, Batch(-material.linear_viscosity));
    (Batch::load_aligned(p_.mass + index) * closing * rate)
        .store_aligned(p_.viscous_energy + index);
    const Batch old = Batch::load_aligned(p_.volume + index);
    const Batch volume = fused(old, trace_of_strain, old);
    volume.store_aligned(p_.volume + index);
    return volume;
  }

  /// A slot whose elastic stress is known and which holds failed or failing particles.
  struct Trial {
    PlaneStress stress;
    PlaneIncrement increment;
    Circle circle;
    Batch mode;
    Batch volume;
  };

  PlaneStress fail(std::size_t index, const Trial& trial, const MaterialConstants& material) {
    const PlaneStress& s = trial.stress;
    const Batch now = xsimd::select(trial.mode == Batch(kIntact),
                                    failure_mode(s, trial.circle, material.limits), trial.mode);
    note_new(index, trial.mode, now);
    const Mask failed = now > Batch(kIntact);
    const PlaneStress left = failed_stress(s, material);
    const Batch released =
        trial.volume * (energy_density(s, material) - energy_density(left, material) -
                        half_work(s, left, trial.increment));
    released_.add(xsimd::select(failed, released, Batch(0.0)), part);
    return {xsimd::select(failed, left.xx, s.xx), xsimd::select(failed, left.yy, s.yy),
            xsimd::select(failed, left.zz, s.zz), xsimd::select(failed, left.xy, s.xy)};
  }

  /// Half the work of the dropped stress on the step's strain, J/m3: the stress rose to its trial
  /// value during the step, so this part was never put in. Booked as released it would grow with
  /// every step of a failed particle, without bound.
  static Batch half_work(const PlaneStress& s, const PlaneStress& left, const PlaneIncrement& e) {
    return Batch(0.5) *
           fused(s.xx - left.xx, e.xx, fused(s.yy - left.yy, e.yy, (s.xy - left.xy) * e.xy));
  }

  void note_new(std::size_t index, Batch before, Batch now) {
    alignas(64) double was[kLanes];
    alignas(64) double is[kLanes];
    before.store_aligned(was);
    now.store_aligned(is);
    now.store_aligned(p_.failure_mode + index);
    for (int lane = 0; lane < kLanes; ++lane) {
      if (was[lane] != is[lane]) {
        p_.failure_step[index + lane] = step_;
        tension_ += is[lane] == kFailedInTension ? 1 : 0;
        shear_ += is[lane] == kFailedInShear ? 1 : 0;
      }
    }
  }

  const ParticleView<2>& p_;
  const MaterialConstants* tested_;
  FailureTest test_;
  double per_dt_;
  std::int32_t step_;
  LaneSum viscous_work_;
  LaneSum released_;
  std::int64_t tension_ = 0;
  std::int64_t shear_ = 0;
};

inline void update_group(const ParticleView<2>& particles, const GroupPlace<2>& place,
                         const ShapeConstants<2>& shape, const double* const* field,
                         const MaterialConstants* materials, double dt, StressUpdate& update) {
  const std::uint32_t* begin = particles.group_begin + place.first_node / kGroupWidth;
  const double dt_per_cell = dt * shape.cells_per_metre;
  for (int part = 0; part < kParts; ++part) {
    update.part = part;
    const FieldCoefficients<2> velocity[2] = {field_coefficients(field[0], place, part),
                                              field_coefficients(field[1], place, part)};
    const BinOffsets<2> offsets = place.offsets(shape, part);
    for (std::size_t first = begin[0]; first < begin[1]; first += kStrainRound) {
      const std::size_t slots = begin[1] - first < kStrainRound ? begin[1] - first : kStrainRound;
      PlaneIncrement increment[kStrainRound];
      for (std::size_t s = 0; s < slots; ++s) {
        const std::size_t index = (first + s) * kGroupWidth + part * kLanes;
        const Batch scale = where_present(particles, index, dt_per_cell);
        increment[s] = increment_at(velocity, basis_at(particles, index, offsets, shape), scale);
      }
      for (std::size_t s = 0; s < slots; ++s) {
        update.slot((first + s) * kGroupWidth + part * kLanes, increment[s],
                    materials[particles.slot_material[first + s]]);
      }
    }
  }
}

inline void update_stress(const ParticleView<2>& particles, const GridView<2>& grid,
                          const double* const* field, const MaterialConstants* materials, double dt,
                          std::int32_t step, RowRange bins, ParticleSums* by_row) {
  const ShapeConstants<2> shape(grid);
  for (std::ptrdiff_t row = bins.first; row < bins.last; ++row) {
    StressUpdate update(particles, materials, dt, step);
    for_each_group(particles, grid, row, [&](const GroupPlace<2>& place) {
      update_group(particles, place, shape, field, materials, dt, update);
    });
    by_row[row] = update.sums();
  }
}

}  // namespace
}  // namespace rgimp::kernels
