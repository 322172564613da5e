#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

#include "rgimp/simulation.hpp"

namespace rgimp {

/// What to do with an output directory that is not empty; `replace` deletes only our own files.
enum class ExistingOutput { refuse, replace };

/// How far a run is, for a progress display.
struct Progress {
  std::int64_t step = 0;
  std::int64_t total_steps = 0;
  std::size_t particles = 0;
  double seconds = 0.0;  ///< in the step loop, start-up and file output left out
  std::int64_t failed = 0;
};

struct RunOptions {
  std::filesystem::path directory;
  ExistingOutput existing = ExistingOutput::refuse;
  std::function<void(const Progress&)> on_progress;  ///< called a few times a second; may be empty
};

/// Runs a case to its end and writes its output directory: case.toml, history.csv, snapshots/,
/// summary.json. Throws CaseError where the directory exists and is not empty, FileError where it
/// cannot be written, and passes PhysicsError on after the last snapshot, the history and the
/// summary are written.
void run_case(Simulation& simulation, const RunOptions& options);

}  // namespace rgimp
