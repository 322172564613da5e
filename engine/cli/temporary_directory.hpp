#pragma once

#include <filesystem>

namespace rgimp::cli {

/// Gone with everything in it when it goes out of scope.
class TemporaryDirectory {
 public:
  /// Throws FileError.
  TemporaryDirectory();
  ~TemporaryDirectory();
  TemporaryDirectory(const TemporaryDirectory&) = delete;
  TemporaryDirectory& operator=(const TemporaryDirectory&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace rgimp::cli
