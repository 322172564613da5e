#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <functional>
#include <mutex>
#include <new>
#include <numeric>
#include <thread>

#include "case_size.hpp"
#include "machine_memory.hpp"
#include "rgimp/case_file.hpp"
#include "rgimp/error.hpp"
#include "rgimp/sweep.hpp"
#include "sweep_directory.hpp"
#include "sweep_memory.hpp"
#include "sweep_table.hpp"

namespace rgimp {

namespace {

using Clock = std::chrono::steady_clock;

/// What a sweep's threads share.
class SweepRun {
 public:
  SweepRun(const Sweep& sweep, const SweepOptions& options, SweepDirectory& directory)
      : sweep_(sweep),
        options_(options),
        directory_(directory),
        outcomes_(sweep.cases.size()),
        done_(sweep.cases.size()),
        first_(sweep.cases.size()) {}

  std::vector<SweepOutcome> execute() {
    directory_.write_table(sweep_, outcomes_);
    {
      const std::size_t jobs = std::min<std::size_t>(options_.jobs, sweep_.cases.size());
      std::vector<std::jthread> threads;
      for (std::size_t job = 0; job < jobs; ++job) {
        threads.emplace_back([this] { work(); });
      }
    }
    if (error_) {
      std::rethrow_exception(error_);
    }
    return std::move(outcomes_);
  }

 private:
  /// Runs cases until there are none left.
  void work() {
    while (!is_stopped()) {
      const std::size_t index = next_++;
      if (index >= sweep_.cases.size()) {
        return;
      }
      {
        const std::lock_guard lock(mutex_);
        ++running_;
      }
      end_case(index, run_one(index));
    }
  }

  bool is_stopped() { return is_broken_ || (options_.stop_requested && options_.stop_requested()); }

  SweepOutcome run_one(std::size_t index) {
    const SweepCase& one = sweep_.cases[index];
    SweepOutcome outcome;
    try {
      Simulation simulation(one.settings);
      const RunEnd end = run_case(simulation, options_of(index));
      outcome.status = end == RunEnd::stopped ? SweepStatus::stopped : SweepStatus::finished;
    } catch (const PhysicsError& error) {
      outcome = {SweepStatus::physics_stopped, error.what(), {}};
    } catch (const std::bad_alloc&) {
      outcome = {SweepStatus::failed, "not enough memory", {}};
    } catch (const std::exception& error) {
      outcome = {SweepStatus::failed, error.what(), {}};
    }
    if (outcome.status == SweepStatus::finished || outcome.status == SweepStatus::physics_stopped) {
      outcome.figures = read_figures(directory_.of(one));
    }
    return outcome;
  }

  RunOptions options_of(std::size_t index) {
    const SweepCase& one = sweep_.cases[index];
    RunOptions options;
    options.directory = directory_.of(one);
    options.existing = existing_for(options.directory);
    options.on_progress = [this, index](const Progress& progress) { note(index, progress); };
    options.on_notice = [this, &one](const std::string& notice) {
      const std::lock_guard lock(mutex_);
      if (options_.on_notice) {
        options_.on_notice(fmt::format("case {}: {}", one.name, notice));
      }
    };
    options.stop_requested = [this] { return is_stopped(); };
    return options;
  }

  /// A case that was not begun has nothing to go on from.
  ExistingOutput existing_for(const std::filesystem::path& directory) const {
    const bool is_new = options_.existing == ExistingOutput::resume &&
                        !std::filesystem::exists(directory / "case.toml");
    return is_new ? ExistingOutput::refuse : options_.existing;
  }

  void note(std::size_t index, const Progress& progress) {
    const double total = std::max(1.0, static_cast<double>(progress.total_steps));
    const std::lock_guard lock(mutex_);
    done_[index] = static_cast<double>(progress.step) / total;
    first_[index] = static_cast<double>(progress.first_step) / total;
    report();
  }

  void end_case(std::size_t index, SweepOutcome outcome) {
    const std::lock_guard lock(mutex_);
    --running_;
    if (outcome.status != SweepStatus::stopped) {
      ++ended_;
      first_[index] = done_[index] == 0.0 ? 1.0 : first_[index];  // it was finished before
      done_[index] = 1.0;
    }
    outcomes_[index] = std::move(outcome);
    try {
      report();
      directory_.write_table(sweep_, outcomes_);
    } catch (
        ...) {  // of the table or a callback: the sweep ends with it, the runs with checkpoints
      error_ = std::current_exception();
      is_broken_ = true;
    }
  }

  void report() {
    if (!options_.on_progress) {
      return;
    }
    SweepProgress progress;
    progress.cases = sweep_.cases.size();
    progress.ended = ended_;
    progress.running = running_;
    progress.done = std::reduce(done_.begin(), done_.end());
    progress.computed = progress.done - std::reduce(first_.begin(), first_.end());
    progress.seconds = std::chrono::duration<double>(Clock::now() - start_).count();
    options_.on_progress(progress);
  }

  const Sweep& sweep_;
  const SweepOptions& options_;
  SweepDirectory& directory_;
  Clock::time_point start_ = Clock::now();
  std::atomic<std::size_t> next_ = 0;
  std::atomic<bool> is_broken_ = false;
  std::mutex mutex_;  // of all below, and of the user's callbacks
  std::vector<SweepOutcome> outcomes_;
  std::vector<double> done_;   // share of each case's steps
  std::vector<double> first_;  // of those, the share done before
  std::size_t running_ = 0;
  std::size_t ended_ = 0;
  std::exception_ptr error_;
};

/// Cases may have been changed since they were read.
void check_cases(const Sweep& sweep) {
  for (const SweepCase& one : sweep.cases) {
    try {
      check_case(one.settings);
    } catch (const CaseError& error) {
      throw CaseError(
          fmt::format("case {} ({}): {}", one.name, describe(sweep, one), error.what()));
    }
  }
}

}  // namespace

void check_memory(const Sweep& sweep, int jobs, std::optional<double> available_bytes) {
  constexpr double kGibibyte = 1024.0 * 1024.0 * 1024.0;
  std::vector<double> bytes;
  for (const SweepCase& one : sweep.cases) {
    const CaseSize size = estimate_size(one.settings);
    bytes.push_back(peak_bytes(size.state_bytes, size.particles));
  }
  std::sort(bytes.begin(), bytes.end(), std::greater<>());
  bytes.resize(std::min(bytes.size(), static_cast<std::size_t>(jobs)));
  const double total = std::reduce(bytes.begin(), bytes.end());
  if (available_bytes && total > *available_bytes) {
    throw CaseError(
        fmt::format("{} cases at once take about {:.1f} GiB of memory; expected no more than the "
                    "{:.1f} GiB that are free here: run fewer at once (--jobs)",
                    bytes.size(), total / kGibibyte, *available_bytes / kGibibyte));
  }
}

std::vector<SweepOutcome> run_sweep(const Sweep& sweep, const SweepOptions& options) {
  if (options.jobs < 1) {
    throw CaseError(fmt::format("{} cases at once; expected 1 or more", options.jobs));
  }
  check_cases(sweep);
  check_memory(sweep, options.jobs, available_memory());
  SweepDirectory directory(options.directory, options.existing, sweep);
  return SweepRun(sweep, options, directory).execute();
}

}  // namespace rgimp
