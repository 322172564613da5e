#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "ledger.hpp"
#include "models.hpp"
#include "time_step.hpp"

// What rows report, summed; and the time step that a case asks for.
namespace rgimp::tests {
namespace {

Platen platen_on(Side side, double speed) {
  Platen platen;
  platen.side = side;
  platen.speed = speed;
  return platen;
}

/// Loaded along x by two platens, held by one along y; 6 mm wide, 2 mm high.
Case loaded_along_x() {
  Case settings = free_block(6.0, 2.0);
  settings.platens = {platen_on(Side::bottom, 0.0), platen_on(Side::left, 0.1),
                      platen_on(Side::right, 0.3)};
  return settings;
}

}  // namespace

TEST_CASE("a step's works add up over rows and steps, reactions over rows alone") {
  Ledger ledger(loaded_along_x(), 2);
  for (int step = 0; step < 2; ++step) {
    for (int row = 0; row < 2; ++row) {
      ledger.nodes()[row] = {.damping_work = 1.0 + row, .body_force_work = 10.0};
      ledger.particles()[row] = {
          .viscous_work = 0.5, .released_energy = 0.25, .failed_tension = 3, .failed_shear = row};
      ledger.platens()[row].work = 100.0;
      ledger.platens()[row].reaction = {7.0, 2.0 - step, 4.0 - step};
    }
    ledger.reach()[0] = {.distance = 0.6 - 0.1 * step, .step = 1e-6};
    ledger.reach()[1] = {.distance = 0.4, .step = 2e-6};
    ledger.add_nodes();
    ledger.add_particles(1e-3);
  }
  CHECK(ledger.budget().external_work == 2.0 * 2.0 * 110.0);
  CHECK(ledger.budget().damping_work == 2.0 * 3.0);
  CHECK(ledger.budget().viscous_work == 2.0);
  CHECK(ledger.budget().released_energy == 1.0);
  CHECK(ledger.failed_tension() == 12);
  CHECK(ledger.failed_shear() == 2);
  CHECK(ledger.farthest() == 0.5);
  CHECK(ledger.max_speed() == Approx(2e-3));
  // Rows: 2 (1 + 3) of the last step, over two platens; the bottom's is not on the load's axis.
  CHECK(ledger.reaction() == 4.0);
  CHECK(ledger.axial_stress() == Approx(4.0 / 2e-3));
  CHECK(ledger.peak_axial_stress() == Approx(6.0 / 2e-3));
  CHECK(ledger.closure(2.0) == Approx(0.8));
}

namespace {

/// Pa, where the two platens across the load's axis report 1 N each.
double stress_of_one_newton(Case settings, Side low, Side high) {
  settings.platens = {platen_on(low, 0.0), platen_on(high, 0.1)};
  Ledger ledger(settings, 1);
  ledger.platens()[0].reaction = {1.0, 1.0};
  ledger.add_nodes();
  return ledger.axial_stress();
}

/// 8 mm thick, 12 mm long.
Body cylinder_along(const Vector& axis) {
  Body body;
  body.shape = BodyShape::cylinder;
  body.size = Vector(8e-3, 12e-3, 0.0);
  body.axis = axis;
  body.material = "rock";
  return body;
}

}  // namespace

TEST_CASE("in space the axial stress is over the bounding rectangle across the load") {
  const Case settings = free_block_in_space(Vector(2.0, 3.0, 5.0));
  CHECK(stress_of_one_newton(settings, Side::left, Side::right) == Approx(1.0 / 15e-6));
  CHECK(stress_of_one_newton(settings, Side::bottom, Side::top) == Approx(1.0 / 10e-6));
  CHECK(stress_of_one_newton(settings, Side::back, Side::front) == Approx(1.0 / 6e-6));
}

TEST_CASE(
    "the axial stress of one core loaded along its axis, and of it alone, is over its circle") {
  Case settings = free_block_in_space(Vector(2.0, 3.0, 5.0));
  const double circle = 1.0 / (4e-3 * 4e-3 * std::numbers::pi);
  settings.bodies = {cylinder_along(Vector(0.0, -3.0, 0.0))};  // of any length, either way
  CHECK(stress_of_one_newton(settings, Side::bottom, Side::top) == Approx(circle));
  CHECK(stress_of_one_newton(settings, Side::back, Side::front) == Approx(1.0 / 96e-6));
  settings.bodies = {cylinder_along(Vector(0.0, 0.0, 1.0))};
  CHECK(stress_of_one_newton(settings, Side::back, Side::front) == Approx(circle));
  settings.bodies.push_back(settings.bodies.front());
  CHECK(stress_of_one_newton(settings, Side::back, Side::front) == Approx(1.0 / 64e-6));
}

TEST_CASE("the fastest sound of all bodies decides on the time step, whatever their order") {
  Case settings = free_block(5.0, 5.0);
  settings.materials["stiff"] = rock();
  settings.materials["stiff"].youngs_modulus *= 4.0;
  const double speed = std::sqrt(17e9 * 0.86 / (1.14 * 0.72 * 2600.0));
  CHECK(time_step(settings) == Approx(0.4 * 0.5e-3 / speed).epsilon(1e-14));
  for (const std::size_t stiff : {0U, 1U}) {
    settings.bodies = {settings.bodies.front(), settings.bodies.front()};
    settings.bodies[stiff].material = "stiff";
    settings.bodies[1 - stiff].material = "rock";
    CHECK(time_step(settings) == Approx(0.2 * 0.5e-3 / speed).epsilon(1e-14));
  }
}

TEST_CASE("a duration is reached by the least number of steps, round-off apart") {
  Case settings = free_block(5.0, 5.0);
  settings.time.steps.reset();
  const double dt = time_step(settings);
  for (const double steps : {1.0, 3.0, 777.0}) {
    settings.time.duration = steps * dt;
    CHECK(total_steps(settings) == steps);
    settings.time.duration = (steps + 0.01) * dt;
    CHECK(total_steps(settings) == steps + 1.0);
    settings.time.duration = std::nextafter(steps * dt, 1.0);
    CHECK(total_steps(settings) == steps);
  }
}

}  // namespace rgimp::tests
