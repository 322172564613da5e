#pragma once

#include <cstdint>

#include "particles.hpp"
#include "rgimp/extension.hpp"

namespace rgimp {

/// Gives every particle the field's velocity and stress; returns the largest speed, m/s. Throws
/// CaseError, see Simulation::set_initial_state; then the particles are as they were.
template <int Dim>
double set_initial_state(const InitialField& field, std::int64_t steps_done,
                         Particles<Dim>& particles);

}  // namespace rgimp
