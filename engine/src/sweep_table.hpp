#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "rgimp/sweep.hpp"

namespace rgimp {

/// The figures that an output directory holds of a run that ended; none where its summary or
/// history is missing or damaged.
std::optional<SweepFigures> read_figures(const std::filesystem::path& directory);

/// The text of sweep.csv: a header with units and a row for each case, in their order.
std::string format_sweep(const Sweep& sweep, const std::vector<SweepOutcome>& outcomes);

}  // namespace rgimp
