#include "rgimp/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <system_error>
#include <vector>

#include "atomic_file.hpp"
#include "history_file.hpp"
#include "output_directory.hpp"
#include "output_schedule.hpp"
#include "rgimp/case_file.hpp"
#include "rgimp/error.hpp"
#include "snapshot.hpp"
#include "summary.hpp"

namespace rgimp {

namespace {

constexpr double kProgressPace = 0.2;  // s between two calls of on_progress

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// The files of one run, each written when the schedule asks for it.
class Recorder {
 public:
  Recorder(const Simulation& simulation, OutputDirectory& directory)
      : simulation_(simulation),
        directory_(directory),
        schedule_(simulation.settings().output, simulation.facts().total_steps),
        history_(directory.history_file()) {}

  const OutputSchedule& schedule() const { return schedule_; }
  const HistoryRow& first_row() const { return first_row_; }
  const HistoryRow& last_row() const { return last_row_; }
  double largest_work() const { return largest_work_; }

  void write_due() {
    const std::int64_t step = simulation_.steps_done();
    if (schedule_.writes_history(step)) {
      write_history();
    }
    if (schedule_.writes_snapshot(step)) {
      write_snapshot();
    }
  }

  /// Whatever the schedule says: for the first step, and the last where the physics stopped early.
  void write_all() {
    const std::int64_t step = simulation_.steps_done();
    if (!history_step_ || *history_step_ != step) {
      write_history();
    }
    if (snapshots_.empty() || snapshots_.back().step != step) {
      write_snapshot();
    }
  }

  void close() { history_.close(); }

 private:
  void write_history() {
    last_row_ = simulation_.history();
    largest_work_ = std::max(largest_work_, std::abs(last_row_.external_work));
    history_.append(last_row_);
    if (!history_step_) {
      first_row_ = last_row_;
    }
    history_step_ = last_row_.step;
  }

  void write_snapshot() {
    const SnapshotTime now{simulation_.steps_done(), simulation_.time()};
    rgimp::write_snapshot(directory_.snapshot_file(now.step), simulation_.particles(), now);
    snapshots_.push_back(now);
    write_series(directory_.series_file(), snapshots_);
  }

  const Simulation& simulation_;
  OutputDirectory& directory_;
  OutputSchedule schedule_;
  HistoryFile history_;
  HistoryRow first_row_;
  HistoryRow last_row_;
  std::optional<std::int64_t> history_step_;
  std::vector<SnapshotTime> snapshots_;
  double largest_work_ = 0.0;  // J
};

/// Advances a simulation, timing nothing but its steps, and reports progress at an even pace.
class StepLoop {
 public:
  StepLoop(Simulation& simulation, const RunOptions& options)
      : simulation_(simulation), options_(options), facts_(simulation.facts()) {}

  void run_until(std::int64_t stop) {
    while (simulation_.steps_done() < stop) {
      run_chunk(stop);
      if (seconds_since(last_report_) >= kProgressPace) {
        report();
      }
    }
  }

  void report() {
    last_report_ = Clock::now();
    if (!options_.on_progress) {
      return;
    }
    const HistoryRow row = simulation_.history();
    options_.on_progress({row.step, facts_.total_steps, facts_.particles, seconds_,
                          row.failed_tension + row.failed_shear});
  }

  double particle_steps_per_second() const {
    const double work = static_cast<double>(steps_) * static_cast<double>(facts_.particles);
    return seconds_ > 0.0 ? work / seconds_ : 0.0;
  }

 private:
  void run_chunk(std::int64_t stop) {
    const std::int64_t start = simulation_.steps_done();
    const Clock::time_point begin = Clock::now();
    simulation_.run_until(std::min(stop, start + chunk_.steps()));
    const double seconds = seconds_since(begin);
    const std::int64_t steps = simulation_.steps_done() - start;
    seconds_ += seconds;
    steps_ += steps;
    chunk_.learn(steps, seconds);
  }

  Simulation& simulation_;
  const RunOptions& options_;
  Facts facts_;
  ChunkSize chunk_{kProgressPace};
  Clock::time_point last_report_ = Clock::now();
  double seconds_ = 0.0;    // in steps_
  std::int64_t steps_ = 0;  // of finished chunks
};

Summary summarize(const Simulation& simulation, const StepLoop& loop, const Recorder& recorder) {
  const Facts facts = simulation.facts();
  const HistoryRow& row = recorder.last_row();
  Summary summary;
  summary.particles = facts.particles;
  summary.steps = simulation.steps_done();
  summary.dt = facts.dt;
  summary.particle_steps_per_second = loop.particle_steps_per_second();
  summary.isa = facts.isa;
  summary.threads = facts.threads;
  summary.first_failure = simulation.first_failure();
  summary.failed_tension = row.failed_tension;
  summary.failed_shear = row.failed_shear;
  summary.peak_axial_stress = simulation.peak_axial_stress();
  summary.energy_error = energy_error(recorder.first_row(), row, recorder.largest_work());
  summary.state_hash = simulation.state_hash();
  return summary;
}

/// A case file written by hand as DIR/case.toml would be lost to the resolved one.
void protect_source(const Case& settings, const std::filesystem::path& directory) {
  std::error_code ignored;  // neither has to exist
  if (std::filesystem::equivalent(settings.source.path, directory / "case.toml", ignored)) {
    throw CaseError(
        fmt::format("output directory '{}' would overwrite the case file '{}': choose another one",
                    directory.string(), settings.source.path.string()));
  }
}

class Run {
 public:
  Run(Simulation& simulation, const RunOptions& options)
      : simulation_(simulation),
        directory_(options.directory, options.existing),
        recorder_(simulation, directory_),
        loop_(simulation, options) {
    write_file(directory_.case_file(), write_case(simulation.settings()));
    recorder_.write_all();
    directory_.keep();
  }

  void execute() {
    loop_.report();
    try {
      compute();
    } catch (const PhysicsError& error) {
      save_after(error);
      throw;
    }
    finish();
  }

 private:
  void compute() {
    const std::int64_t total = simulation_.facts().total_steps;
    while (simulation_.steps_done() < total) {
      loop_.run_until(recorder_.schedule().next_stop(simulation_.steps_done()));
      recorder_.write_due();
    }
  }

  void finish() {
    loop_.report();
    recorder_.close();
    Summary summary = summarize(simulation_, loop_, recorder_);
    summary.wall_seconds = seconds_since(start_);
    write_file(directory_.summary_file(), format_summary(summary));
  }

  void save_after(const PhysicsError& error) {
    try {
      recorder_.write_all();
      finish();
    } catch (const FileError& second) {
      throw PhysicsError(
          fmt::format("{}; nor could the last state be saved: {}", error.what(), second.what()));
    }
  }

  Clock::time_point start_ = Clock::now();
  Simulation& simulation_;
  OutputDirectory directory_;
  Recorder recorder_;
  StepLoop loop_;
};

}  // namespace

void run_case(Simulation& simulation, const RunOptions& options) {
  protect_source(simulation.settings(), options.directory);
  Run(simulation, options).execute();
}

}  // namespace rgimp
