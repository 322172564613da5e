#pragma once

#include <filesystem>
#include <string_view>

namespace rgimp {

/// A file under construction: it is written under a temporary name beside its place, and put there
/// whole by commit(), after it has reached the disk. Without commit() nothing is left of it, so
/// neither readers nor a machine that lost its power ever see half a file.
class AtomicFile {
 public:
  explicit AtomicFile(std::filesystem::path target);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  const std::filesystem::path& temporary() const { return temporary_; }
  /// Throws FileError.
  void commit();

 private:
  std::filesystem::path target_;
  std::filesystem::path temporary_;
};

/// Returns when a file's bytes, or a directory's names, are on disk. Throws FileError.
void sync_to_disk(const std::filesystem::path& path);

/// What the temporary name of an AtomicFile ends with.
inline constexpr std::string_view kTemporarySuffix = ".tmp";

/// Writes a file whole or not at all. Throws FileError.
void write_file(const std::filesystem::path& path, std::string_view bytes);

}  // namespace rgimp
