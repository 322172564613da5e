#pragma once

#include <vector>

#include "geometry.hpp"
#include "rgimp/grid_fields.hpp"

namespace rgimp {

/// grid_fields() where the case's seeds are known: they are those of all its snapshots.
GridFields grid_fields(const Case& settings, const std::vector<ParticleSeed>& seeds,
                       const ParticleTable& particles, std::int64_t step);

}  // namespace rgimp
