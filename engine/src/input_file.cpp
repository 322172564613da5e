#include "input_file.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstdint>
#include <system_error>

#include "rgimp/error.hpp"

namespace rgimp {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void fail(const fs::path& path, const std::string& reason) {
  throw FileError(fmt::format("cannot read '{}': {}", path.string(), reason));
}

}  // namespace

void require_regular_file(const fs::path& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (error) {
    fail(path, error.message());
  }
  if (!fs::is_regular_file(status)) {
    fail(path, "not a regular file");
  }
}

std::ifstream open_file(const fs::path& path) {
  require_regular_file(path);
  std::ifstream file(path, std::ios::binary);
  if (!file) {
    fail(path, std::generic_category().message(errno));
  }
  return file;
}

std::string read_bytes(const fs::path& path) {
  std::ifstream file = open_file(path);
  std::error_code error;
  const std::uintmax_t size = fs::file_size(path, error);
  if (error) {
    fail(path, error.message());
  }
  std::string bytes(size, '\0');
  if (!file.read(bytes.data(), static_cast<std::streamsize>(size))) {
    fail(path, "the file ends early");
  }
  return bytes;
}

}  // namespace rgimp
