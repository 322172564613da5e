#include "rgimp/run.hpp"

#include <fmt/format.h>

#include <array>
#include <chrono>
#include <memory>
#include <system_error>
#include <utility>

#include "atomic_file.hpp"
#include "output_directory.hpp"
#include "recorder.hpp"
#include "resume.hpp"
#include "rgimp/case_file.hpp"
#include "rgimp/error.hpp"
#include "step_loop.hpp"
#include "summary.hpp"

namespace rgimp {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

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
  summary.removed = simulation.removed();
  summary.state_hash = simulation.state_hash();
  return summary;
}

bool is_source(const Case& settings, const std::filesystem::path& file) {
  std::error_code ignored;  // neither has to exist
  return std::filesystem::equivalent(settings.source.path, file, ignored);
}

/// A case file written by hand as DIR/case.toml would be lost to the resolved one.
void protect_source(const Case& settings, const std::filesystem::path& directory) {
  if (is_source(settings, directory / "case.toml")) {
    throw CaseError(
        fmt::format("output directory '{}' would overwrite the case file '{}': choose another one",
                    directory.string(), settings.source.path.string()));
  }
}

/// Writes checkpoints into two files in turn.
class Checkpoints {
 public:
  Checkpoints(Simulation& simulation, const RunOptions& options, const OutputDirectory& directory)
      : simulation_(simulation),
        pace_(options.checkpoint_pace),
        files_(directory.checkpoint_files()) {}

  /// The next one replaces the other file.
  void keep(const std::filesystem::path& file) { next_ = file == files_[0] ? 1 : 0; }

  bool is_due(const OutputSchedule& schedule) const {
    return simulation_.settings().output.checkpoint_every
               ? schedule.writes_checkpoint(simulation_.steps_done())
               : Clock::now() - last_ >= pace_;
  }

  void write(Recorder& recorder) {
    simulation_.save(files_[next_], recorder.note());
    next_ = 1 - next_;
    last_ = Clock::now();
  }

 private:
  Simulation& simulation_;
  std::chrono::duration<double> pace_;
  std::array<std::filesystem::path, 2> files_;
  std::size_t next_ = 0;
  Clock::time_point last_ = Clock::now();
};

class Run {
 public:
  /// From step 0.
  Run(Simulation& simulation, const RunOptions& options, OutputDirectory& directory)
      : Run(simulation, options, directory, std::make_unique<Recorder>(simulation, directory)) {
    write_file(directory_.case_file(), write_case(simulation.settings()));
    recorder_->write_all();
    directory_.keep();
  }

  /// From a checkpoint that is restored.
  Run(Simulation& simulation, const RunOptions& options, OutputDirectory& directory,
      Resumption resumption)
      : Run(simulation, options, directory, std::move(resumption.recorder)) {
    checkpoints_.keep(resumption.checkpoint);
    if (!is_source(simulation.settings(), directory_.case_file())) {
      write_file(directory_.case_file(), write_case(simulation.settings()));
    }
  }

  RunEnd execute() {
    loop_.report();
    try {
      if (compute() == RunEnd::stopped) {
        return RunEnd::stopped;
      }
    } catch (const PhysicsError& error) {
      save_after(error);
      throw;
    }
    finish();
    return RunEnd::finished;
  }

 private:
  Run(Simulation& simulation, const RunOptions& options, OutputDirectory& directory,
      std::unique_ptr<Recorder> recorder)
      : simulation_(simulation),
        options_(options),
        directory_(directory),
        recorder_(std::move(recorder)),
        checkpoints_(simulation, options, directory),
        loop_(simulation, options) {}

  RunEnd compute() {
    const std::int64_t total = simulation_.facts().total_steps;
    while (simulation_.steps_done() < total) {
      loop_.advance(recorder_->schedule().next_stop(simulation_.steps_done()));
      recorder_->write_due();
      const bool stops =
          simulation_.steps_done() < total && options_.stop_requested && options_.stop_requested();
      if (stops || checkpoints_.is_due(recorder_->schedule())) {
        checkpoints_.write(*recorder_);
      }
      if (stops) {
        recorder_->close();
        return RunEnd::stopped;
      }
    }
    return RunEnd::finished;
  }

  void finish() {
    loop_.report();
    recorder_->write_all();
    recorder_->close();
    Summary summary = summarize(simulation_, loop_, *recorder_);
    summary.wall_seconds = seconds_since(start_);
    write_file(directory_.summary_file(), format_summary(summary));
  }

  void save_after(const PhysicsError& error) {
    try {
      finish();
    } catch (const FileError& second) {
      throw PhysicsError(
          fmt::format("{}; nor could the last state be saved: {}", error.what(), second.what()),
          error.report());
    }
  }

  Clock::time_point start_ = Clock::now();
  Simulation& simulation_;
  const RunOptions& options_;
  OutputDirectory& directory_;
  std::unique_ptr<Recorder> recorder_;
  Checkpoints checkpoints_;
  StepLoop loop_;
};

RunEnd resume(Simulation& simulation, const RunOptions& options, OutputDirectory& directory) {
  const auto notice = [&](const std::string& text) {
    if (options.on_notice) {
      options.on_notice(text);
    }
  };
  require_case_of(directory.case_file(), simulation.settings());
  if (is_finished(directory, simulation)) {
    notice(fmt::format("the run in '{}' is finished: nothing to do", directory.path().string()));
    return RunEnd::was_finished;
  }
  if (auto resumption = restore_newest(simulation, directory, notice)) {
    notice(fmt::format("going on from step {} of '{}'", simulation.steps_done(),
                       resumption->checkpoint.string()));
    return Run(simulation, options, directory, std::move(*resumption)).execute();
  }
  notice(fmt::format("no checkpoint in '{}': starting at step 0", directory.path().string()));
  directory.clear();
  return Run(simulation, options, directory).execute();
}

}  // namespace

RunEnd run_case(Simulation& simulation, const RunOptions& options) {
  if (options.existing == ExistingOutput::resume) {
    OutputDirectory directory(options.directory, options.existing);
    return resume(simulation, options, directory);
  }
  protect_source(simulation.settings(), options.directory);
  OutputDirectory directory(options.directory, options.existing);
  return Run(simulation, options, directory).execute();
}

}  // namespace rgimp
