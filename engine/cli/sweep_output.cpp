#include "sweep_output.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "format.hpp"

namespace rgimp::cli {

namespace {

using Line = std::vector<std::string>;

std::string mode_name(FailureMode mode) {
  return mode == FailureMode::tension ? "tension" : "shear";
}

Line figure_cells(const SweepFigures& figures) {
  const auto& failure = figures.first_failure;
  return {fmt::format("{:.3f}", figures.peak_axial_stress * 1e-6),
          fmt::format("{:.4f}", figures.closure_at_peak * 1e3),
          failure ? with_separators(failure->step) : "-",
          failure ? fmt::format("{:.4f}", failure->closure * 1e3) : "-",
          failure ? fmt::format("{:.3f}", failure->axial_stress * 1e-6) : "-",
          failure ? mode_name(failure->mode) : "none",
          with_separators(figures.failed_tension),
          with_separators(figures.failed_shear),
          fmt::format("{:.1e}", figures.energy_error),
          format_duration(figures.wall_seconds)};
}

/// Columns as wide as their widest cell, numbers to the right.
std::string align(const std::vector<Line>& lines) {
  std::vector<std::size_t> widths(lines.front().size());
  for (const Line& line : lines) {
    for (std::size_t i = 0; i < line.size(); ++i) {
      widths[i] = std::max(widths[i], line[i].size());
    }
  }
  std::string text;
  for (const Line& line : lines) {
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      text += fmt::format("{:>{}}  ", line[i], widths[i]);
    }
    text += line.back() + "\n";
  }
  return text;
}

Json to_json(const std::optional<FirstFailure>& failure) {
  if (!failure) {
    return {};
  }
  const Vector& at = failure->position;
  return {{"step", failure->step},
          {"closure_m", failure->closure},
          {"axial_stress_Pa", failure->axial_stress},
          {"position_m", {at.x(), at.y(), at.z()}},
          {"mode", mode_name(failure->mode)}};
}

}  // namespace

std::string format_outcomes(const Sweep& sweep, const std::vector<SweepOutcome>& outcomes) {
  Line header{"case"};
  for (const SweepRange& range : sweep.ranges) {
    header.push_back(printable(range.key));
  }
  for (const char* name : {"peak (MPa)", "at (mm)", "first failure", "at (mm)", "(MPa)", "mode",
                           "tension", "shear", "energy error", "wall", "status"}) {
    header.emplace_back(name);
  }
  std::vector<Line> lines{header};
  for (std::size_t i = 0; i < sweep.cases.size(); ++i) {
    const SweepOutcome& outcome = outcomes[i];
    Line line{sweep.cases[i].name};
    for (const std::string& value : sweep.cases[i].values) {
      line.push_back(printable(value));
    }
    const Line figures = outcome.figures ? figure_cells(*outcome.figures) : Line(10, "-");
    line.insert(line.end(), figures.begin(), figures.end());
    line.push_back(printable(std::string(describe(outcome.status)) +
                             (outcome.message.empty() ? "" : ": " + outcome.message)));
    lines.push_back(line);
  }
  return align(lines);
}

Json outcomes_json(const Sweep& sweep, const std::vector<SweepOutcome>& outcomes) {
  Json cases = Json::array();
  for (std::size_t i = 0; i < sweep.cases.size(); ++i) {
    const SweepOutcome& outcome = outcomes[i];
    Json set = Json::object();
    for (std::size_t range = 0; range < sweep.ranges.size(); ++range) {
      set[sweep.ranges[range].key] = number_or_text(sweep.cases[i].values[range]);
    }
    Json one{{"case", sweep.cases[i].name},
             {"set", set},
             {"status", describe(outcome.status)},
             {"message", outcome.message}};
    if (outcome.figures) {
      const SweepFigures& figures = *outcome.figures;
      one["peak_axial_stress_Pa"] = figures.peak_axial_stress;
      one["closure_at_peak_m"] = figures.closure_at_peak;
      one["first_failure"] = to_json(figures.first_failure);
      one["failed_tension"] = figures.failed_tension;
      one["failed_shear"] = figures.failed_shear;
      one["energy_error"] = figures.energy_error;
      one["wall_s"] = figures.wall_seconds;
    }
    cases.push_back(one);
  }
  return cases;
}

}  // namespace rgimp::cli
