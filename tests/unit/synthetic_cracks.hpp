#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry.hpp"
#include "rgimp/cracks.hpp"

/// Blocks with cracks drawn into them, for which every measure is known.
namespace rgimp::tests {

/// 20 mm x 40 mm between platens, cells of 0.5 mm, particles every 0.25 mm.
inline Case block_with(std::vector<Flaw> flaws) {
  Case settings;
  settings.grid.cell_size = 0.5e-3;
  settings.bodies.push_back({.size = {20e-3, 40e-3, 0.0}, .material = "rock"});
  settings.materials["rock"] = {
      .density = 2600.0, .youngs_modulus = 17e9, .poisson_ratio = 0.14, .failure = {}};
  settings.platens = {{.side = Side::top}, {.side = Side::bottom}};
  settings.flaws = std::move(flaws);
  settings.time.steps = 1000;
  return settings;
}

inline Flaw flat_slot(double x, double y) {
  return {.center = {x, y, 0.0}, .length = 6e-3, .width = 1e-3};
}

inline ParticleTable intact(const Case& settings) {
  ParticleTable table;
  for (const ParticleSeed& seed : seed_particles(settings)) {
    table.id.push_back(static_cast<std::uint32_t>(table.id.size()));
    table.position.push_back({seed.position.x(), seed.position.y(), seed.position.z()});
  }
  table.velocity.resize(table.size());
  table.stress.resize(table.size());
  table.max_principal_stress.resize(table.size());
  table.damage.resize(table.size());
  table.failed.resize(table.size(), FailureMode::intact);
  table.failure_step.resize(table.size(), -1);
  return table;
}

/// A straight crack that grows 1 mm every 100 steps.
struct Cut {
  Vector from;        ///< m
  double degrees;     ///< from +x
  double length;      ///< m
  std::int64_t step;  ///< of the failure at `from`
};

/// Fails what lies within 0.2 mm of the cut, that is one or two particles across.
inline void add(const Cut& cut, ParticleTable& table) {
  const double angle = cut.degrees * std::numbers::pi / 180.0;
  const Vector way(std::cos(angle), std::sin(angle), 0.0);
  for (std::size_t i = 0; i < table.size(); ++i) {
    const Vector offset = Vector(table.position[i][0], table.position[i][1], 0.0) - cut.from;
    const double along = offset.dot(way);
    if (along >= 0.0 && along <= cut.length && (offset - along * way).norm() < 0.2e-3 &&
        table.failed[i] == FailureMode::intact) {
      table.failed[i] = FailureMode::tension;
      table.failure_step[i] = static_cast<std::int32_t>(cut.step + std::llround(along * 1e5));
    }
  }
}

inline std::int64_t failed_count(const ParticleTable& table) {
  return std::count_if(table.failed.begin(), table.failed.end(),
                       [](FailureMode mode) { return mode != FailureMode::intact; });
}

}  // namespace rgimp::tests
