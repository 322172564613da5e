#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "checksum.hpp"
#include "output_stream.hpp"
#include "rgimp/simulation.hpp"

namespace rgimp {

inline constexpr std::string_view kHistoryHeader =
    "step,time_s,closure_m,axial_stress_Pa,reaction_N,kinetic_energy_J,strain_energy_J,"
    "external_work_J,damping_work_J,viscous_work_J,released_energy_J,failed_tension,failed_shear";

/// A row of history.csv in the order of kHistoryHeader, without the end of line. Every number is
/// the shortest text that reads back to the same bits.
std::string format_history_row(const HistoryRow& row);

/// history.csv of a run. Each row is handed to the system as it comes, so that an interrupted run
/// leaves all its rows. Throws FileError.
class HistoryFile {
 public:
  /// How far the file goes, and a checksum of all of that.
  struct Extent {
    std::uint64_t bytes = 0;
    std::uint64_t checksum = 0;
  };

  explicit HistoryFile(std::filesystem::path path);
  /// Goes on with a file, cut back to `past`; none, and the file as it was, where it does not hold
  /// what it held then.
  static std::optional<HistoryFile> go_on(const std::filesystem::path& path, const Extent& past);

  void append(const HistoryRow& row);
  /// Returns when all is on disk.
  Extent sync() const;
  void close() { stream_.close(); }

 private:
  HistoryFile(const std::filesystem::path& path, std::uint64_t bytes, Checksum checksum);
  void write(std::string_view text);

  std::filesystem::path path_;
  OutputStream stream_;
  Checksum checksum_;
  std::uint64_t bytes_ = 0;
};

}  // namespace rgimp
