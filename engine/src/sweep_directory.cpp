#include "sweep_directory.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <set>
#include <string>
#include <system_error>
#include <utility>

#include "atomic_file.hpp"
#include "resume.hpp"
#include "rgimp/error.hpp"
#include "sweep_table.hpp"

namespace rgimp {

namespace fs = std::filesystem;

namespace {

constexpr const char* kTable = "sweep.csv";

[[noreturn]] void fail_in_sweep(const fs::path& path, const std::error_code& error) {
  throw FileError(
      fmt::format("cannot use the sweep's directory '{}': {}", path.string(), error.message()));
}

void refuse_used(const fs::path& path) {
  if (!fs::is_empty(path)) {
    throw CaseError(
        fmt::format("the sweep's directory '{}' is not empty: choose another one, go on with its "
                    "sweep with --resume, or replace its results with --force",
                    path.string()));
  }
}

/// Directories that an earlier sweep gave its cases, those of this one left out.
std::vector<fs::path> stale_directories(const fs::path& path, const Sweep& sweep) {
  std::set<std::string> current;
  for (const SweepCase& one : sweep.cases) {
    current.insert(one.name);
  }
  std::vector<fs::path> stale;
  for (const fs::directory_entry& entry : fs::directory_iterator(path)) {
    const std::string name = entry.path().filename().string();
    const bool is_number =
        std::all_of(name.begin(), name.end(), [](unsigned char c) { return std::isdigit(c) != 0; });
    if (is_number && !current.contains(name) && entry.is_directory() && !entry.is_symlink()) {
      stale.push_back(entry.path());
    }
  }
  return stale;
}

/// Files of other programs stay, and so does a directory that holds any.
void remove_results(const fs::path& directory) {
  { const OutputDirectory cleared(directory, ExistingOutput::replace); }
  std::error_code not_empty;
  fs::remove(directory / kSnapshots, not_empty);
  fs::remove(directory, not_empty);
}

void clear(const fs::path& path, const Sweep& sweep) {
  if (!fs::exists(path / kTable)) {
    return;  // no sweep's: numbers there are none of ours
  }
  for (const fs::path& directory : stale_directories(path, sweep)) {
    remove_results(directory);
  }
  fs::remove(path / kTable);
}

void require_cases_of(const fs::path& path, const Sweep& sweep) {
  for (const SweepCase& one : sweep.cases) {
    require_case_of(path / one.name / "case.toml", one.settings);
  }
}

}  // namespace

SweepDirectory::SweepDirectory(fs::path path, ExistingOutput existing, const Sweep& sweep)
    : path_(std::move(path)) {
  if (path_.empty()) {
    throw CaseError("the sweep's directory has no name");
  }
  try {
    if (fs::exists(path_) && !fs::is_directory(path_)) {
      fail_in_sweep(path_, std::make_error_code(std::errc::not_a_directory));
    }
    new_directories_.create(path_);
    lock_.take(path_);
    switch (existing) {
      case ExistingOutput::refuse:
        refuse_used(path_);
        break;
      case ExistingOutput::replace:
        clear(path_, sweep);
        break;
      case ExistingOutput::resume:
        require_cases_of(path_, sweep);
        break;
    }
  } catch (const fs::filesystem_error& error) {
    fail_in_sweep(path_, error.code());
  }
}

void SweepDirectory::write_table(const Sweep& sweep, const std::vector<SweepOutcome>& outcomes) {
  write_file(path_ / kTable, format_sweep(sweep, outcomes));
  new_directories_.keep();
}

}  // namespace rgimp
