#include <catch2/catch.hpp>
#include <cmath>

#include "models.hpp"

namespace rgimp::tests {
namespace {

HistoryRow run_to(Case settings, double step_factor, double time) {
  settings.time.step_factor = step_factor;
  Model model(std::move(settings), 2);
  model.steps(std::llround(time / model.solver.dt()));
  return model.solver.history();
}

/// Torn off a platen that starts to pull fast.
Case pulled_block() {
  Case settings = free_block(5.0, 10.0);
  settings.materials["rock"].failure = rock_failure();
  settings.local_damping = 0.7;
  for (const Side side : {Side::top, Side::bottom}) {
    Platen platen;
    platen.side = side;
    platen.speed = side == Side::top ? -1.0 : 0.0;
    platen.ramp = 3e-5;
    settings.platens.push_back(platen);
  }
  return settings;
}

}  // namespace

TEST_CASE("the energy of a cracking run is accounted for within 1 %, at any time step") {
  for (const double step_factor : {0.4, 0.1}) {
    const HistoryRow row = run_to(cracking_block(), step_factor, 1.2e-4);
    INFO("step factor " << step_factor << ": missing " << missing(row) << ", W "
                        << row.external_work << ", U " << row.strain_energy << ", K "
                        << row.kinetic_energy << ", damping " << row.damping_work << ", released "
                        << row.released_energy);
    REQUIRE(row.failed_tension > 20);
    REQUIRE(std::abs(missing(row)) < 0.01);
  }
}

// Failed particles move on for most of this run: were the energy of their trial stresses booked as
// released, it would grow without bound (to 18 times the work in a longer run).
TEST_CASE("energy released by a block torn apart does not depend on the time step") {
  const HistoryRow coarse = run_to(pulled_block(), 0.1, 5e-5);
  const HistoryRow fine = run_to(pulled_block(), 0.02, 5e-5);
  INFO("released " << coarse.released_energy << " and " << fine.released_energy << ", W "
                   << coarse.external_work << " and " << fine.external_work);
  REQUIRE(coarse.failed_tension > 0);
  REQUIRE(coarse.released_energy < 0.1 * coarse.external_work);
  REQUIRE(coarse.released_energy == Approx(fine.released_energy).epsilon(0.01));
}

TEST_CASE("a flaw under compression cracks in tension from its tips, symmetrically") {
  Model model(cracking_block(), 2);
  model.steps(1000);
  const HistoryRow row = model.solver.history();
  REQUIRE(row.failed_tension > 100);
  REQUIRE(row.failed_shear == 0);
  const Vector first = model.solver.first_failure()->position;
  // Tips at +-(1.77, 1.77) mm; wings start beside them, above the upper and below the lower one.
  REQUIRE(std::abs(first.x()) < 2.3e-3);
  REQUIRE(std::abs(first.y()) > 1e-3);
  REQUIRE(std::abs(first.y()) < 3e-3);
  REQUIRE(first.x() * first.y() > 0.0);
  const Particles<2>& p = model.solver.particles();
  Vector sum = Vector::Zero();
  for (std::size_t i = 0; i < p.lanes(); ++i) {
    if (p.failure_mode[i] > kernels::kIntact) {
      sum += Vector(p.position[0][i], p.position[1][i], 0.0);
    }
  }
  REQUIRE(sum.norm() / static_cast<double>(row.failed_tension) < 0.5e-3);
}

}  // namespace rgimp::tests
