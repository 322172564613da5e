#include "case_check.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "case_error.hpp"
#include "case_names.hpp"
#include "nearest_name.hpp"
#include "rgimp/case_file.hpp"
#include "shapes.hpp"
#include "time_step.hpp"

namespace rgimp {

namespace {

constexpr int kFewestParticlesPerCell = 2;
constexpr int kMostParticlesPerCell = 4;
constexpr int kMostThreads = 1024;  // more is a slip of the pen
constexpr int kMostBandsPerTask = 64;
// Bands of one row would reach into those of their own colour.
constexpr int kLeastBandHeight = 2;
constexpr int kMostBandHeight = 64;

/// For cases built in code: the reader has no such words.
template <typename Enum>
void check_word(const Case& settings, const std::string& key, Enum value) {
  if (!exists_in(settings.dimension, value)) {
    refuse(settings.source, key,
           fmt::format("\"{}\" is not one of {}", name_of(value),
                       fmt::join(all_names<Enum>(settings.dimension), ", ")));
  }
}

void check_body_size(const ValueChecker& check, const std::string& path, const Body& body) {
  const std::string key = path + ".size";
  switch (body.shape) {
    case BodyShape::box:
      return check.edges(key, body.size);
    case BodyShape::disk:
    case BodyShape::sphere:
      return check.positive(key, body.size.x());
    case BodyShape::cylinder:
      check.positive(key + "[0]", body.size.x());
      check.positive(key + "[1]", body.size.y());
      return check.direction(path + ".axis", body.axis);
  }
}

void check_material_name(const Case& settings, const std::string& path, const Body& body) {
  if (settings.materials.contains(body.material)) {
    return;
  }
  std::vector<std::string_view> names;
  for (const auto& [name, material] : settings.materials) {
    names.push_back(name);
  }
  const std::string all = names.empty()
                              ? "; the case has no material"
                              : fmt::format("; the materials are {}", fmt::join(names, ", "));
  refuse(settings.source, path + ".material",
         fmt::format("no material \"{}\"{}", body.material, suggestion(body.material, names, all)));
}

void check_bodies(const Case& settings) {
  const ValueChecker check(settings);
  if (settings.bodies.empty()) {
    check.refuse("body", "missing; expected at least one [[body]]");
  }
  for (std::size_t i = 0; i < settings.bodies.size(); ++i) {
    const Body& body = settings.bodies[i];
    const std::string path = fmt::format("body[{}]", i);
    check_word(settings, path + ".shape", body.shape);
    check.vector(path + ".center", body.center);
    check_body_size(check, path, body);
    check_material_name(settings, path, body);
    const std::string key = path + ".particles_per_cell";
    if (body.particles_per_cell < kFewestParticlesPerCell ||
        body.particles_per_cell > kMostParticlesPerCell) {
      check.refuse(key, fmt::format("is {}; expected {} to {}", body.particles_per_cell,
                                    kFewestParticlesPerCell, kMostParticlesPerCell));
    }
    if (body.particles_per_cell != settings.bodies.front().particles_per_cell) {
      check.refuse(
          key, fmt::format("is {}; expected {}, as in body[0]: all bodies share one",
                           body.particles_per_cell, settings.bodies.front().particles_per_cell));
    }
    check.vector(path + ".velocity", body.velocity);
  }
}

void check_length(const ValueChecker& check, const std::string& path, const Flaw& flaw) {
  if (flaw.length < flaw.width) {
    check.refuse(path + ".length",
                 fmt::format("is {}; expected at least the width, {}", flaw.length, flaw.width));
  }
}

/// Where a slot's length and width point to in three dimensions.
void check_slot_directions(const ValueChecker& check, const std::string& path, const Flaw& slot) {
  constexpr double kRightAngle = 1e-6;  // most that the cosine may be off
  if (slot.direction.has_value() != slot.normal.has_value()) {
    const auto [given, missing] =
        slot.direction ? std::pair(".direction", "normal") : std::pair(".normal", "direction");
    check.refuse(path + given, fmt::format("given without {}; expected both or none", missing));
  }
  if (slot.direction) {
    check.direction(path + ".direction", *slot.direction);
    check.direction(path + ".normal", *slot.normal);
    const double cosine = slot.direction->normalized().dot(slot.normal->normalized());
    if (std::abs(cosine) > kRightAngle) {
      check.refuse(path + ".normal",
                   fmt::format("is {:.4g} degrees from direction; expected a right angle",
                               std::acos(cosine) / kRadiansPerDegree));
    }
  }
  if (slot.depth) {
    check.positive(path + ".depth", *slot.depth);
  }
}

void check_slot(const ValueChecker& check, const std::string& path, const Flaw& slot) {
  check.positive(path + ".width", slot.width);
  check.finite(path + ".angle", slot.angle);
  check_length(check, path, slot);
  check_slot_directions(check, path, slot);
}

void check_penny(const ValueChecker& check, const std::string& path, const Flaw& penny) {
  check.positive(path + ".width", penny.width);
  check_length(check, path, penny);
  if (!penny.normal) {
    check.refuse(path + ".normal", "missing; expected a direction");
  }
  check.direction(path + ".normal", *penny.normal);
}

void check_flaws(const Case& settings) {
  const ValueChecker check(settings);
  for (std::size_t i = 0; i < settings.flaws.size(); ++i) {
    const Flaw& flaw = settings.flaws[i];
    const std::string path = fmt::format("flaw[{}]", i);
    check_word(settings, path + ".shape", flaw.shape);
    check.vector(path + ".center", flaw.center);
    if (flaw.shape == FlawShape::box) {
      check.edges(path + ".size", flaw.size);
      continue;
    }
    check.positive(path + ".length", flaw.length);
    if (flaw.shape == FlawShape::slot) {
      check_slot(check, path, flaw);
    } else if (flaw.shape == FlawShape::penny) {
      check_penny(check, path, flaw);
    }
  }
}

void check_platens(const Case& settings) {
  const ValueChecker check(settings);
  for (std::size_t i = 0; i < settings.platens.size(); ++i) {
    const Platen& platen = settings.platens[i];
    const std::string path = fmt::format("platen[{}]", i);
    check_word(settings, path + ".side", platen.side);
    for (std::size_t other = 0; other < i; ++other) {
      if (settings.platens[other].side == platen.side) {
        check.refuse(path + ".side", fmt::format("\"{}\" is taken by platen[{}]; expected a side "
                                                 "of its own for each platen",
                                                 name_of(platen.side), other));
      }
    }
    check.finite(path + ".speed", platen.speed);
    check.not_negative(path + ".ramp", platen.ramp);
    if (platen.half_width) {
      check.positive(path + ".half_width", *platen.half_width);
    }
  }
}

void check_grid_values(const Case& settings) {
  const ValueChecker check(settings);
  check.positive("grid.cell_size", settings.grid.cell_size);
  check.vector("grid.min", settings.grid.min.value_or(Vector::Zero()));
  check.vector("grid.max", settings.grid.max.value_or(Vector::Zero()));
}

void check_forces(const Case& settings) {
  const ValueChecker check(settings);
  check.finite("damping.local", settings.local_damping);
  if (settings.local_damping < 0.0 || settings.local_damping >= 1.0) {
    check.refuse("damping.local",
                 fmt::format("is {}; expected 0 or more and less than 1", settings.local_damping));
  }
  check.not_negative("viscosity.quadratic", settings.quadratic_viscosity);
  check.not_negative("viscosity.linear", settings.linear_viscosity);
  check.vector("body_force.acceleration", settings.body_acceleration);
}

void check_in_range(const Case& settings, const char* key, int value, int least, int most) {
  if (value < least || value > most) {
    ValueChecker(settings).refuse(key, fmt::format("is {}; expected {} to {}", value, least, most));
  }
}

void check_tuning(const Case& settings) {
  const ValueChecker check(settings);
  const int threads = settings.tuning.threads;
  if (threads < 0 || threads > kMostThreads) {
    check.refuse("tuning.threads",
                 fmt::format("is {}; expected 0, for all, or up to {}", threads, kMostThreads));
  }
  check_in_range(settings, "tuning.bands_per_task", settings.tuning.bands_per_task, 1,
                 kMostBandsPerTask);
  check_in_range(settings, "numerics.band_height", settings.numerics.band_height, kLeastBandHeight,
                 kMostBandHeight);
}

/// What is accepted but does less than it says.
std::vector<std::string> warn_of_output(const Case& settings) {
  std::vector<std::string> warnings;
  const OutputSettings& output = settings.output;
  const auto last = static_cast<std::int64_t>(total_steps(settings));
  std::vector<std::int64_t> beyond;
  std::copy_if(output.snapshot_steps.begin(), output.snapshot_steps.end(),
               std::back_inserter(beyond), [last](std::int64_t step) { return step > last; });
  if (!beyond.empty()) {
    warnings.push_back(complaint(
        settings.source, "output.snapshot_steps",
        fmt::format("no snapshot of {}; the last step is {}", fmt::join(beyond, ", "), last)));
  }
  return warnings;
}

}  // namespace

void check_dimension(const Case& settings) {
  if (settings.dimension != 2 && settings.dimension != 3) {
    refuse(settings.source, "dimension", fmt::format("is {}; expected 2 or 3", settings.dimension));
  }
}

std::vector<std::string> check_case(const Case& settings) {
  check_dimension(settings);
  check_grid_values(settings);
  check_bodies(settings);
  check_flaws(settings);
  check_materials(settings);
  check_platens(settings);
  check_time(settings);
  check_forces(settings);
  check_tuning(settings);
  check_grid(settings);
  std::vector<std::string> warnings = check_bodies_and_flaws(settings);
  for (std::string& warning : warn_of_output(settings)) {
    warnings.push_back(std::move(warning));
  }
  return warnings;
}

}  // namespace rgimp
