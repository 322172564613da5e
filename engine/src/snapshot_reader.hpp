#pragma once

#include <filesystem>

#include "rgimp/simulation.hpp"

namespace rgimp {

/// Reads a snapshot of a case of `particles` particles, whoever wrote it. Throws FileError where it
/// cannot be read, has another number of particles (with OnExit::remove: more), or values that no
/// particle can have.
ParticleTable read_snapshot(const std::filesystem::path& path, std::size_t particles,
                            OnExit on_exit = OnExit::stop);

}  // namespace rgimp
