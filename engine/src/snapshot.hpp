#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "rgimp/simulation.hpp"

namespace rgimp {

/// When a snapshot was taken.
struct SnapshotTime {
  std::int64_t step = 0;
  double time = 0.0;  ///< s
};

/// "step_000005000.vtkhdf"
std::string snapshot_name(std::int64_t step);
bool is_snapshot_name(std::string_view name);

/// Writes the particles as a VTKHDF 1.0 unstructured grid of vertices, which VTK >= 9.1 and
/// ParaView >= 5.10 open, and any HDF5 reader. Throws FileError; then no file is left.
void write_snapshot(const std::filesystem::path& path, ParticleTable particles,
                    const SnapshotTime& when);

/// Writes the list of a run's snapshots in ParaView's series format, so that it opens them as one
/// animation. The names are relative to the list's own directory. Throws FileError.
void write_series(const std::filesystem::path& path, const std::vector<SnapshotTime>& snapshots);

}  // namespace rgimp
