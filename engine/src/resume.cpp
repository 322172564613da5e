#include "resume.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "case_of_state.hpp"
#include "checkpoint_file.hpp"
#include "input_file.hpp"
#include "rgimp/case_file.hpp"
#include "rgimp/error.hpp"

namespace rgimp {

namespace fs = std::filesystem;

namespace {

/// Those that are there, the latest first; one that does not even tell its step is damaged, and
/// comes before all others so that it is not passed over in silence.
std::vector<fs::path> checkpoints_of(const OutputDirectory& directory) {
  std::vector<fs::path> files;
  for (const fs::path& file : directory.checkpoint_files()) {
    if (fs::exists(file)) {
      files.push_back(file);
    }
  }
  std::sort(files.begin(), files.end(), [](const fs::path& a, const fs::path& b) {
    const auto step_a = claimed_step(a);
    const auto step_b = claimed_step(b);
    return step_a && step_b ? *step_a > *step_b : step_a.has_value() < step_b.has_value();
  });
  return files;
}

void refuse_past_end(const Simulation& simulation, const fs::path& checkpoint) {
  const std::int64_t total = simulation.facts().total_steps;
  if (simulation.steps_done() > total) {
    throw CaseError(
        fmt::format("'{}' is of step {} already; expected at least as many steps, not {}",
                    checkpoint.string(), simulation.steps_done(), total));
  }
}

/// The note of a checkpoint once it is restored; none, and a notice, where it cannot be.
std::optional<std::string> restore(Simulation& simulation, const fs::path& checkpoint,
                                   const Notice& notice) {
  try {
    return simulation.restore(checkpoint);
  } catch (const FileError& error) {
    notice(error.what());
    return std::nullopt;
  }
}

/// The bits of a run are those of one kind of rounding.
void notice_rounding(const std::string& before, const std::string& now, const Notice& notice) {
  const auto is_fused = [](const std::string& isa) { return isa == "avx2" || isa == "avx512"; };
  if (before != now && !(is_fused(before) && is_fused(now))) {
    notice(
        fmt::format("the run was computed with {} and goes on with {}: its results may differ in "
                    "round-off from one that was never interrupted",
                    before, now));
  }
}

}  // namespace

bool is_finished(const OutputDirectory& directory, const Simulation& simulation) {
  if (!fs::exists(directory.summary_file())) {
    return false;
  }
  const auto summary = nlohmann::json::parse(read_bytes(directory.summary_file()), nullptr, false);
  const auto steps = summary.is_object() ? summary.find("steps") : summary.end();
  return steps != summary.end() && steps->is_number_integer() &&
         *steps >= simulation.facts().total_steps;
}

void require_case_of(const fs::path& case_file, const Case& settings) {
  if (fs::exists(case_file)) {
    require_regular_file(case_file);
    require_same_case(settings, case_of_state(read_case(case_file)), case_file.string());
  }
}

std::optional<Resumption> restore_newest(Simulation& simulation, OutputDirectory& directory,
                                         const Notice& notice) {
  const std::vector<fs::path> files = checkpoints_of(directory);
  for (const fs::path& file : files) {
    const std::optional<std::string> note = restore(simulation, file, notice);
    if (!note) {
      continue;
    }
    refuse_past_end(simulation, file);
    auto recorder = Recorder::go_on(simulation, directory, *note);
    if (!recorder) {
      notice(fmt::format("'{}' is no longer what it was when '{}' was written",
                         directory.history_file().string(), file.string()));
      continue;
    }
    notice_rounding(recorder->past_isa(), simulation.facts().isa, notice);
    return Resumption{file, std::move(recorder)};
  }
  if (!files.empty()) {
    throw FileError(fmt::format(
        "no checkpoint in '{}' can be used: start anew with --force, which replaces what is there",
        directory.path().string()));
  }
  return std::nullopt;
}

}  // namespace rgimp
