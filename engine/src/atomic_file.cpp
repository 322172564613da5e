#include "atomic_file.hpp"

#include <fmt/format.h>

#include <system_error>
#include <utility>

#include "output_stream.hpp"
#include "rgimp/error.hpp"

namespace rgimp {

AtomicFile::AtomicFile(std::filesystem::path target)
    : target_(std::move(target)), temporary_(target_) {
  temporary_ += kTemporarySuffix;
}

AtomicFile::~AtomicFile() {
  std::error_code ignored;  // after commit() there is nothing to remove
  std::filesystem::remove(temporary_, ignored);
}

void AtomicFile::commit() {
  std::error_code error;
  std::filesystem::rename(temporary_, target_, error);
  if (error) {
    throw FileError(fmt::format("cannot write '{}': {}", target_.string(), error.message()));
  }
}

void write_file(const std::filesystem::path& path, std::string_view bytes) {
  AtomicFile file(path);
  OutputStream stream(file.temporary());
  stream.write(bytes);
  stream.close();
  file.commit();
}

}  // namespace rgimp
