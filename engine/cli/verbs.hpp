#pragma once

namespace CLI {
class App;
}

/// The verbs of `rgimp`, a file each: its options, its help and what it does. CLI11 runs a verb
/// while it parses; what it ends with goes to `exit_code`. Errors are exceptions (rgimp/error.hpp).
namespace rgimp::cli {

/// `rgimp new`: writes a case file to start from.
void add_new(CLI::App& app);
/// `rgimp run`: runs a case to its end and writes its output directory.
void add_run(CLI::App& app, int& exit_code);
/// `rgimp check`: says what a run would be, after trying a few steps in memory.
void add_check(CLI::App& app, int& exit_code);
/// `rgimp sweep`: runs a case for every combination of some of its values.
void add_sweep(CLI::App& app, int& exit_code);
/// `rgimp cracks`: says how the cracks of an output directory grew.
void add_cracks(CLI::App& app);
/// `rgimp grid`: writes node fields of an output directory's snapshots.
void add_grid(CLI::App& app);
/// `rgimp report`: has rgimp-report write a page about an output directory.
void add_report(CLI::App& app, int& exit_code);
/// `rgimp info`: what this build and machine are.
void add_info(CLI::App& app);

}  // namespace rgimp::cli
