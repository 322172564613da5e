#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "rgimp/case.hpp"
#include "rgimp/simulation.hpp"

/// What is in an output directory of run_case. All throw as read_results does.
namespace rgimp {

Case read_case_of_results(const std::filesystem::path& directory);
/// Of the files in a folder that are named like snapshots, rising.
std::vector<std::int64_t> steps_in(const std::filesystem::path& folder);
/// Of the snapshots there are, rising; at least one.
std::vector<std::int64_t> snapshot_steps(const std::filesystem::path& directory);
/// `settings` are those of the directory and have `particles` particles, `step` is one of its
/// snapshots'.
ParticleTable read_particles(const std::filesystem::path& directory, const Case& settings,
                             std::size_t particles, std::int64_t step);

}  // namespace rgimp
