#include "temporary_directory.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstdlib>
#include <string>
#include <system_error>

#include "rgimp/error.hpp"

namespace rgimp::cli {

namespace fs = std::filesystem;

TemporaryDirectory::TemporaryDirectory() {
  std::error_code error;
  const fs::path place = fs::temp_directory_path(error);
  std::string name = (place / "rgimp_XXXXXX").string();
  if (!error && mkdtemp(name.data()) == nullptr) {
    error = std::error_code(errno, std::generic_category());
  }
  if (error) {
    throw FileError(
        fmt::format("cannot make a temporary directory (see TMPDIR): {}", error.message()));
  }
  path_ = name;
}

TemporaryDirectory::~TemporaryDirectory() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

}  // namespace rgimp::cli
