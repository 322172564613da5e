#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

#include "rgimp/simulation.hpp"

namespace rgimp {

/// What to do with an output directory that is not empty; `replace` deletes only our own files,
/// `resume` goes on from the newest checkpoint in it that is whole.
enum class ExistingOutput { refuse, replace, resume };

/// How far a run is, for a progress display.
struct Progress {
  /// Steps done.
  std::int64_t step = 0;
  std::int64_t first_step = 0;  ///< where this run started: 0, or the checkpoint's
  /// Of the case.
  std::int64_t total_steps = 0;
  /// Now.
  std::size_t particles = 0;
  double seconds = 0.0;  ///< in the step loop, start-up and file output left out
  /// Particles, in tension and shear.
  std::int64_t failed = 0;
};

/// How and where run_case runs.
struct RunOptions {
  /// Made where there is none, parents too.
  std::filesystem::path directory;
  /// Of a directory that is not empty.
  ExistingOutput existing = ExistingOutput::refuse;
  std::function<void(const Progress&)> on_progress;  ///< called a few times a second; may be empty
  /// What a user should know and is no error: a damaged checkpoint, a start from step 0. May be
  /// empty.
  std::function<void(const std::string&)> on_notice;
  /// Between checkpoints, in computing time, where OutputSettings::checkpoint_every is left out.
  std::chrono::duration<double> checkpoint_pace = std::chrono::minutes(10);
  /// Asked a few times a second; true ends the run with a checkpoint. May be empty.
  std::function<bool()> stop_requested;
};

/// How a run came to its end: all steps done, stopped on request, or nothing left to do.
enum class RunEnd { finished, stopped, was_finished };

/// Runs a case to its end and writes its output directory: case.toml, history.csv, snapshots/,
/// checkpoints, summary.json. Checkpoints come at their pace, and when the run is stopped on
/// request. A resumed run leaves the files of one that was never interrupted, but for the summary's
/// times and threads. Throws CaseError where the directory is not empty and must be, where another
/// run is at work in it, and where it holds another case's; FileError where it cannot be written or
/// none of its checkpoints can be used; and passes PhysicsError on after the last snapshot, the
/// history and the summary are written.
RunEnd run_case(Simulation& simulation, const RunOptions& options);

}  // namespace rgimp
