#pragma once

#include <string>

#include "setting.hpp"

namespace rgimp::bench {

/// Empty where energies and reaction after some steps equal the scalar reference's on one thread,
/// else what differs. Each setting is computed once a run.
const std::string& difference_from_reference(const Setting& setting);

}  // namespace rgimp::bench
