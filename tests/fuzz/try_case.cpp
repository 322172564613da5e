#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "case_check.hpp"
#include "case_size.hpp"
#include "rgimp/rgimp.hpp"
#include "targets.hpp"
#include "unchecked_case.hpp"

namespace rgimp::fuzz {
namespace {

constexpr const char* kFile = "fuzz.toml";
// Two steps of so few take about a millisecond under the sanitizers.
constexpr double kMostParticles = 1500.0;
constexpr double kMostNodes = 5000.0;  // a cell and its margins are 2,704 in three dimensions

std::vector<std::string> overrides_in(const std::string& text) {
  constexpr std::string_view mark = "#--set ";
  std::vector<std::string> overrides;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with(mark)) {
      overrides.push_back(line.substr(mark.size()));
    }
  }
  return overrides;
}

/// Neither small enough to be run here nor so large that it has to be refused.
bool is_a_users_size(const Case& settings) {
  const CaseSize size = estimate_size(settings);
  if (size.particles <= kMostParticles && size.nodes <= kMostNodes) {
    return false;
  }
  try {
    check_amount(settings, std::nullopt);
    return true;
  } catch (const CaseError&) {
    return false;
  }
}

void check_round_trip(const Case& settings) {
  const std::string text = write_case(settings);
  const Case again = parse_case(text, kFile);
  check_case(again);
  if (write_case(again) != text) {
    throw std::logic_error("what write_case writes reads back to another case:\n" + text);
  }
}

bool is_finite(const ParticleTable& particles) {
  const auto all_finite = [](const auto& rows) {
    return std::all_of(rows.begin(), rows.end(), [](const auto& row) {
      return std::all_of(row.begin(), row.end(), [](double value) { return std::isfinite(value); });
    });
  };
  return all_finite(particles.position) && all_finite(particles.velocity) &&
         all_finite(particles.stress);
}

void take_two_steps(Case settings) {
  settings.tuning.threads = 1;
  try {
    Simulation simulation(std::move(settings));
    simulation.run_until(std::min<std::int64_t>(2, simulation.facts().total_steps));
    if (!is_finite(simulation.particles())) {
      throw std::logic_error("a state that is not finite went unnoticed");
    }
  } catch (const PhysicsError&) {  // too fast, out of the grid: said so, and that is right
  }
}

}  // namespace

Outcome try_case(std::string_view bytes) {
  const std::string text(bytes);
  Case settings;
  try {
    settings = parse_case(text, kFile, overrides_in(text));
    if (is_a_users_size(settings)) {
      return Outcome::refused;
    }
    check_case(settings);
  } catch (const CaseError&) {
    return Outcome::refused;
  }
  check_round_trip(settings);
  take_two_steps(std::move(settings));
  return Outcome::used;
}

}  // namespace rgimp::fuzz
