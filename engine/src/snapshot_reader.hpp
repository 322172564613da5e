#pragma once

#include <filesystem>

#include "rgimp/simulation.hpp"

namespace rgimp {

/// Reads a snapshot of `particles` particles, whoever wrote it. Throws FileError where it cannot be
/// read, has another number of particles, or values that no particle can have.
ParticleTable read_snapshot(const std::filesystem::path& path, std::size_t particles);

}  // namespace rgimp
