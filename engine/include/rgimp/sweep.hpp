#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "rgimp/case.hpp"
#include "rgimp/run.hpp"

/// A sweep: one case run for every combination of some of its values, several at once.
namespace rgimp {

/// A key that a sweep varies.
struct SweepRange {
  std::string key;                  ///< "flaw[0].angle"
  std::vector<std::string> values;  ///< as TOML texts
};

/// One combination.
struct SweepCase {
  std::string name;                 ///< "001", the first; also of its directory
  std::vector<std::string> values;  ///< one for each range
  Case settings;                    ///< with these values
};

/// The product of some ranges.
struct Sweep {
  std::vector<SweepRange> ranges;  ///< in the order in which they were given
  std::vector<SweepCase> cases;    ///< the last range varies fastest
};

/// Reads a case file once for every combination of the ranges among `overrides`, which are those of
/// read_case or give several values: "key=START:STOP:STEP", numbers with STOP among them where it
/// is reached within round-off, and "key=A|B|C", TOML values. Cases compute with one thread each,
/// which is fastest while there are as many cases as cores, unless an override of tuning.threads
/// says otherwise. Throws FileError where the file
/// cannot be read; CaseError for a range that is none, where there is no range at all, and for a
/// case that cannot be run: its message names the combination.
Sweep read_sweep(const std::filesystem::path& path, std::span<const std::string> overrides);

/// "flaw[0].angle=30, grid.cell_size=1e-3"
std::string describe(const Sweep& sweep, const SweepCase& one);

/// What a case of a sweep came to, from its output directory.
struct SweepFigures {
  double peak_axial_stress = 0.0;  ///< Pa, compression > 0, largest over all steps
  double closure_at_peak = 0.0;    ///< m, at the row of history.csv with the largest stress
  std::optional<FirstFailure> first_failure;  ///< none: nothing failed
  std::int64_t failed_tension = 0;            ///< particles at the end
  std::int64_t failed_shear = 0;              ///< likewise
  double energy_error = 0.0;                  ///< 1, as in summary.json
  double wall_seconds = 0.0;                  ///< of the process that ended it, start-up left out
};

/// How a case of a sweep is doing.
enum class SweepStatus {
  pending,          ///< it has not come to an end
  finished,         ///< all its steps are done
  stopped,          ///< on request, with a checkpoint
  physics_stopped,  ///< by a PhysicsError
  failed            ///< by any other error: it could not be run, or not be written
};

/// "physics stopped"
std::string_view describe(SweepStatus status);

/// What became of a case of a sweep.
struct SweepOutcome {
  SweepStatus status = SweepStatus::pending;  ///< how it ended, if it did
  std::string message;                        ///< why it did not finish
  std::optional<SweepFigures> figures;  ///< of a case that finished or that the physics stopped
};

/// How far a sweep is, in cases: 2.5 are two whole ones and half of another.
struct SweepProgress {
  std::size_t cases = 0;    ///< in all
  std::size_t ended = 0;    ///< whole ones, however they ended
  std::size_t running = 0;  ///< now
  double done = 0.0;        ///< of all cases, parts of them too
  double computed = 0.0;    ///< of `done`, what this call computed itself
  double seconds = 0.0;     ///< since its start
};

/// How a sweep is run.
struct SweepOptions {
  std::filesystem::path directory;  ///< of sweep.csv and of the cases' directories
  /// What to do where that directory is not empty.
  ExistingOutput existing = ExistingOutput::refuse;
  int jobs = 1;  ///< cases at once, each with its Tuning::threads
  /// Called a few times a second, by one thread at a time; may be empty.
  std::function<void(const SweepProgress&)> on_progress;
  /// What a user should know and is no error, by one thread at a time; may be empty.
  std::function<void(const std::string&)> on_notice;
  /// Asked a few times a second, by any thread; true ends every running case with a checkpoint and
  /// starts no other. May be empty.
  std::function<bool()> stop_requested;
};

/// Runs every case as run_case does, each in a directory of its own, and keeps a table of them all
/// in sweep.csv, which is written anew, whole, whenever a case ends. Results do not depend on how
/// many run at once. `replace` clears what an earlier sweep left; `resume` skips what is finished
/// and goes on with the rest. A case that fails is an outcome and keeps no other from running.
/// Throws, before the first one runs, CaseError where the directory must be empty and is not,
/// another sweep is at work in it, it holds another sweep's cases, or the cases at once take more
/// memory than there is; FileError where the directory or, at any time, the table cannot be
/// written.
std::vector<SweepOutcome> run_sweep(const Sweep& sweep, const SweepOptions& options);

}  // namespace rgimp
