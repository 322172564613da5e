#include "verify.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>

#include "engine.hpp"
#include "rgimp/error.hpp"

namespace rgimp::bench {
namespace {

/// Fewer where there are many particles, every one of which is in motion from the start, and on
/// coarse grids: at 10 steps a cell, waves have then not reached the other side.
std::int64_t steps_to_compare(const Setting& setting, std::size_t particles) {
  constexpr std::int64_t kMostSteps = 100;
  constexpr std::int64_t kLeastSteps = 4;
  constexpr std::int64_t kParticleSteps = 8'000'000;
  const std::int64_t affordable = kParticleSteps / static_cast<std::int64_t>(particles);
  const std::int64_t accurate = std::int64_t{2} * setting.cells_across;
  return std::clamp(std::min(affordable, accurate), kLeastSteps, kMostSteps);
}

std::string key_of(const Setting& setting) {
  return fmt::format("{} dimensions, {}", setting.dimension, name(setting));
}

HistoryRow row_after_steps(const Setting& setting) {
  Case settings = case_of(setting);
  // Local damping turns on the sign of velocities, which may be round-off.
  settings.local_damping = 0.0;
  return with_engine(setting, settings, [&](auto& engine) {
    engine.steps(steps_to_compare(setting, engine.particles()));
    return engine.history();
  });
}

/// The reference's row of the same case.
const HistoryRow& expected_row(Setting setting) {
  static std::map<std::string, HistoryRow> rows;
  setting.isa = kernels::Isa::reference;
  setting.threads = 1;
  const std::string key = key_of(setting);
  const auto found = rows.find(key);
  return found != rows.end() ? found->second
                             : rows.emplace(key, row_after_steps(setting)).first->second;
}

std::string compare(const Setting& setting) {
  // USL strains with the velocities of nearly empty nodes, whose forces over masses have no more
  // digits than the particle's distance from the edge of its weights.
  const double tolerance = setting.integrator == Integrator::usl ? 1e-6 : 1e-10;
  const HistoryRow& expected = expected_row(setting);
  const HistoryRow got = row_after_steps(setting);
  const double strain = std::abs(got.strain_energy / expected.strain_energy - 1.0);
  const double kinetic = std::abs(got.kinetic_energy / expected.kinetic_energy - 1.0);
  // The platens' work and not their reaction, which is that of one step: where it is small its
  // round-off is large (USF, a cube of 24 cells after 48 steps: 1.7e-10).
  const double work = std::abs(got.external_work / expected.external_work - 1.0);
  if (strain <= tolerance && kinetic <= tolerance && work <= tolerance) {
    return {};
  }
  return fmt::format(
      "differs from the scalar reference after {} steps: strain energy by {:.3g}, kinetic energy "
      "by {:.3g}, work of the platens by {:.3g}; tolerance {:g}",
      got.step, strain, kinetic, work, tolerance);
}

std::string compare_or_explain(const Setting& setting) {
  try {
    return compare(setting);
  } catch (const Error& error) {
    return error.what();
  }
}

}  // namespace

const std::string& difference_from_reference(const Setting& setting) {
  static std::map<std::string, std::string> differences;
  const std::string key = key_of(setting);
  const auto found = differences.find(key);
  return found != differences.end()
             ? found->second
             : differences.emplace(key, compare_or_explain(setting)).first->second;
}

}  // namespace rgimp::bench
