#pragma once

#include "rgimp/case.hpp"

namespace rgimp::verification {

/// What a study of convergence varies, whatever the problem.
struct Resolution {
  int cells = 0;             ///< per metre
  double step_factor = 0.4;  ///< alpha of Eq. 24
  Integrator integrator = Integrator::musl;
  int particles_per_cell = 2;  ///< per axis
};

/// An elastic case without damping and viscosity; bodies, materials and platens are the caller's.
inline Case plain_case(const Resolution& resolution) {
  Case settings;
  settings.grid.cell_size = 1.0 / resolution.cells;
  settings.time.step_factor = resolution.step_factor;
  settings.time.integrator = resolution.integrator;
  settings.time.steps = 1;  // the programs count their own
  settings.quadratic_viscosity = 0.0;
  settings.linear_viscosity = 0.0;
  return settings;
}

}  // namespace rgimp::verification
