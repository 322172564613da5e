#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "models.hpp"
#include "rgimp/error.hpp"
#include "rgimp/simulation.hpp"

namespace rgimp::tests {
namespace {

/// Sums over particles: momentum along x and y, what it is made of in absolute value, mass.
struct Totals {
  double momentum[2] = {};
  double size = 0.0;
  double mass = 0.0;
};

Totals totals(const Particles<2>& p) {
  Totals sum;
  for (std::size_t i = 0; i < p.lanes(); ++i) {
    for (int a = 0; a < 2; ++a) {
      sum.momentum[a] += p.mass[i] * p.velocity[a][i];
      sum.size += std::abs(p.mass[i] * p.velocity[a][i]);
    }
    sum.mass += p.mass[i];
  }
  return sum;
}

/// Stretching, shearing and flying, so that stresses, bins and directions all change.
void stir(Model& model) {
  Particles<2>& p = model.solver.particles();
  for (std::size_t i = 0; i < p.lanes(); ++i) {
    const double wave = 2.0 * std::numbers::pi * p.position[1][i] / 5e-3;
    p.velocity[0][i] = 8.0 + 2.0 * std::sin(wave);
    p.velocity[1][i] = -5.0 + 3.0 * std::cos(wave + 400.0 * p.position[0][i]);
  }
}

/// Largest difference of positions, velocities (relative to the largest) and stresses, by id.
double largest_difference(Model& one, Model& other) {
  const auto by_id = [](Particles<2>& p, const Column<double>& column) {
    std::vector<double> values(p.count);
    for (std::size_t i = 0; i < p.lanes(); ++i) {
      if (!p.is_padding(i)) {
        values[p.id[i]] = column[i];
      }
    }
    return values;
  };
  double worst = 0.0;
  const auto compare = [&](const Column<double>& a, const Column<double>& b) {
    const std::vector<double> va = by_id(one.solver.particles(), a);
    const std::vector<double> vb = by_id(other.solver.particles(), b);
    double scale = 0.0;
    double apart = 0.0;
    for (std::size_t i = 0; i < va.size(); ++i) {
      scale = std::max(scale, std::abs(va[i]));
      apart = std::max(apart, std::abs(va[i] - vb[i]));
    }
    worst = std::max(worst, apart / scale);
  };
  Particles<2>& a = one.solver.particles();
  Particles<2>& b = other.solver.particles();
  for (int axis = 0; axis < 2; ++axis) {
    compare(a.position[axis], b.position[axis]);
    compare(a.velocity[axis], b.velocity[axis]);
  }
  for (int c = 0; c < 4; ++c) {
    compare(a.stress[c], b.stress[c]);
  }
  return worst;
}

Case flying_block(Integrator integrator) {
  Case settings = free_block(10.0, 15.0);
  settings.grid.min = Vector(-10e-3, -12.5e-3, 0.0);
  settings.grid.max = Vector(10e-3, 12.5e-3, 0.0);
  settings.time.integrator = integrator;
  return settings;
}

const Integrator kIntegrators[] = {Integrator::musl, Integrator::usl, Integrator::usf};

}  // namespace

TEST_CASE("mass and momentum are conserved to round-off over 1,000 free steps") {
  for (const Integrator integrator : kIntegrators) {
    Model model(flying_block(integrator), 2);
    stir(model);
    const Totals before = totals(model.solver.particles());
    model.steps(1000);
    const Totals after = totals(model.solver.particles());
    INFO("integrator " << static_cast<int>(integrator) << ", re-bins " << model.solver.rebins());
    REQUIRE(model.solver.rebins() >= 2);  // it crossed cells
    REQUIRE(after.mass == before.mass);
    for (int a = 0; a < 2; ++a) {
      REQUIRE(std::abs(after.momentum[a] - before.momentum[a]) <= 1e-12 * before.size);
    }
    double on_nodes = 0.0;
    const kernels::GridView<2> grid = model.solver.grid().view();
    for (std::ptrdiff_t n = 0; n < model.solver.grid().rows() * model.solver.grid().row_stride();
         ++n) {
      on_nodes += grid.mass[n];
    }
    REQUIRE(on_nodes == Approx(before.mass).epsilon(1e-13));
  }
}

TEST_CASE("binning every 50 steps changes an elastic run by less than 1e-10") {
  for (const Integrator integrator : kIntegrators) {
    Model seldom(flying_block(integrator));
    Model often(flying_block(integrator));
    stir(seldom);
    stir(often);
    for (int part = 0; part < 10; ++part) {
      seldom.steps(50);
      often.steps(50);
      often.solver.rebin();
    }
    INFO("integrator " << static_cast<int>(integrator));
    REQUIRE(often.solver.rebins() > seldom.solver.rebins());
    REQUIRE(largest_difference(seldom, often) < 1e-10);
  }
}

TEST_CASE("free fall: body force accelerates and nothing else happens") {
  Case settings = free_block(5.0, 5.0);
  settings.body_acceleration = Vector(1.0, -9.81, 0.0);
  Model model(settings);
  model.steps(200);
  const double time = model.solver.time();
  const Particles<2>& p = model.solver.particles();
  for (std::size_t i = 0; i < p.lanes(); ++i) {
    if (!p.is_padding(i)) {
      REQUIRE(p.velocity[0][i] == Approx(time).epsilon(1e-10));
      REQUIRE(p.velocity[1][i] == Approx(-9.81 * time).epsilon(1e-10));
    }
  }
  const HistoryRow row = model.solver.history();
  REQUIRE(row.external_work == Approx(row.kinetic_energy).epsilon(1e-9));
}

TEST_CASE("a step past the critical one and a particle out of the grid stop the run") {
  Case fast = free_block(5.0, 5.0);
  fast.bodies[0].velocity = Vector(4000.0, 0.0, 0.0);
  Model too_fast(fast);
  REQUIRE_THROWS_WITH(too_fast.steps(1), Catch::Contains("times the critical one"));

  Case leaving = free_block(5.0, 5.0);
  leaving.bodies[0].velocity = Vector(300.0, 0.0, 0.0);
  Model gone(leaving);
  REQUIRE_THROWS_WITH(gone.steps(2000), Catch::Contains("left the grid"));
}

}  // namespace rgimp::tests
