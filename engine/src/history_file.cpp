#include "history_file.hpp"

#include <fmt/format.h>

namespace rgimp {

std::string format_history_row(const HistoryRow& row) {
  return fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{}", row.step, row.time, row.closure,
                     row.axial_stress, row.reaction, row.kinetic_energy, row.strain_energy,
                     row.external_work, row.damping_work, row.viscous_work, row.released_energy,
                     row.failed_tension, row.failed_shear);
}

HistoryFile::HistoryFile(const std::filesystem::path& path) : stream_(path) {
  stream_.write(fmt::format("{}\n", kHistoryHeader));
}

void HistoryFile::append(const HistoryRow& row) {
  stream_.write(format_history_row(row) + "\n");
  stream_.flush();
}

}  // namespace rgimp
