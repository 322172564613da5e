#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

#include "rgimp/run.hpp"

namespace rgimp {

/// Where a run puts its snapshots, within its output directory.
inline constexpr std::string_view kSnapshots = "snapshots";
/// Where `rgimp grid` writes, within an output directory.
inline constexpr std::string_view kGrid = "grid";
inline constexpr std::string_view kGridSeries = "grid.hdf.series";

/// Directories made on the way to a place; they go again with this object, unless keep() is called.
class NewDirectories {
 public:
  NewDirectories() = default;
  ~NewDirectories();
  NewDirectories(const NewDirectories&) = delete;
  NewDirectories& operator=(const NewDirectories&) = delete;

  /// Makes a directory and those above it, where they are missing.
  void create(const std::filesystem::path& directory);
  void keep() { made_.clear(); }

 private:
  std::vector<std::filesystem::path> made_;  // outermost first
};

/// Keeps other runs out of a directory while it lives, in this process and others.
class DirectoryLock {
 public:
  DirectoryLock() = default;
  ~DirectoryLock();
  DirectoryLock(const DirectoryLock&) = delete;
  DirectoryLock& operator=(const DirectoryLock&) = delete;

  /// Throws CaseError where another run is at work there.
  void take(const std::filesystem::path& directory);

 private:
  std::optional<int> descriptor_;
};

/// The directory of one run, made ready for writing: created where it does not exist, cleared of an
/// earlier run's files where it may be replaced, left as it is to be resumed. Unless the run gets
/// under way and calls keep(), everything written and created goes again with this object; what is
/// there to be resumed stays.
class OutputDirectory {
 public:
  /// Throws CaseError where the directory is not empty and must be new, or another run is at work
  /// in it, FileError where it cannot be made.
  OutputDirectory(std::filesystem::path path, ExistingOutput existing);
  ~OutputDirectory();
  OutputDirectory(const OutputDirectory&) = delete;
  OutputDirectory& operator=(const OutputDirectory&) = delete;

  void keep();
  /// Removes what an earlier run wrote. Throws FileError.
  void clear();
  /// Removes what an earlier run wrote after it had done `step` steps: later snapshots, the
  /// summary, and files it did not finish. Throws FileError.
  void go_back_to(std::int64_t step);

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path case_file() const { return path_ / "case.toml"; }
  std::filesystem::path history_file() const { return path_ / "history.csv"; }
  std::filesystem::path summary_file() const { return path_ / "summary.json"; }
  std::filesystem::path snapshot_file(std::int64_t step) const;
  std::filesystem::path series_file() const;
  /// Written in turn, so that one is whole while the other is being replaced.
  std::array<std::filesystem::path, 2> checkpoint_files() const;

 private:
  std::filesystem::path path_;
  NewDirectories new_directories_;
  DirectoryLock lock_;
  bool kept_ = false;
};

}  // namespace rgimp
