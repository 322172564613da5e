#pragma once

#include <cstdint>
#include <vector>

#include "geometry.hpp"
#include "particles.hpp"
#include "workers.hpp"

namespace rgimp {

/// Particles as the case gives them, not yet in bins; velocities and masses set, stress zero.
template <int Dim>
Particles<Dim> particles_from(const SeedParts& seeds, Workers& workers);

/// The seeds' materials, by id.
std::vector<std::uint8_t> materials_of(const SeedParts& seeds, Workers& workers);

}  // namespace rgimp
