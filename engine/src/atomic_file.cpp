#include "atomic_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <utility>

#include "output_stream.hpp"
#include "rgimp/error.hpp"

namespace rgimp {

AtomicFile::AtomicFile(std::filesystem::path target)
    : target_(std::move(target)), temporary_(target_) {
  temporary_ += kTemporarySuffix;
  std::error_code ignored;  // what is left there may be a link, through which we would write
  std::filesystem::remove(temporary_, ignored);
}

AtomicFile::~AtomicFile() {
  std::error_code ignored;  // after commit() there is nothing to remove
  std::filesystem::remove(temporary_, ignored);
}

void AtomicFile::commit() {
  sync_to_disk(temporary_);
  std::error_code error;
  std::filesystem::rename(temporary_, target_, error);
  if (error) {
    throw FileError(fmt::format("cannot write '{}': {}", target_.string(), error.message()));
  }
  sync_to_disk(target_.has_parent_path() ? target_.parent_path() : ".");
}

void sync_to_disk(const std::filesystem::path& path) {
  const int file = open(path.c_str(), O_RDONLY | O_CLOEXEC);
  const bool done = file >= 0 && (fsync(file) == 0 || errno == EINVAL);  // EINVAL: nothing to sync
  const std::string reason = std::generic_category().message(errno);
  if (file >= 0) {
    close(file);
  }
  if (!done) {
    throw FileError(fmt::format("cannot write '{}': {}", path.string(), reason));
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
