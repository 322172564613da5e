#include "rgimp/specimen.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include "atomic_file.hpp"
#include "geometry.hpp"
#include "json.hpp"
#include "rgimp/case_file.hpp"
#include "snapshot.hpp"

namespace rgimp {

namespace {

/// Of the particles, that coordinate along an axis which is nearest to the middle of them all.
double middle_layer(const ParticleTable& particles, std::size_t axis) {
  const auto along = [axis](const auto& a, const auto& b) { return a[axis] < b[axis]; };
  const auto [low, high] =
      std::minmax_element(particles.position.begin(), particles.position.end(), along);
  const double middle = 0.5 * ((*low)[axis] + (*high)[axis]);
  const auto nearest =
      std::min_element(particles.position.begin(), particles.position.end(),
                       [axis, middle](const auto& a, const auto& b) {
                         return std::abs(a[axis] - middle) < std::abs(b[axis] - middle);
                       });
  return (*nearest)[axis];
}

/// Keeps what a picture of a solid can show: of millions of particles tens of thousands.
ParticleTable middle_layers(const ParticleTable& particles, double pitch) {
  const std::array<double, 3> layers{middle_layer(particles, 0), middle_layer(particles, 1),
                                     middle_layer(particles, 2)};
  ParticleTable kept;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    bool is_shown = false;
    for (std::size_t axis = 0; axis < layers.size(); ++axis) {
      is_shown |= std::abs(particles.position[i][axis] - layers[axis]) < 0.5 * pitch;
    }
    if (is_shown) {
      kept.id.push_back(particles.id[i]);
      kept.position.push_back(particles.position[i]);
      kept.velocity.push_back(particles.velocity[i]);
      kept.stress.push_back(particles.stress[i]);
      kept.max_principal_stress.push_back(particles.max_principal_stress[i]);
      kept.failed.push_back(particles.failed[i]);
      kept.damage.push_back(particles.damage[i]);
      kept.failure_step.push_back(particles.failure_step[i]);
    }
  }
  return kept;
}

}  // namespace

void write_specimen(const Simulation& simulation, const std::filesystem::path& directory) {
  const Case& settings = simulation.settings();
  write_file(directory / "case.toml", write_case(settings));
  const GridExtent grid = grid_extent(settings);
  Vector top = grid.origin;
  for (int axis = 0; axis < settings.dimension; ++axis) {
    top[axis] +=
        grid.spacing[axis] * static_cast<double>(grid.nodes[static_cast<std::size_t>(axis)] - 1);
  }
  const Json json{{"grid_min_m", vector_json(grid.origin)},
                  {"grid_max_m", vector_json(top)},
                  {"particles", simulation.facts().particles}};
  write_file(directory / "specimen.json", json.dump(2) + "\n");
  ParticleTable particles = simulation.particles();
  if (settings.dimension == 3) {
    const double pitch = settings.grid.cell_size / settings.bodies.front().particles_per_cell;
    particles = middle_layers(particles, pitch);
  }
  write_snapshot(directory / "particles.vtkhdf", std::move(particles),
                 {simulation.steps_done(), simulation.time()});
}

}  // namespace rgimp
