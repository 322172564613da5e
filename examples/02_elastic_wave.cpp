// A wave in an elastic bar against theory: its period is 2 L / c, c the speed of pressure waves.
#include <cmath>
#include <cstdio>
#include <numbers>
#include <optional>

#include "rgimp/rgimp.hpp"

namespace {

constexpr double kLength = 40e-3;  // m
constexpr double kSpeed = 0.01;    // m/s, small: the theory is linear

/// The shape of the lowest mode of a bar with free ends, along y from -L/2 to L/2.
double mode(double y) {
  return std::sin(std::numbers::pi * y / kLength);
}

/// How much of the mode is in the particles' velocities, m/s.
double amplitude(const rgimp::ParticleTable& particles) {
  double sum = 0.0;
  double square = 0.0;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const double shape = mode(particles.position[i][1]);
    sum += particles.velocity[i][1] * shape;
    square += shape * shape;
  }
  return sum / square;
}

}  // namespace

int main() {
  // 1. A bar between two smooth walls, so that it cannot widen: strain along y alone.
  rgimp::Case c;
  c.grid.cell_size = 0.5e-3;
  c.materials["rock"] = {.density = 2600.0, .youngs_modulus = 17e9, .poisson_ratio = 0.14};
  c.bodies.push_back({.size = {2e-3, kLength, 0.0}, .material = "rock"});
  c.platens.push_back({.side = rgimp::Side::left});
  c.platens.push_back({.side = rgimp::Side::right});
  c.time.step_factor = 0.2;
  c.time.steps = 10000;
  c.quadratic_viscosity = c.linear_viscosity = 0.0;  // it would damp the wave

  // 2. Every particle starts with the velocity that the mode has there.
  rgimp::Simulation simulation(c);
  simulation.set_initial_state([](const rgimp::Vector& x) {
    return rgimp::InitialState{.velocity = {0.0, kSpeed * mode(x.y()), 0.0}};
  });

  // 3. Step until the mode has come back: its velocity falls through zero, then rises through it.
  std::optional<double> fell;
  std::optional<double> rose;
  double before = amplitude(simulation.particles());
  while (!rose && simulation.steps_done() < *c.time.steps) {
    simulation.step();
    const double now = amplitude(simulation.particles());
    const double crossing = simulation.time() - simulation.facts().dt * now / (now - before);
    if (!fell && now < 0.0) {
      fell = crossing;
    } else if (fell && now > 0.0) {
      rose = crossing;
    }
    before = now;
  }

  // 4. Half a period lies between the two.
  const double ratio = 0.14;
  const double modulus = 17e9 * (1.0 - ratio) / ((1.0 + ratio) * (1.0 - 2.0 * ratio));
  const double theory = 2.0 * kLength / std::sqrt(modulus / 2600.0);
  const double period = rose ? 2.0 * (*rose - *fell) : std::nan("");
  std::printf("period %.4f us; theory: %.4f us (%+.2f %%)\n", 1e6 * period, 1e6 * theory,
              100.0 * (period / theory - 1.0));
  return std::abs(period / theory - 1.0) < 0.01 ? 0 : 1;
}
