#pragma once

#include <optional>

#include "rgimp/sweep.hpp"

namespace rgimp {

/// Throws CaseError where the largest `jobs` cases together take more than these bytes; none:
/// nothing is known, nothing refused.
void check_memory(const Sweep& sweep, int jobs, std::optional<double> available_bytes);

}  // namespace rgimp
