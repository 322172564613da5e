#pragma once

#include <benchmark/benchmark.h>

#include "setting.hpp"

namespace rgimp::bench {

/// Registers "prefix/name(setting)": holds the setting against the scalar reference, then times
/// its steps.
void add_step_benchmark(const char* prefix, const Setting& setting);

}  // namespace rgimp::bench
