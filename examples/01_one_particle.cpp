// The smallest simulation: one particle that falls. What a case is made of, and what a step does.
#include <cmath>
#include <cstdio>

#include "rgimp/rgimp.hpp"

int main() {
  // 1. A grid of 1 mm cells. The grid is only where forces are added up: nothing is kept on it from
  //    step to step, all that lasts is in the particles.
  rgimp::Case c;
  c.grid.cell_size = 1e-3;

  // 2. A body is filled with particles, two per cell and axis. Half a cell holds one.
  c.materials["rock"] = {.density = 2600.0, .youngs_modulus = 17e9, .poisson_ratio = 0.14};
  c.bodies.push_back({.size = {0.5e-3, 0.5e-3, 0.0}, .material = "rock"});

  // 3. Gravity, and a number of steps. The time step follows from the speed of sound [Eq. 24].
  const double gravity = 9.81;  // m/s2, downwards
  c.body_acceleration = {0.0, -gravity, 0.0};
  c.time.steps = 1000;

  // 4. The simulation: one step after the other until `steps` are done.
  rgimp::Simulation simulation(c);
  const double start = simulation.particles().position[0][1];
  simulation.run_until(*c.time.steps);

  // 5. It has fallen as Galileo says. USL and MUSL move particles with the velocity at the end of a
  //    step, hence the half step in the theory.
  const rgimp::ParticleTable particles = simulation.particles();
  const double time = simulation.time();
  const double fallen = start - particles.position[0][1];
  const double theory = 0.5 * gravity * time * (time + simulation.facts().dt);
  std::printf("%zu particle fell %.6e m in %.6e s; theory: %.6e m (%+.1e)\n", particles.size(),
              fallen, time, theory, fallen / theory - 1.0);
  return std::abs(fallen / theory - 1.0) < 1e-9 ? 0 : 1;
}
