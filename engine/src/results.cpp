#include "rgimp/results.hpp"

#include <fmt/format.h>

#include <charconv>
#include <string>
#include <system_error>

#include "geometry.hpp"
#include "input_file.hpp"
#include "rgimp/case_file.hpp"
#include "rgimp/error.hpp"
#include "snapshot.hpp"
#include "snapshot_reader.hpp"

namespace rgimp {

namespace fs = std::filesystem;

namespace {

struct SnapshotFile {
  std::int64_t step = -1;
  fs::path path;
};

std::int64_t step_of(const fs::path& snapshot) {
  const std::string name = snapshot.stem().string();
  const std::size_t digits = name.find('_') + 1;
  std::int64_t step = -1;
  std::from_chars(name.data() + digits, name.data() + name.size(), step);
  return step;
}

SnapshotFile last_snapshot(const fs::path& directory) {
  SnapshotFile last;
  try {
    for (const fs::directory_entry& entry : fs::directory_iterator(directory / "snapshots")) {
      if (is_snapshot_name(entry.path().filename().string()) && step_of(entry.path()) > last.step) {
        last = {step_of(entry.path()), entry.path()};
      }
    }
  } catch (const fs::filesystem_error& error) {
    throw FileError(fmt::format("cannot read the snapshots in '{}': {}", directory.string(),
                                error.code().message()));
  }
  if (last.path.empty()) {
    throw FileError(fmt::format("there are no snapshots in '{}'", directory.string()));
  }
  return last;
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

Results read_results(const fs::path& directory, std::optional<std::int64_t> until) {
  std::error_code ignored;
  if (!fs::exists(fs::symlink_status(directory / "case.toml", ignored))) {
    throw CaseError(fmt::format("'{}' is no output directory of `rgimp run`: it has no case.toml",
                                directory.string()));
  }
  require_regular_file(directory / "case.toml");
  Results results;
  results.settings = read_case(directory / "case.toml");
  const SnapshotFile last = last_snapshot(directory);
  require_regular_file(last.path);
  results.particles = read_snapshot(last.path, seed_particles(results.settings).size(),
                                    results.settings.grid.on_exit);
  if (until) {
    if (*until > last.step) {
      throw CaseError(fmt::format("step {} lies past the last snapshot, of step {}, in '{}'",
                                  *until, last.step, directory.string()));
    }
    forget_after(*until, results.particles);
  }
  return results;
}

}  // namespace rgimp
