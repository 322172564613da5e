#include "history_file.hpp"

#include <fmt/format.h>

#include <system_error>
#include <utility>

#include "atomic_file.hpp"
#include "input_file.hpp"
#include "rgimp/error.hpp"

namespace rgimp {

namespace {

void cut_back(const std::filesystem::path& path, std::uint64_t bytes) {
  std::error_code error;
  std::filesystem::resize_file(path, bytes, error);
  if (error) {
    throw FileError(fmt::format("cannot write '{}': {}", path.string(), error.message()));
  }
}

}  // namespace

std::string format_history_row(const HistoryRow& row) {
  return fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{}", row.step, row.time, row.closure,
                     row.axial_stress, row.reaction, row.kinetic_energy, row.strain_energy,
                     row.external_work, row.damping_work, row.viscous_work, row.released_energy,
                     row.failed_tension, row.failed_shear);
}

HistoryFile::HistoryFile(std::filesystem::path path)
    : path_(std::move(path)), stream_(path_, OutputStream::Start::empty) {
  write(fmt::format("{}\n", kHistoryHeader));
}

std::optional<HistoryFile> HistoryFile::go_on(const std::filesystem::path& path,
                                              const Extent& past) {
  const std::string bytes = read_bytes(path);
  Checksum checksum;
  checksum.add(std::string_view(bytes).substr(0, past.bytes));
  if (bytes.size() < past.bytes || checksum.value() != past.checksum) {
    return std::nullopt;
  }
  cut_back(path, past.bytes);
  return HistoryFile(path, past.bytes, std::move(checksum));
}

HistoryFile::HistoryFile(const std::filesystem::path& path, std::uint64_t bytes, Checksum checksum)
    : path_(path),
      stream_(path, OutputStream::Start::at_end),
      checksum_(std::move(checksum)),
      bytes_(bytes) {}

void HistoryFile::append(const HistoryRow& row) {
  write(format_history_row(row) + "\n");
  stream_.flush();
}

void HistoryFile::write(std::string_view text) {
  stream_.write(text);
  checksum_.add(text);
  bytes_ += text.size();
}

HistoryFile::Extent HistoryFile::sync() const {
  sync_to_disk(path_);
  return {bytes_, checksum_.value()};
}

}  // namespace rgimp
