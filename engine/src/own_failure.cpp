#include "own_failure.hpp"

#include <algorithm>

#include "energy.hpp"

namespace rgimp {
namespace {

constexpr std::ptrdiff_t kLanesAtATime = 4096;

template <int Dim>
IntactParticle particle_at(const Particles<Dim>& particles, std::size_t lane) {
  IntactParticle particle;
  particle.id = particles.id[lane];
  for (int a = 0; a < Dim; ++a) {
    particle.position[a] = particles.position[a][lane];
  }
  for (int a = 0; a < 3; ++a) {
    for (int b = 0; b < 3; ++b) {
      const int column = kernels::kStressColumn[a][b];
      particle.stress(a, b) =
          column < Particles<Dim>::kStress ? particles.stress[column][lane] : 0.0;
    }
  }
  return particle;
}

/// Leaves no deviator, and the pressure that the material's treatment leaves.
template <int Dim>
void treat(Particles<Dim>& particles, std::size_t lane,
           const kernels::MaterialConstants& material) {
  double trace = 0.0;
  for (int c = 0; c < 3; ++c) {
    trace += particles.stress[c][lane];
  }
  const double pressure =
      std::clamp(-trace / 3.0, material.failed_pressure_min, material.failed_pressure_max);
  for (int c = 0; c < Particles<Dim>::kStress; ++c) {
    particles.stress[c][lane] = c < 3 ? -pressure : 0.0;
  }
}

/// The kernels take half of the step's strain work off the released energy, as that was never put
/// in. Strains are not known here: in a cracking block the sum is 3 % too high.
template <int Dim>
void fail(Particles<Dim>& particles, std::size_t lane, FailureMode mode, std::int32_t step,
          const std::vector<kernels::MaterialConstants>& materials, OwnFailures& failures) {
  const double before = energy_of_lane(particles, lane, materials).strain;
  treat(particles, lane, materials[particles.slot_material[lane / kernels::kGroupWidth]]);
  particles.failure_mode[lane] =
      mode == FailureMode::tension ? kernels::kFailedInTension : kernels::kFailedInShear;
  particles.failure_step[lane] = step;
  failures.released_energy += before - energy_of_lane(particles, lane, materials).strain;
  ++(mode == FailureMode::tension ? failures.tension : failures.shear);
}

}  // namespace

template <int Dim>
OwnFailures fail_by(const FailureCriterion& criterion, Particles<Dim>& particles,
                    const std::vector<kernels::MaterialConstants>& materials, std::int32_t step,
                    Workers& workers) {
  const auto lanes = static_cast<std::ptrdiff_t>(particles.lanes());
  std::vector<OwnFailures> parts(
      static_cast<std::size_t>((lanes + kLanesAtATime - 1) / kLanesAtATime));
  workers.for_each(static_cast<std::ptrdiff_t>(parts.size()), [&](std::ptrdiff_t part) {
    const std::ptrdiff_t last = std::min(lanes, (part + 1) * kLanesAtATime);
    for (std::ptrdiff_t i = part * kLanesAtATime; i < last; ++i) {
      const auto lane = static_cast<std::size_t>(i);
      if (particles.is_padding(lane) || particles.failure_mode[lane] >= kernels::kFailedInTension) {
        continue;
      }
      const FailureMode mode = criterion(particle_at(particles, lane));
      if (mode != FailureMode::intact) {
        fail(particles, lane, mode, step, materials, parts[static_cast<std::size_t>(part)]);
      }
    }
  });
  OwnFailures all;
  for (const OwnFailures& part : parts) {
    all.tension += part.tension;
    all.shear += part.shear;
    all.released_energy += part.released_energy;
  }
  return all;
}

template OwnFailures fail_by<2>(const FailureCriterion&, Particles<2>&,
                                const std::vector<kernels::MaterialConstants>&, std::int32_t,
                                Workers&);
template OwnFailures fail_by<3>(const FailureCriterion&, Particles<3>&,
                                const std::vector<kernels::MaterialConstants>&, std::int32_t,
                                Workers&);

}  // namespace rgimp
