#pragma once

#include <string>

#include "rgimp/cracks.hpp"

namespace rgimp::cli {

/// Counts, a line for each wing and one for each event, for people.
std::string format_cracks(const Cracks& cracks);

}  // namespace rgimp::cli
