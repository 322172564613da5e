#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <iterator>

#include "case_names.hpp"
#include "rgimp/case_file.hpp"

namespace rgimp {
namespace {

std::string toml_string(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      result += '\\';
      result += c;
    } else if (byte < 0x20 || byte == 0x7f) {
      result += fmt::format("\\u{:04X}", byte);
    } else {
      result += c;
    }
  }
  return result + '"';
}

/// A key as it stands in a table's name.
std::string key_text(std::string_view key) {
  const bool bare = !key.empty() && std::all_of(key.begin(), key.end(), [](unsigned char c) {
    return (c < 0x80 && std::isalnum(c) != 0) || c == '-' || c == '_';
  });
  return bare ? std::string(key) : toml_string(key);
}

/// The shortest digits that read back to the same number, and a point so that it stays real.
std::string to_text(double value) {
  std::string digits = fmt::format("{}", value);
  if (digits.find_first_not_of("-0123456789") == std::string::npos) {
    digits += ".0";
  }
  return digits;
}

std::string to_text(int value) {
  return fmt::format("{}", value);
}
std::string to_text(std::int64_t value) {
  return fmt::format("{}", value);
}
std::string to_text(const std::string& value) {
  return toml_string(value);
}
std::string to_text(const std::vector<double>& values) {
  std::vector<std::string> texts;
  texts.reserve(values.size());
  for (const double value : values) {
    texts.push_back(to_text(value));
  }
  return fmt::format("[{}]", fmt::join(texts, ", "));
}
std::string to_text(const std::vector<std::int64_t>& values) {
  return fmt::format("[{}]", fmt::join(values, ", "));
}

template <typename Enum>
requires std::is_enum_v<Enum> std::string to_text(Enum value) {
  return fmt::format("\"{}\"", name_of(value));
}

class CaseWriter {
 public:
  explicit CaseWriter(int dimension) : dimension_(dimension) {}

  int dimension() const { return dimension_; }

  template <typename Enum>
  std::string choices() const {
    return fmt::format("{}", fmt::join(all_names<Enum>(dimension_), " | "));
  }

  void table(std::string_view header) { fmt::format_to(out(), "\n{}\n", header); }

  template <typename Value>
  void line(std::string_view key, const Value& value, std::string_view comment) {
    fmt::format_to(out(), "{:<35} # {}\n", fmt::format("{} = {}", key, to_text(value)), comment);
  }
  void line(std::string_view key, const Vector& value, std::string_view comment) {
    const std::vector<double> components(value.data(), value.data() + dimension_);
    line(key, components, comment);
  }

  /// A key left out is shown as a comment, so that the reader learns of it.
  template <typename Value>
  void line(std::string_view key, const std::optional<Value>& value, std::string_view comment,
            std::string_view when_left_out) {
    if (value) {
      line(key, *value, comment);
    } else {
      fmt::format_to(out(), "{:<35} # {}; left out: {}\n", fmt::format("# {} =", key), comment,
                     when_left_out);
    }
  }

  std::string take() { return std::move(text_); }

 private:
  std::back_insert_iterator<std::string> out() { return std::back_inserter(text_); }

  int dimension_;
  std::string text_;
};

void write_grid(CaseWriter& writer, const GridSettings& grid) {
  writer.table("[grid]");
  writer.line("cell_size", grid.cell_size, "m, edge of a cell");
  writer.line("min", grid.min, "m, lower corner", "five cells beyond the bodies");
  writer.line("max", grid.max, "m, upper corner", "five cells beyond the bodies");
  writer.line("on_exit", grid.on_exit,
              fmt::format("{}, for a particle that leaves the grid", writer.choices<OnExit>()));
}

void write_body(CaseWriter& writer, const Body& body) {
  writer.table("[[body]]");
  writer.line("shape", body.shape, writer.choices<BodyShape>());
  writer.line("center", body.center, "m");
  switch (body.shape) {
    case BodyShape::box:
      writer.line("size", body.size, "m, edges");
      break;
    case BodyShape::disk:
    case BodyShape::sphere:
      writer.line("size", body.size.x(), "m, diameter");
      break;
    case BodyShape::cylinder:
      writer.line("size", std::vector{body.size.x(), body.size.y()}, "m, diameter and height");
      writer.line("axis", body.axis, "direction, of any length");
      break;
  }
  writer.line("material", body.material, "a table below [material]");
  writer.line("particles_per_cell", body.particles_per_cell, "per axis, 2 to 4");
  writer.line("velocity", body.velocity, "m/s, initial");
}

void write_slot(CaseWriter& writer, const Flaw& slot) {
  writer.line("length", slot.length, "m, tip to tip");
  writer.line("width", slot.width, "m, between the faces");
  if (!slot.direction) {
    writer.line("angle", slot.angle, "degrees from +x, counterclockwise");
  }
  if (writer.dimension() == 3) {
    writer.line("direction", slot.direction, "along the length", "by the angle");
    writer.line("normal", slot.normal, "across the width", "by the angle");
    writer.line("depth", slot.depth, "m, at right angles to both", "all through");
  }
  writer.line("ends", slot.ends, writer.choices<SlotEnds>());
}

void write_flaw(CaseWriter& writer, const Flaw& flaw) {
  writer.table("[[flaw]]");
  writer.line("shape", flaw.shape, writer.choices<FlawShape>());
  writer.line("center", flaw.center, "m");
  switch (flaw.shape) {
    case FlawShape::slot:
      write_slot(writer, flaw);
      break;
    case FlawShape::circle:
    case FlawShape::sphere:
      writer.line("length", flaw.length, "m, diameter");
      break;
    case FlawShape::box:
      writer.line("size", flaw.size, "m, edges");
      break;
    case FlawShape::penny:
      writer.line("length", flaw.length, "m, diameter");
      writer.line("width", flaw.width, "m, between the faces");
      writer.line("normal", flaw.normal, "across the width", "not given");
      break;
  }
}

void write_failure(CaseWriter& writer, const std::string& header, const Failure& failure) {
  writer.table(header);
  writer.line("criterion", failure.criterion, writer.choices<Criterion>());
  for (const FailureKey& entry : strengths_of(failure.criterion)) {
    writer.line(entry.key, failure.*entry.member, entry.unit);
  }
  for (const FailureKey& entry : fracture_energies_of(failure.criterion)) {
    writer.line(entry.key, failure.*entry.member, entry.unit);
  }
  writer.line("treatment", failure.treatment, writer.choices<Treatment>());
  for (const FailureKey& entry : limits_of(failure.treatment)) {
    writer.line(entry.key, failure.*entry.member, entry.unit);
  }
}

void write_material(CaseWriter& writer, const std::string& name, const Material& material) {
  const std::string path = fmt::format("material.{}", key_text(name));
  writer.table(fmt::format("[{}]", path));
  writer.line("density", material.density, "kg/m3");
  writer.line("youngs_modulus", material.youngs_modulus, "Pa");
  writer.line("poisson_ratio", material.poisson_ratio, "1");
  if (material.failure) {
    write_failure(writer, fmt::format("[{}.failure]", path), *material.failure);
  }
}

void write_platen(CaseWriter& writer, const Platen& platen) {
  writer.table("[[platen]]");
  writer.line("side", platen.side, writer.choices<Side>());
  writer.line("speed", platen.speed, "m/s, towards the specimen; 0 holds it");
  writer.line("ramp", platen.ramp, "s, from rest to the speed");
  writer.line("lateral", platen.lateral, writer.choices<Lateral>());
  writer.line("half_width", platen.half_width, "m, of the contact about the bodies' centre",
              "the whole side");
}

void write_time(CaseWriter& writer, const TimeSettings& time) {
  writer.table("[time]");
  writer.line("steps", time.steps, "1", "duration is given");
  writer.line("duration", time.duration, "s", "steps are given");
  writer.line("step_factor", time.step_factor, "1, of the time a wave takes through a cell");
  writer.line("integrator", time.integrator, writer.choices<Integrator>());
}

void write_forces(CaseWriter& writer, const Case& settings) {
  writer.table("[damping]");
  writer.line("local", settings.local_damping, "1, of the force on a node");
  writer.table("[viscosity]");
  writer.line("quadratic", settings.quadratic_viscosity, "1");
  writer.line("linear", settings.linear_viscosity, "1");
  writer.table("[body_force]");
  writer.line("acceleration", settings.body_acceleration, "m/s2");
}

void write_output(CaseWriter& writer, const OutputSettings& output) {
  writer.table("[output]");
  writer.line("history_every", output.history_every, "steps");
  writer.line("snapshot_every", output.snapshot_every, "steps", "no regular snapshots");
  writer.line("snapshot_steps", output.snapshot_steps, "besides the first and the last");
  writer.line("checkpoint_every", output.checkpoint_every, "steps", "every ten minutes");
}

}  // namespace

std::string write_case(const Case& settings) {
  CaseWriter writer(settings.dimension);
  writer.line("title", settings.title, "free text");
  writer.line("dimension", settings.dimension,
              settings.dimension == 3 ? "a solid" : "plane strain, unit thickness");
  write_grid(writer, settings.grid);
  for (const Body& body : settings.bodies) {
    write_body(writer, body);
  }
  for (const Flaw& flaw : settings.flaws) {
    write_flaw(writer, flaw);
  }
  for (const auto& [name, material] : settings.materials) {
    write_material(writer, name, material);
  }
  for (const Platen& platen : settings.platens) {
    write_platen(writer, platen);
  }
  write_time(writer, settings.time);
  write_forces(writer, settings);
  write_output(writer, settings.output);
  writer.table("[numerics]");
  writer.line("band_height", settings.numerics.band_height, "rows; changes round-off");
  writer.table("[tuning]");
  writer.line("threads", settings.tuning.threads, "0: all; never changes a bit of the result");
  writer.line("bands_per_task", settings.tuning.bands_per_task, "never changes a bit either");
  return writer.take();
}

}  // namespace rgimp
