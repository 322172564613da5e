#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "output_directory.hpp"
#include "rgimp/sweep.hpp"

namespace rgimp {

/// The directory of a sweep, made ready: created where it does not exist, cleared of an earlier
/// sweep's files where it may be replaced, left as it is to be resumed. Another sweep is kept out
/// while it lives.
class SweepDirectory {
 public:
  /// Throws CaseError where the directory is not empty and must be new, another sweep is at work in
  /// it, or it is to be resumed and holds another case; FileError where it cannot be made.
  SweepDirectory(std::filesystem::path path, ExistingOutput existing, const Sweep& sweep);

  /// Of one case.
  std::filesystem::path of(const SweepCase& one) const { return path_ / one.name; }
  /// Writes sweep.csv, whole or not at all. Throws FileError.
  void write_table(const Sweep& sweep, const std::vector<SweepOutcome>& outcomes);

 private:
  std::filesystem::path path_;
  NewDirectories new_directories_;
  DirectoryLock lock_;
};

}  // namespace rgimp
