#pragma once

#include <cstdint>

#include "resolution.hpp"

namespace rgimp::verification {

/// What an elastic block in free flight must keep, as changes over the run.
struct Drift {
  double linear_momentum = 0.0;   ///< over the sum of |m v|
  double angular_momentum = 0.0;  ///< over that at the start
  double energy = 0.0;            ///< kinetic and strain, over that at the start
  double largest_energy = 0.0;    ///< of all steps, the largest |change|
  std::int64_t steps = 0;
};

/// A unit square of E = 1 Pa, nu = 0.3, rho = 1 kg/m3 that turns once about its centre, its edges'
/// middles at 1 % of the wave speed, and flies on at the same speed.
Drift spin_block(const Resolution& resolution);

/// A block of 1 m by 2 m of the same solid in its first longitudinal mode, 1 % of the wave speed at
/// its ends.
Drift vibrate_block(const Resolution& resolution, std::int64_t steps);

}  // namespace rgimp::verification
