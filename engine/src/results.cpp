#include "rgimp/results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <string>
#include <system_error>

#include "geometry.hpp"
#include "input_file.hpp"
#include "output_directory.hpp"
#include "result_files.hpp"
#include "rgimp/case_file.hpp"
#include "rgimp/error.hpp"
#include "snapshot.hpp"
#include "snapshot_reader.hpp"

namespace rgimp {

namespace fs = std::filesystem;

namespace {

std::int64_t step_of(const fs::path& snapshot) {
  const std::string name = snapshot.stem().string();
  const std::size_t digits = name.find('_') + 1;
  std::int64_t step = -1;
  std::from_chars(name.data() + digits, name.data() + name.size(), step);
  return step;
}

/// What failed after `step` is intact again.
void forget_after(std::int64_t step, ParticleTable& particles) {
  for (std::size_t row = 0; row < particles.size(); ++row) {
    if (particles.failure_step[row] > step) {
      particles.failed[row] = FailureMode::intact;
      particles.failure_step[row] = -1;
    }
  }
}

}  // namespace

Case read_case_of_results(const fs::path& directory) {
  std::error_code ignored;
  if (!fs::exists(fs::symlink_status(directory / "case.toml", ignored))) {
    throw CaseError(fmt::format("'{}' is no output directory of `rgimp run`: it has no case.toml",
                                directory.string()));
  }
  require_regular_file(directory / "case.toml");
  return read_case(directory / "case.toml");
}

std::vector<std::int64_t> steps_in(const fs::path& folder) {
  std::vector<std::int64_t> steps;
  try {
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
      if (is_snapshot_name(entry.path().filename().string())) {
        steps.push_back(step_of(entry.path()));
      }
    }
  } catch (const fs::filesystem_error& error) {
    throw FileError(
        fmt::format("cannot read directory '{}': {}", folder.string(), error.code().message()));
  }
  std::sort(steps.begin(), steps.end());
  return steps;
}

std::vector<std::int64_t> snapshot_steps(const fs::path& directory) {
  std::vector<std::int64_t> steps = steps_in(directory / kSnapshots);
  if (steps.empty()) {
    throw FileError(fmt::format("there are no snapshots in '{}'", directory.string()));
  }
  return steps;
}

ParticleTable read_particles(const fs::path& directory, const Case& settings, std::size_t particles,
                             std::int64_t step) {
  const fs::path file = directory / kSnapshots / snapshot_name(step);
  require_regular_file(file);
  return read_snapshot(file, particles, settings.grid.on_exit);
}

Results read_results(const fs::path& directory, std::optional<std::int64_t> until) {
  Results results;
  results.settings = read_case_of_results(directory);
  const std::int64_t last = snapshot_steps(directory).back();
  results.particles =
      read_particles(directory, results.settings, seed_particles(results.settings).size(), last);
  if (until) {
    if (*until > last) {
      throw CaseError(fmt::format("step {} lies past the last snapshot, of step {}, in '{}'",
                                  *until, last, directory.string()));
    }
    forget_after(*until, results.particles);
  }
  return results;
}

}  // namespace rgimp
