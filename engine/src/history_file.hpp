#pragma once

#include <filesystem>
#include <string>
#include <string_view>

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
  explicit HistoryFile(const std::filesystem::path& path);

  void append(const HistoryRow& row);
  void close() { stream_.close(); }

 private:
  OutputStream stream_;
};

}  // namespace rgimp
