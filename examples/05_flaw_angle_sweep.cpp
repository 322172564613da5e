// The angle of a flaw against the stress at which the specimen cracks, several cases at once.
// Usage: 05_flaw_angle_sweep [STEPS], 20000 by default: half a minute on two cores.
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <thread>
#include <vector>

#include "rgimp/rgimp.hpp"

namespace {

/// Stresses in Pa, compression > 0.
struct Outcome {
  std::optional<rgimp::FirstFailure> first;
  double peak = 0.0;
};

/// The first example's block with coarser cells and faster platens: this is about the way, not
/// about the figures.
rgimp::Case block_with_flaw(double angle, std::int64_t steps) {
  rgimp::Case c;
  c.grid.cell_size = 1e-3;
  c.materials["rock"] = {.density = 2600.0,
                         .youngs_modulus = 17e9,
                         .poisson_ratio = 0.14,
                         .failure = rgimp::Failure{
                             .cohesion = 5.95e6, .friction_angle = 40.0, .tensile_strength = 2e6}};
  c.bodies.push_back({.size = {50e-3, 100e-3, 0.0}, .material = "rock"});
  c.flaws.push_back({.length = 15e-3, .width = 3e-3, .angle = angle});
  c.platens.push_back({.side = rgimp::Side::top, .speed = 0.05, .ramp = 2e-4});
  c.platens.push_back({.side = rgimp::Side::bottom, .speed = 0.05, .ramp = 2e-4});
  c.local_damping = 0.7;
  c.time.steps = steps;
  c.tuning.threads = 1;  // the cores are shared out among the cases, not within one
  return c;
}

Outcome simulate(double angle, std::int64_t steps) {
  rgimp::Simulation simulation(block_with_flaw(angle, steps));
  simulation.run_until(steps);
  return {simulation.first_failure(), simulation.peak_axial_stress()};
}

}  // namespace

int main(int argc, char** argv) {
  const std::int64_t steps = argc > 1 ? std::atoll(argv[1]) : 20000;
  const std::vector<double> angles{0.0, 15.0, 30.0, 45.0, 60.0, 75.0};  // degrees from +x

  // 1. Simulations share nothing, so each may run on a thread of its own. As many threads as cores
  //    take the next case until none is left.
  std::vector<Outcome> outcomes(angles.size());
  std::atomic<std::size_t> next = 0;
  {
    std::vector<std::jthread> threads;
    for (int i = 0; i < rgimp::describe_machine().threads; ++i) {
      threads.emplace_back([&] {
        for (std::size_t one = next++; one < angles.size(); one = next++) {
          outcomes[one] = simulate(angles[one], steps);
        }
      });
    }
  }  // the threads end here

  // 2. The table. `rgimp sweep` does the same from a case file, with files for every case.
  std::printf("angle, degrees   first failure, MPa   peak, MPa\n");
  for (std::size_t i = 0; i < angles.size(); ++i) {
    const Outcome& outcome = outcomes[i];
    std::printf("%14.0f   ", angles[i]);
    if (outcome.first) {
      std::printf("%18.2f", 1e-6 * outcome.first->axial_stress);
    } else {
      std::printf("%18s", "none");
    }
    std::printf("   %9.2f\n", 1e-6 * outcome.peak);
  }
}
