// The case of single_flaw.toml built in code: step it, then read the particles.
// Usage: single_flaw [STEPS], 222440 by default as in the paper.
#include <cstdio>
#include <cstdlib>
#include <exception>

#include "rgimp/rgimp.hpp"

int main(int argc, char** argv) try {
  rgimp::Failure failure{.cohesion = 5.95e6, .friction_angle = 40.0, .tensile_strength = 2e6};
  rgimp::Case c;
  c.title = "single 45 degree flaw";
  c.grid.cell_size = 0.5e-3;
  c.materials["rock"] = {
      .density = 2600.0, .youngs_modulus = 17e9, .poisson_ratio = 0.14, .failure = failure};
  c.bodies.push_back({.size = {50e-3, 100e-3, 0.0}, .material = "rock"});
  c.flaws.push_back({.length = 15e-3, .width = 1.5e-3, .angle = 45.0});
  for (const rgimp::Side side : {rgimp::Side::top, rgimp::Side::bottom}) {
    c.platens.push_back({.side = side, .speed = 0.005, .ramp = 2e-4});
  }
  c.local_damping = 0.7;
  c.time.steps = argc > 1 ? std::atoll(argv[1]) : 222440;

  rgimp::Simulation simulation(c);
  simulation.run_until(*c.time.steps);

  const rgimp::ParticleTable particles = simulation.particles();
  std::size_t failed = 0;
  for (const rgimp::FailureMode mode : particles.failed) {
    failed += mode != rgimp::FailureMode::intact ? 1 : 0;
  }
  const rgimp::HistoryRow now = simulation.history();
  std::printf("step %lld: closure %.4g mm, axial stress %.4g MPa, %zu of %zu particles failed\n",
              static_cast<long long>(now.step), now.closure * 1e3, now.axial_stress * 1e-6, failed,
              particles.size());
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
