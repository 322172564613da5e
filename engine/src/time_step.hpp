#pragma once

#include <cstdint>

#include "rgimp/case.hpp"

namespace rgimp {

/// Eq. 23: speed of pressure waves, m/s.
double sound_speed(const Material& material);

/// The fastest of the materials that bodies are made of, m/s.
double fastest_sound(const Case& settings);

/// Eq. 24: the constant time step, s, over the materials that bodies are made of.
double time_step(const Case& settings);

/// As given, or the whole steps that cover the duration. A real number, for a case that has not
/// been checked may ask for more than an integer holds.
double total_steps(const Case& settings);

}  // namespace rgimp
