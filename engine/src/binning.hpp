#pragma once

#include <cstddef>
#include <vector>

#include "grid.hpp"
#include "particles.hpp"
#include "workers.hpp"

namespace rgimp {

/// Sorts particles into the bins of their nearest nodes, in groups of eight bins, keeping the
/// present order within a bin. Padding lanes are put on their bin's node. Bins are those of the
/// grid's `layer`.
/// Returns the lanes, in order of id, of the particles that are not inside the grid, or nowhere;
/// where there are any, the particles are as they were.
template <int Dim>
[[nodiscard]] std::vector<std::size_t> bin_particles(
    Particles<Dim>& particles, const std::vector<std::uint8_t>& material_of_id,
    const Grid<Dim>& grid, Workers& workers, int layer = 0);

}  // namespace rgimp
