// A load that no case file can say: a block in a centrifuge, spun up, against theory.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "rgimp/rgimp.hpp"

namespace {

constexpr double kHeight = 40e-3;  // m, of the block, from -20 to 20 mm
constexpr double kArm = 0.5;       // m, from the axis down to the middle of the block
constexpr double kSpin = 200.0;    // rad/s in the end
constexpr double kRamp = 2e-4;     // s, some twenty times what a wave takes through the block

/// From 0 to 1, smoothly, so that the block does not ring.
double spun_up(double time) {
  const double s = std::min(time / kRamp, 1.0);
  return s * s * (3.0 - 2.0 * s);
}

/// m/s2, away from the axis, which is above; it grows downwards.
rgimp::Vector centrifuge(const rgimp::Vector& x, double time) {
  return {0.0, -kSpin * kSpin * (kArm - x.y()) * spun_up(time), 0.0};
}

}  // namespace

int main() {
  // 1. A block on the floor of its box: it can slip, but not widen.
  const double density = 2600.0;
  rgimp::Case c;
  c.grid.cell_size = 1e-3;
  c.materials["rock"] = {.density = density, .youngs_modulus = 17e9, .poisson_ratio = 0.14};
  c.bodies.push_back({.size = {20e-3, kHeight, 0.0}, .material = "rock"});
  c.platens.push_back({.side = rgimp::Side::bottom});
  c.platens.push_back({.side = rgimp::Side::left});
  c.platens.push_back({.side = rgimp::Side::right});
  c.time.duration = 4e-4;  // s
  c.local_damping = 0.3;

  // 2. The load is a function of place and time. Threads call it at once, so it only computes.
  rgimp::Simulation simulation(c);
  simulation.set_acceleration(centrifuge);
  simulation.run_until(simulation.facts().total_steps);

  // 3. Each level carries what is above it: stress = -rho w^2 (R h + h^2 / 2) over the depth, h
  //    measured from the top, R from the axis to the top.
  const rgimp::ParticleTable particles = simulation.particles();
  double worst = 0.0;
  double deepest = 0.0;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const double depth = 0.5 * kHeight - particles.position[i][1];
    const double radius = kArm - 0.5 * kHeight;
    const double theory = -density * kSpin * kSpin * (radius * depth + 0.5 * depth * depth);
    worst = std::max(worst, std::abs(particles.stress[i][1] - theory));
    deepest = std::min(deepest, theory);
  }
  std::printf("stress at the floor: theory %.4f MPa; largest error anywhere %.4f MPa (%.2f %%)\n",
              1e-6 * deepest, 1e-6 * worst, -100.0 * worst / deepest);

  // 4. Its work is in the energy budget, as that of platens is.
  const rgimp::HistoryRow row = simulation.history();
  const double held = row.strain_energy + row.kinetic_energy + row.damping_work + row.viscous_work;
  std::printf("work %.4f J/m; strain energy, motion and damping %.4f J/m (%+.2f %%)\n",
              row.external_work, held, 100.0 * (held / row.external_work - 1.0));
  return worst < -0.02 * deepest && std::abs(held / row.external_work - 1.0) < 0.01 ? 0 : 1;
}
