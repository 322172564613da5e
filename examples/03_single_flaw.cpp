// The case of single_flaw.toml built in code: step it, then read the particles.
// Usage: 03_single_flaw [STEPS], 222440 by default as in the paper.
#include <algorithm>
#include <cstdlib>
#include <iostream>

#include "rgimp/rgimp.hpp"

int main(int argc, char** argv) {
  rgimp::Case c;
  c.grid.cell_size = 0.5e-3;
  const rgimp::Failure failure{.cohesion = 5.95e6, .friction_angle = 40.0, .tensile_strength = 2e6};
  c.materials["rock"] = {
      .density = 2600.0, .youngs_modulus = 17e9, .poisson_ratio = 0.14, .failure = failure};
  c.bodies.push_back({.size = {50e-3, 100e-3, 0.0}, .material = "rock"});
  c.flaws.push_back({.length = 15e-3, .width = 1.5e-3, .angle = 45.0});
  c.platens.push_back({.side = rgimp::Side::top, .speed = 0.005, .ramp = 2e-4});
  c.platens.push_back({.side = rgimp::Side::bottom, .speed = 0.005, .ramp = 2e-4});
  c.local_damping = 0.7;
  c.time.steps = argc > 1 ? std::atoll(argv[1]) : 222440;

  rgimp::Simulation simulation(c);
  simulation.run_until(*c.time.steps);

  const auto failed = simulation.particles().failed;
  const auto intact = std::count(failed.begin(), failed.end(), rgimp::FailureMode::intact);
  std::cout << "step " << simulation.steps_done() << ": axial stress "
            << simulation.history().axial_stress * 1e-6 << " MPa, " << failed.size() - intact
            << " of " << failed.size() << " particles failed\n";
}
