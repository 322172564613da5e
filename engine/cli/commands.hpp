#pragma once

#include "arguments.hpp"

/// The subcommands of `rgimp`. Errors are exceptions (rgimp/error.hpp).
namespace rgimp::cli {

/// `rgimp run`: runs a case to its end and writes its output directory. Returns the exit code: 0,
/// or 128 and the number of the signal that stopped it.
int run(const RunArguments& arguments);
/// `rgimp check`: says what a run would be, after trying a few steps in memory; writes nothing.
void check(const CaseArguments& arguments);
/// `rgimp cracks`: says how the cracks of an output directory grew.
void show_cracks(const CracksArguments& arguments);
/// `rgimp info`: what this build and machine are.
void info();

}  // namespace rgimp::cli
