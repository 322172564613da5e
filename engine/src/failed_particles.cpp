#include "failed_particles.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "crack_geometry.hpp"
#include "geometry.hpp"
#include "rgimp/error.hpp"

namespace rgimp {

namespace {

[[noreturn]] void refuse_particles(const std::string& reason) {
  throw CaseError("the particles are not those of the case: " + reason);
}

void assign_flaw(const Case& settings, FailedParticle& particle) {
  particle.distance = std::numeric_limits<double>::infinity();
  for (std::size_t f = 0; f < settings.flaws.size(); ++f) {
    const double distance = distance_to(settings.flaws[f], particle.position);
    if (distance < particle.distance) {
      particle.distance = distance;
      particle.nearest_flaw = f;
    }
  }
  if (particle.distance <= settings.grid.cell_size) {
    particle.flaw = particle.nearest_flaw;
  }
}

}  // namespace

std::vector<FailedParticle> failed_particles(const Case& settings, const ParticleTable& particles) {
  const std::vector<ParticleSeed> seeds = seed_particles(settings);
  const bool some_may_miss = settings.grid.on_exit == OnExit::remove;
  if (particles.size() > seeds.size() || (particles.size() < seeds.size() && !some_may_miss)) {
    refuse_particles(fmt::format("{} of {}", particles.size(), seeds.size()));
  }
  std::vector<std::size_t> rows;
  for (std::size_t row = 0; row < particles.size(); ++row) {
    if (particles.id[row] >= seeds.size()) {
      refuse_particles(fmt::format("id {} of {}", particles.id[row], seeds.size()));
    }
    if (particles.failed[row] != FailureMode::intact) {
      rows.push_back(row);
    }
  }
  const auto earlier = [&](std::size_t a, std::size_t b) {
    return std::pair(particles.failure_step[a], particles.id[a]) <
           std::pair(particles.failure_step[b], particles.id[b]);
  };
  std::sort(rows.begin(), rows.end(), earlier);
  std::vector<FailedParticle> failed;
  for (const std::size_t row : rows) {
    FailedParticle particle;
    particle.step = particles.failure_step[row];
    particle.position = seeds[particles.id[row]].position;
    assign_flaw(settings, particle);
    failed.push_back(particle);
  }
  return failed;
}

double finest_pitch(const Case& settings) {
  double pitch = settings.grid.cell_size;
  for (const Body& body : settings.bodies) {
    pitch = std::min(pitch, settings.grid.cell_size / body.particles_per_cell);
  }
  return pitch;
}

}  // namespace rgimp
