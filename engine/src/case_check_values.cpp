#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "case_check.hpp"
#include "case_error.hpp"
#include "case_names.hpp"
#include "failure_limits.hpp"
#include "shapes.hpp"
#include "time_step.hpp"

namespace rgimp {
namespace {

constexpr std::size_t kMostMaterials = std::numeric_limits<std::uint8_t>::max();
// Failure steps are kept as 32-bit integers.
constexpr std::int64_t kMostSteps = std::numeric_limits<std::int32_t>::max();
constexpr double kRoundOff = 1e-12;

void check_mohr_coulomb(const ValueChecker& check, const std::string& path,
                        const Failure& failure) {
  check.positive(path + ".cohesion", failure.cohesion);
  check.finite(path + ".friction_angle", failure.friction_angle);
  if (failure.friction_angle < 0.0 || failure.friction_angle >= 90.0) {
    check.refuse(path + ".friction_angle",
                 fmt::format("is {}; expected 0 or more and less than 90", failure.friction_angle));
  }
  check.positive(path + ".tensile_strength", failure.tensile_strength);
  if (failure.friction_angle > 0.0) {
    const double apex = failure.cohesion / std::tan(failure.friction_angle * kRadiansPerDegree);
    if (failure.tensile_strength > apex * (1.0 + kRoundOff)) {
      check.refuse(path + ".tensile_strength",
                   fmt::format("is {}; expected at most cohesion / tan(friction_angle) = {:.6g}",
                               failure.tensile_strength, apex));
    }
  }
}

void check_failure(const ValueChecker& check, const std::string& path, const Failure& failure) {
  if (failure.criterion == Criterion::mohr_coulomb) {
    check_mohr_coulomb(check, path, failure);
  } else {
    for (const FailureKey& strength : strengths_of(failure.criterion)) {
      check.positive(fmt::format("{}.{}", path, strength.key), failure.*strength.member);
    }
  }
  if (failure.treatment == Treatment::pressure_window) {
    check.finite(path + ".pressure_min", failure.pressure_min);
    check.not_negative(path + ".pressure_max", failure.pressure_max);
    if (failure.pressure_min > 0.0) {
      check.refuse(path + ".pressure_min",
                   fmt::format("is {}; expected 0 or less", failure.pressure_min));
    }
  }
}

void check_cell(const ValueChecker& check, const std::string& key, double cell, double largest,
                std::string_view formula) {
  if (cell >= largest) {
    check.refuse(key, fmt::format("needs cells smaller than {} = {:.6g} m; grid.cell_size is {}",
                                  formula, largest, cell));
  }
}

/// A band of larger cells holds more elastic energy than it is to take.
void check_fracture_energies(const ValueChecker& check, const std::string& path,
                             const Material& material, const Case& settings) {
  const Failure& failure = *material.failure;
  const auto read = keys_of(fracture_energies_of(failure.criterion));
  for (const FailureKey& energy : fracture_energies_of(Criterion::mohr_coulomb)) {
    const std::string key = fmt::format("{}.{}", path, energy.key);
    check.not_negative(key, failure.*energy.member);
    if (failure.*energy.member > 0.0 &&
        std::find(read.begin(), read.end(), energy.key) == read.end()) {
      check.refuse(key, fmt::format("not read by criterion \"{}\"", name_of(failure.criterion)));
    }
  }
  const double cell = settings.grid.cell_size;
  const LargestCell largest = largest_cell(material, settings.dimension);
  check_cell(check, path + ".fracture_energy", cell, largest.tension,
             settings.dimension == 2
                 ? "sqrt(2) (lambda + 2 mu) fracture_energy / tensile_strength^2"
                 : "2 / sqrt(3) (lambda + 2 mu) fracture_energy / tensile_strength^2");
  check_cell(check, path + ".shear_fracture_energy", cell, largest.shear,
             "2 mu shear_fracture_energy / shear strength^2");
}

/// Beyond these, squares of speeds, masses and energies are no longer numbers.
void check_time_step(const Case& settings) {
  constexpr double shortest = 1e-30;
  constexpr double longest = 1e30;
  const double dt = time_step(settings);
  if (!(dt >= shortest && dt <= longest)) {
    ValueChecker(settings).refuse(
        "time.step_factor",
        fmt::format("makes steps of {:.3g} s with this cell_size, density and youngs_modulus; "
                    "expected {} to {} s",
                    dt, shortest, longest));
  }
}

void check_number_of_steps(const Case& settings) {
  const ValueChecker check(settings);
  const TimeSettings& time = settings.time;
  if (!time.steps && !time.duration) {
    check.refuse("time", "has neither steps nor duration; expected one of them");
  }
  if (time.steps && time.duration) {
    check.refuse("time.duration", "given besides steps; expected one of them");
  }
  if (time.steps) {
    check.at_least_one("time.steps", *time.steps);
    if (*time.steps > kMostSteps) {
      check.refuse("time.steps",
                   fmt::format("is {}; expected at most {}", *time.steps, kMostSteps));
    }
    return;
  }
  check.positive("time.duration", *time.duration);
  const double steps = total_steps(settings);
  if (!(steps <= static_cast<double>(kMostSteps))) {
    check.refuse("time.duration", fmt::format("takes {:.6g} steps of {:.6g} s; expected at most {}",
                                              steps, time_step(settings), kMostSteps));
  }
}

void check_output(const Case& settings) {
  const ValueChecker check(settings);
  const OutputSettings& output = settings.output;
  check.at_least_one("output.history_every", output.history_every);
  if (output.snapshot_every) {
    check.at_least_one("output.snapshot_every", *output.snapshot_every);
  }
  if (output.checkpoint_every) {
    check.at_least_one("output.checkpoint_every", *output.checkpoint_every);
  }
  for (std::size_t i = 0; i < output.snapshot_steps.size(); ++i) {
    if (output.snapshot_steps[i] < 0) {
      check.refuse(fmt::format("output.snapshot_steps[{}]", i),
                   fmt::format("is {}; expected 0 or more", output.snapshot_steps[i]));
    }
  }
}

}  // namespace

void check_materials(const Case& settings) {
  const ValueChecker check(settings);
  if (settings.materials.size() > kMostMaterials) {
    check.refuse("material", fmt::format("has {} materials; expected at most {}",
                                         settings.materials.size(), kMostMaterials));
  }
  for (const auto& [name, material] : settings.materials) {
    const std::string path = fmt::format("material.{}", name);
    check.positive(path + ".density", material.density);
    check.positive(path + ".youngs_modulus", material.youngs_modulus);
    check.finite(path + ".poisson_ratio", material.poisson_ratio);
    if (material.poisson_ratio < 0.0 || material.poisson_ratio >= 0.5) {
      check.refuse(
          path + ".poisson_ratio",
          fmt::format("is {}; expected 0 or more and less than 0.5", material.poisson_ratio));
    }
    if (material.failure) {
      check_failure(check, path + ".failure", *material.failure);
      check_fracture_energies(check, path + ".failure", material, settings);
    }
  }
}

void check_time(const Case& settings) {
  const ValueChecker check(settings);
  check.positive("time.step_factor", settings.time.step_factor);
  // At 1 the first step is already as long as the critical one of a body at rest.
  if (settings.time.step_factor >= 1.0) {
    check.refuse("time.step_factor",
                 fmt::format("is {}; expected less than 1", settings.time.step_factor));
  }
  check_time_step(settings);
  check_number_of_steps(settings);
  check_output(settings);
}

}  // namespace rgimp
