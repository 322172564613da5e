#pragma once

namespace rgimp::bench {

/// What a program of this folder measures; main() runs it.
void add_benchmarks();

}  // namespace rgimp::bench
