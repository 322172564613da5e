#pragma once

#include <string>
#include <vector>

#include "json_output.hpp"
#include "rgimp/sweep.hpp"

namespace rgimp::cli {

/// A line for each case, for people: stress in MPa, closure in mm.
std::string format_outcomes(const Sweep& sweep, const std::vector<SweepOutcome>& outcomes);

/// The same in SI units, for programs.
Json outcomes_json(const Sweep& sweep, const std::vector<SweepOutcome>& outcomes);

}  // namespace rgimp::cli
