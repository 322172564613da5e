#include "free_block.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "solver.hpp"

using std::numbers::pi;

namespace rgimp::verification {
namespace {

constexpr double kSpeed = 0.01;  // m/s, of a wave speed of 1 m/s, nearly

struct Totals {
  double momentum[2] = {};
  double size = 0.0;  // sum of |m v|
  double angular = 0.0;
};

class FreeBlock {
 public:
  FreeBlock(const Resolution& resolution, const Vector& size,
            const std::function<Vector(const Vector&)>& velocity)
      : settings_(free_case(resolution, size)),
        workers_(1),
        solver_(settings_, kernels::best_isa(), workers_) {
    Particles<2>& p = solver_.particles();
    for (std::size_t i = 0; i < p.lanes(); ++i) {
      if (!p.is_padding(i)) {
        const Vector v = velocity(Vector(p.position[0][i], p.position[1][i], 0.0));
        p.velocity[0][i] = v.x();
        p.velocity[1][i] = v.y();
      }
    }
    solver_.rebin();
  }

  double dt() const { return solver_.dt(); }

  Drift run(std::int64_t steps) {
    const Totals before = totals();
    const double energy = this->energy();
    Drift drift;
    for (drift.steps = 0; drift.steps < steps; ++drift.steps) {
      solver_.step();
      drift.energy = this->energy() / energy - 1.0;
      drift.largest_energy = std::max(drift.largest_energy, std::abs(drift.energy));
    }
    const Totals after = totals();
    drift.linear_momentum =
        std::hypot(after.momentum[0] - before.momentum[0], after.momentum[1] - before.momentum[1]) /
        before.size;
    drift.angular_momentum = before.angular == 0.0 ? 0.0 : after.angular / before.angular - 1.0;
    return drift;
  }

 private:
  static Case free_case(const Resolution& resolution, const Vector& size) {
    Case settings = plain_case(resolution);
    Body block;
    block.size = size;
    block.material = "solid";
    block.particles_per_cell = resolution.particles_per_cell;
    settings.bodies = {block};
    settings.materials["solid"] = {
        .density = 1.0, .youngs_modulus = 1.0, .poisson_ratio = 0.3, .failure = {}};
    settings.grid.min = -2.0 * Vector(size.y(), size.y(), 0.0);
    settings.grid.max = 4.0 * Vector(size.y(), size.y(), 0.0);
    return settings;
  }

  double energy() {
    const HistoryRow row = solver_.history();
    return row.kinetic_energy + row.strain_energy;
  }

  Totals totals() {
    const Particles<2>& p = solver_.particles();
    Totals sum;
    for (std::size_t i = 0; i < p.lanes(); ++i) {
      const double x = p.mass[i] * p.velocity[0][i];
      const double y = p.mass[i] * p.velocity[1][i];
      sum.momentum[0] += x;
      sum.momentum[1] += y;
      sum.size += std::hypot(x, y);
      sum.angular += p.position[0][i] * y - p.position[1][i] * x;
    }
    return sum;
  }

  Case settings_;
  Workers workers_;
  Solver<2> solver_;
};

}  // namespace

Drift spin_block(const Resolution& resolution) {
  const double rate = kSpeed / 0.5;  // rad/s
  FreeBlock block(resolution, Vector(1.0, 1.0, 0.0), [&](const Vector& x) {
    return Vector(kSpeed - rate * x.y(), rate * x.x(), 0.0);
  });
  return block.run(std::llround(2.0 * pi / rate / block.dt()));
}

Drift vibrate_block(const Resolution& resolution, std::int64_t steps) {
  FreeBlock block(resolution, Vector(1.0, 2.0, 0.0), [](const Vector& x) {
    return Vector(0.0, kSpeed * std::sin(0.5 * pi * x.y()), 0.0);
  });
  return block.run(steps);
}

}  // namespace rgimp::verification
