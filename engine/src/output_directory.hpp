#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "rgimp/run.hpp"

namespace rgimp {

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

/// The directory of one run, made ready for writing: created where it does not exist, cleared of an
/// earlier run's files where it may be replaced. Unless the run gets under way and calls keep(),
/// everything written and created goes again with this object.
class OutputDirectory {
 public:
  /// Throws CaseError where the directory is not empty and must not be replaced, FileError where
  /// it cannot be made.
  OutputDirectory(std::filesystem::path path, ExistingOutput existing);
  ~OutputDirectory();
  OutputDirectory(const OutputDirectory&) = delete;
  OutputDirectory& operator=(const OutputDirectory&) = delete;

  void keep();

  std::filesystem::path case_file() const { return path_ / "case.toml"; }
  std::filesystem::path history_file() const { return path_ / "history.csv"; }
  std::filesystem::path summary_file() const { return path_ / "summary.json"; }
  std::filesystem::path snapshot_file(std::int64_t step) const;
  std::filesystem::path series_file() const;

 private:
  std::filesystem::path path_;
  NewDirectories new_directories_;
  bool kept_ = false;
};

}  // namespace rgimp
