#include "rgimp/case_file.hpp"

#include <algorithm>
#include <array>

#include "case_check.hpp"
#include "case_names.hpp"
#include "toml_document.hpp"
#include "toml_reader.hpp"
#include "unchecked_case.hpp"

namespace rgimp {
namespace {

using Keys = std::vector<std::string_view>;

/// Refuses keys that the table knows but that a choice made in it leaves without meaning.
void allow_for_choice(const TomlReader& reader, std::span<const std::string_view> candidates,
                      std::span<const std::string_view> read, const std::string& choice) {
  const std::string reads =
      read.empty() ? std::string() : fmt::format(", which reads {}", fmt::join(read, ", "));
  for (const std::string_view key : candidates) {
    const bool is_read = std::find(read.begin(), read.end(), key) != read.end();
    if (!is_read && reader.has(key)) {
      reader.refuse(key, fmt::format("not read by {}{}", choice, reads));
    }
  }
}

void read_grid(const TomlReader& reader, GridSettings& grid) {
  reader.allow_only(Keys{"cell_size", "min", "max", "on_exit"});
  reader.require("cell_size", grid.cell_size);
  reader.accept("min", grid.min);
  reader.accept("max", grid.max);
  reader.accept("on_exit", grid.on_exit);
}

Body read_body(const TomlReader& reader) {
  Body body;
  reader.allow_only(
      Keys{"shape", "center", "size", "axis", "material", "particles_per_cell", "velocity"});
  reader.require("shape", body.shape);
  reader.require("center", body.center);
  switch (body.shape) {
    case BodyShape::box:
      reader.require("size", body.size);
      break;
    case BodyShape::disk:
    case BodyShape::sphere:
      reader.require("size", body.size.x());
      break;
    case BodyShape::cylinder: {
      TomlReader::Pair diameter_and_height{};
      reader.require("size", diameter_and_height);
      body.size = {diameter_and_height[0], diameter_and_height[1], 0.0};
      reader.accept("axis", body.axis);
      break;
    }
  }
  if (body.shape != BodyShape::cylinder && reader.has("axis")) {
    reader.refuse("axis", fmt::format("not read by shape \"{}\"", name_of(body.shape)));
  }
  reader.require("material", body.material);
  reader.accept("particles_per_cell", body.particles_per_cell);
  reader.accept("velocity", body.velocity);
  return body;
}

void read_slot(const TomlReader& reader, Flaw& slot) {
  reader.require("length", slot.length);
  reader.require("width", slot.width);
  reader.accept("angle", slot.angle);
  reader.accept("direction", slot.direction);
  reader.accept("normal", slot.normal);
  reader.accept("depth", slot.depth);
  reader.accept("ends", slot.ends);
  if (slot.direction && reader.has("angle")) {
    reader.refuse("direction", "given besides angle; expected one of them");
  }
}

Flaw read_flaw(const TomlReader& reader) {
  Flaw flaw;
  const Keys dimensions{"length", "width", "angle", "direction", "normal", "depth", "ends", "size"};
  Keys known{"shape", "center"};
  known.insert(known.end(), dimensions.begin(), dimensions.end());
  reader.allow_only(known);
  reader.require("shape", flaw.shape);
  allow_for_choice(reader, dimensions, dimensions_of(flaw.shape, reader.dimension()),
                   fmt::format("shape \"{}\"", name_of(flaw.shape)));
  reader.require("center", flaw.center);
  switch (flaw.shape) {
    case FlawShape::slot:
      read_slot(reader, flaw);
      break;
    case FlawShape::circle:
    case FlawShape::sphere:
      reader.require("length", flaw.length);
      break;
    case FlawShape::box:
      reader.require("size", flaw.size);
      break;
    case FlawShape::penny:
      reader.require("length", flaw.length);
      reader.require("width", flaw.width);
      reader.require("normal", flaw.normal.emplace());
      break;
  }
  return flaw;
}

/// The numbers that a criterion or a treatment reads, all of which must be there.
void read_numbers(const TomlReader& reader, std::span<const FailureKey> entries,
                  const std::string& choice, Failure& failure) {
  for (const FailureKey& entry : entries) {
    if (!reader.has(entry.key)) {
      reader.refuse(entry.key,
                    fmt::format("missing; {} reads {}", choice, fmt::join(keys_of(entries), ", ")));
    }
    reader.require(entry.key, failure.*entry.member);
  }
}

Failure read_failure(const TomlReader& reader) {
  Failure failure;
  const Keys strengths = keys_of(all_strengths());
  const Keys energies = keys_of(fracture_energies_of(Criterion::mohr_coulomb));
  const Keys limits = keys_of(limits_of(Treatment::pressure_window));
  Keys known{"criterion", "treatment"};
  known.insert(known.end(), strengths.begin(), strengths.end());
  known.insert(known.end(), energies.begin(), energies.end());
  known.insert(known.end(), limits.begin(), limits.end());
  reader.allow_only(known);

  reader.require("criterion", failure.criterion);
  const std::string criterion = fmt::format("criterion \"{}\"", name_of(failure.criterion));
  const std::span<const FailureKey> used = strengths_of(failure.criterion);
  allow_for_choice(reader, strengths, keys_of(used), criterion);
  read_numbers(reader, used, criterion, failure);
  const std::span<const FailureKey> softening = fracture_energies_of(failure.criterion);
  allow_for_choice(reader, energies, keys_of(softening), criterion);
  for (const FailureKey& entry : softening) {
    reader.accept(entry.key, failure.*entry.member);
  }

  reader.accept("treatment", failure.treatment);
  const std::string treatment = fmt::format("treatment \"{}\"", name_of(failure.treatment));
  const std::span<const FailureKey> window = limits_of(failure.treatment);
  allow_for_choice(reader, limits, keys_of(window), treatment);
  read_numbers(reader, window, treatment, failure);
  return failure;
}

Material read_material(const TomlReader& reader) {
  Material material;
  reader.allow_only(Keys{"density", "youngs_modulus", "poisson_ratio", "failure"});
  reader.require("density", material.density);
  reader.require("youngs_modulus", material.youngs_modulus);
  reader.require("poisson_ratio", material.poisson_ratio);
  if (const auto failure = reader.table_if_any("failure")) {
    material.failure = read_failure(*failure);
  }
  return material;
}

Platen read_platen(const TomlReader& reader) {
  Platen platen;
  reader.allow_only(Keys{"side", "speed", "ramp", "lateral", "half_width"});
  reader.require("side", platen.side);
  reader.require("speed", platen.speed);
  reader.accept("ramp", platen.ramp);
  reader.accept("lateral", platen.lateral);
  reader.accept("half_width", platen.half_width);
  return platen;
}

void read_time(const TomlReader& reader, TimeSettings& time) {
  reader.allow_only(Keys{"steps", "duration", "step_factor", "integrator"});
  reader.accept("steps", time.steps);
  reader.accept("duration", time.duration);
  reader.accept("step_factor", time.step_factor);
  reader.accept("integrator", time.integrator);
}

void read_output(const TomlReader& reader, OutputSettings& output) {
  reader.allow_only(Keys{"history_every", "snapshot_every", "snapshot_steps", "checkpoint_every"});
  reader.accept("history_every", output.history_every);
  reader.accept("snapshot_every", output.snapshot_every);
  reader.accept("snapshot_steps", output.snapshot_steps);
  reader.accept("checkpoint_every", output.checkpoint_every);
}

/// A table of optional values all of one type.
template <typename Value>
struct Entry {
  std::string_view key;
  Value& target;
};

template <typename Value>
void read_optional_table(const TomlReader& root, std::string_view name,
                         std::initializer_list<Entry<Value>> entries) {
  const auto reader = root.table_if_any(name);
  if (!reader) {
    return;
  }
  Keys known;
  for (const Entry<Value>& entry : entries) {
    known.push_back(entry.key);
  }
  reader->allow_only(known);
  for (const Entry<Value>& entry : entries) {
    reader->accept(entry.key, entry.target);
  }
}

void read_tables(const TomlReader& root, Case& settings) {
  for (const TomlReader& body : root.tables("body")) {
    settings.bodies.push_back(read_body(body));
  }
  for (const TomlReader& flaw : root.tables("flaw")) {
    settings.flaws.push_back(read_flaw(flaw));
  }
  if (const auto materials = root.table_if_any("material")) {
    for (const std::string& name : materials->keys()) {
      settings.materials[name] = read_material(materials->table(name));
    }
  }
  for (const TomlReader& platen : root.tables("platen")) {
    settings.platens.push_back(read_platen(platen));
  }
}

}  // namespace

Case parse_case(const std::string& text, const std::filesystem::path& path,
                std::span<const std::string> overrides) {
  const TomlDocument document = parse_document(text, path, overrides);
  Case settings;
  settings.source = document.source;
  const TomlReader file(document.root, "", document.source, settings.dimension);
  file.allow_only(Keys{"title", "dimension", "grid", "body", "flaw", "material", "platen", "time",
                       "damping", "viscosity", "body_force", "output", "numerics", "tuning"});
  file.accept("title", settings.title);
  file.accept("dimension", settings.dimension);
  // Before any vector is read, for its length follows from it.
  check_dimension(settings);
  const TomlReader root(document.root, "", document.source, settings.dimension);
  read_grid(root.table("grid"), settings.grid);
  read_tables(root, settings);
  read_time(root.table("time"), settings.time);
  read_optional_table<double>(root, "damping", {{"local", settings.local_damping}});
  read_optional_table<double>(
      root, "viscosity",
      {{"quadratic", settings.quadratic_viscosity}, {"linear", settings.linear_viscosity}});
  read_optional_table<Vector>(root, "body_force", {{"acceleration", settings.body_acceleration}});
  if (const auto output = root.table_if_any("output")) {
    read_output(*output, settings.output);
  }
  read_optional_table<int>(root, "numerics", {{"band_height", settings.numerics.band_height}});
  read_optional_table<int>(
      root, "tuning",
      {{"threads", settings.tuning.threads}, {"bands_per_task", settings.tuning.bands_per_task}});
  return settings;
}

Case read_case(const std::filesystem::path& path, std::span<const std::string> overrides) {
  Case settings = parse_case(read_text(path), path, overrides);
  check_case(settings);
  return settings;
}

}  // namespace rgimp
