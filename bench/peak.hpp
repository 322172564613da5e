#pragma once

namespace rgimp::bench {

/// Registers "fma/isa:.../threads:..." and "triad/threads:...": what the machine gives at most.
void add_peak_benchmarks();

}  // namespace rgimp::bench
