#pragma once

#include "particles.hpp"
#include "rgimp/columns.hpp"
#include "rgimp/simulation.hpp"

namespace rgimp {

/// What Simulation::particles() and columns() show.
template <int Dim>
ParticleTable table_of(const Particles<Dim>& p);
template <int Dim>
ParticleColumns columns_of(const Particles<Dim>& p);

}  // namespace rgimp
