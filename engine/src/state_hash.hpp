#pragma once

#include <cstdint>
#include <vector>

#include "particles.hpp"

namespace rgimp {

/// The lanes of the particles in order of id.
template <int Dim>
std::vector<std::size_t> lanes_by_id(const Particles<Dim>& particles);

/// FNV-1a over every column of every particle in order of id, so that it depends on bits alone
/// and not on where they are kept.
template <int Dim>
std::uint64_t state_hash(Particles<Dim>& particles);

}  // namespace rgimp
