#pragma once

#include <filesystem>

#include "rgimp/simulation.hpp"

namespace rgimp {

/// Writes what `rgimp-plot --specimen` draws a simulation's specimen from into a directory that is
/// there: case.toml, specimen.json with the grid's corners (m) and the number of particles, and
/// particles.vtkhdf, a snapshot; in three dimensions of the three layers in the middle alone.
/// Throws FileError.
void write_specimen(const Simulation& simulation, const std::filesystem::path& directory);

}  // namespace rgimp
