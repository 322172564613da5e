#include "sweep_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <limits>
#include <sstream>

#include "input_file.hpp"
#include "json.hpp"
#include "rgimp/error.hpp"

namespace rgimp {

namespace fs = std::filesystem;

namespace {

constexpr double kMillimetres = 1e3;   // of a metre
constexpr double kMegapascals = 1e-6;  // of a pascal

/// Of an RFC 4180 file: quoted where it has to be.
std::string csv_field(std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) {
    return std::string(text);
  }
  std::string quoted = "\"";
  for (const char c : text) {
    quoted += c == '"' ? "\"\"" : std::string(1, c);
  }
  return quoted + '"';
}

double column_value(std::string_view row, int column) {
  for (int i = 0; i < column; ++i) {
    row.remove_prefix(std::min(row.find(','), row.size() - 1) + 1);
  }
  const std::string_view field = row.substr(0, row.find(','));
  double value = std::numeric_limits<double>::quiet_NaN();
  std::from_chars(field.data(), field.data() + field.size(), value);
  return value;
}

/// m, at the row of the largest stress.
double closure_at_peak(const std::string& history) {
  constexpr int closure_column = 2;
  constexpr int stress_column = 3;
  std::istringstream lines(history);
  std::string row;
  std::getline(lines, row);  // the header
  double closure = 0.0;
  double peak = 0.0;
  while (std::getline(lines, row)) {
    const double stress = column_value(row, stress_column);
    if (stress > peak) {
      peak = stress;
      closure = column_value(row, closure_column);
    }
  }
  return closure;
}

FirstFailure first_failure(const Json& json) {
  FirstFailure failure;
  failure.step = json.at("step").get<std::int64_t>();
  failure.closure = json.at("closure_m").get<double>();
  failure.axial_stress = json.at("axial_stress_Pa").get<double>();
  const Json& position = json.at("position_m");
  failure.position = Vector(position.at(0).get<double>(), position.at(1).get<double>(),
                            position.at(2).get<double>());
  failure.mode = json.at("mode") == "tension" ? FailureMode::tension : FailureMode::shear;
  return failure;
}

std::string format_figures(const SweepFigures& figures) {
  const auto& failure = figures.first_failure;
  const std::string of_failure =
      failure ? fmt::format("{},{:.6g},{:.6g},{}", failure->step, failure->closure * kMillimetres,
                            failure->axial_stress * kMegapascals,
                            failure->mode == FailureMode::tension ? "tension" : "shear")
              : ",,,none";
  return fmt::format("{:.6g},{:.6g},{},{},{},{:.3g},{:.3f}",
                     figures.peak_axial_stress * kMegapascals,
                     figures.closure_at_peak * kMillimetres, of_failure, figures.failed_tension,
                     figures.failed_shear, figures.energy_error, figures.wall_seconds);
}

}  // namespace

std::optional<SweepFigures> read_figures(const fs::path& directory) {
  try {
    const Json summary = Json::parse(read_bytes(directory / "summary.json"));
    SweepFigures figures;
    figures.peak_axial_stress = summary.at("peak_axial_stress_Pa").get<double>();
    figures.closure_at_peak = closure_at_peak(read_bytes(directory / "history.csv"));
    if (!summary.at("first_failure").is_null()) {
      figures.first_failure = first_failure(summary.at("first_failure"));
    }
    figures.failed_tension = summary.at("failed_tension").get<std::int64_t>();
    figures.failed_shear = summary.at("failed_shear").get<std::int64_t>();
    figures.energy_error = summary.at("energy_error").get<double>();
    figures.wall_seconds = summary.at("wall_s").get<double>();
    return figures;
  } catch (const FileError&) {
    return std::nullopt;
  } catch (const nlohmann::json::exception&) {  // a number that is none is null there
    return std::nullopt;
  }
}

std::string format_sweep(const Sweep& sweep, const std::vector<SweepOutcome>& outcomes) {
  std::string text = "case";
  for (const SweepRange& range : sweep.ranges) {
    text += fmt::format(",{}", csv_field(range.key));
  }
  text +=
      ",peak_axial_stress_MPa,closure_at_peak_mm,first_failure_step,first_failure_closure_mm,"
      "first_failure_axial_stress_MPa,first_failure_mode,failed_tension,failed_shear,energy_error,"
      "wall_s,status,message\n";
  for (std::size_t i = 0; i < sweep.cases.size(); ++i) {
    const SweepOutcome& outcome = outcomes[i];
    text += sweep.cases[i].name;
    for (const std::string& value : sweep.cases[i].values) {
      text += fmt::format(",{}", csv_field(value));
    }
    text += fmt::format(",{}", outcome.figures ? format_figures(*outcome.figures) : ",,,,,,,,,");
    text += fmt::format(",{},{}\n", describe(outcome.status), csv_field(outcome.message));
  }
  return text;
}

}  // namespace rgimp
