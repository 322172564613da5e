#include "rgimp/grid_fields.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "geometry.hpp"
#include "grid_motion.hpp"
#include "grid_of_seeds.hpp"
#include "rgimp/error.hpp"
#include "time_step.hpp"

namespace rgimp {
namespace {

/// The nodes along one axis that a particle reaches.
struct AxisWeights {
  std::int64_t lowest = 0;
  int count = 1;
  std::array<double, 3> value{1.0};
};

/// Where particles are on the grid. Weights are those of the kernels' reference, Eq. 18 about the
/// nearest node, here without bins or gradients.
class Places {
 public:
  Places(const GridFields& fields, const Case& settings)
      : fields_(fields),
        dimension_(settings.dimension),
        half_(0.5 / settings.bodies.front().particles_per_cell) {}

  /// None where a node would not be in the grid.
  std::optional<std::array<AxisWeights, 3>> at(const std::array<double, 3>& position) const {
    std::array<AxisWeights, 3> weights;
    for (int a = 0; a < dimension_; ++a) {
      const double cells = (position[a] - fields_.origin[a]) / fields_.spacing[a];
      const double nearest = std::floor(cells + 0.5);
      if (!std::isfinite(nearest) || nearest < 1.0 ||
          nearest > static_cast<double>(fields_.nodes[a] - 2)) {
        return std::nullopt;
      }
      weights[a] = about(cells - nearest, static_cast<std::int64_t>(nearest));
    }
    return weights;
  }

 private:
  /// `offset` in cells from the nearest node.
  AxisWeights about(double offset, std::int64_t nearest) const {
    const double core = std::clamp(offset, -half_, half_);
    const double flank = offset - core;
    const double above = (half_ + core) * (half_ + core) / (4.0 * half_) + std::max(flank, 0.0);
    const double below = (half_ - core) * (half_ - core) / (4.0 * half_) - std::min(flank, 0.0);
    return {nearest - 1, 3, {below, 1.0 - above - below, above}};
  }

  const GridFields& fields_;
  int dimension_;
  double half_;  // of a particle, cells
};

/// Sums of weighted values; finish() makes them averages.
class Sums {
 public:
  explicit Sums(GridFields& fields) : fields_(fields) {
    const auto size = static_cast<std::size_t>(fields.nodes[0] * fields.nodes[1] * fields.nodes[2]);
    fields.mass.resize(size);
    fields.velocity.resize(size);
    fields.stress.resize(size);
    fields.damage.resize(size);
    volume_.resize(size);
  }

  void add(const std::array<AxisWeights, 3>& at, const ParticleSeed& seed,
           const ParticleTable& particles, std::size_t row) {
    const auto& [x, y, z] = at;
    for (int k = 0; k < z.count; ++k) {
      for (int j = 0; j < y.count; ++j) {
        const std::int64_t line = y.lowest + j + fields_.nodes[1] * (z.lowest + k);
        for (int i = 0; i < x.count; ++i) {
          const auto node = static_cast<std::size_t>(x.lowest + i + fields_.nodes[0] * line);
          add(node, x.value[i] * y.value[j] * z.value[k], seed, particles, row);
        }
      }
    }
  }

  void finish() {
    for (std::size_t node = 0; node < volume_.size(); ++node) {
      if (volume_[node] > 0.0) {
        for (double& component : fields_.velocity[node]) {
          component /= fields_.mass[node];
        }
        for (double& component : fields_.stress[node]) {
          component /= volume_[node];
        }
        fields_.damage[node] /= volume_[node];
      }
    }
  }

 private:
  void add(std::size_t node, double weight, const ParticleSeed& seed,
           const ParticleTable& particles, std::size_t row) {
    const double mass = weight * seed.mass;
    const double volume = weight * seed.volume;
    fields_.mass[node] += mass;
    volume_[node] += volume;
    for (std::size_t a = 0; a < 3; ++a) {
      fields_.velocity[node][a] += mass * particles.velocity[row][a];
    }
    for (std::size_t c = 0; c < 6; ++c) {
      fields_.stress[node][c] += volume * particles.stress[row][c];
    }
    fields_.damage[node] += volume * particles.damage[row];
  }

  GridFields& fields_;
  std::vector<double> volume_;  // m3, of step 0
};

GridFields empty_fields(const Case& settings, std::int64_t step) {
  GridFields fields;
  fields.step = step;
  fields.time = time_step(settings) * static_cast<double>(step);
  const GridExtent start = grid_extent(settings);
  const GridExtent extent = GridMotion(settings, start).at(fields.time);
  fields.origin = extent.origin;
  fields.spacing = extent.spacing;
  fields.nodes = start.nodes;
  return fields;
}

}  // namespace

GridFields grid_fields(const Case& settings, const ParticleTable& particles, std::int64_t step) {
  return grid_fields(settings, seed_particles(settings), particles, step);
}

GridFields grid_fields(const Case& settings, const std::vector<ParticleSeed>& seeds,
                       const ParticleTable& particles, std::int64_t step) {
  GridFields fields = empty_fields(settings, step);
  const Places places(fields, settings);
  Sums sums(fields);
  for (std::size_t row = 0; row < particles.size(); ++row) {
    if (particles.id[row] >= seeds.size()) {
      throw CaseError(
          fmt::format("particle {}: the case has {} particles", particles.id[row], seeds.size()));
    }
    if (const auto at = places.at(particles.position[row])) {
      sums.add(*at, seeds[particles.id[row]], particles, row);
    } else {
      ++fields.particles_outside;
    }
  }
  sums.finish();
  return fields;
}

}  // namespace rgimp
