#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "floating_point_traps.hpp"
#include "models.hpp"
#include "rgimp/rgimp.hpp"
#include "temporary_directory.hpp"

// Own functions that go wrong, and runs with own functions that are interrupted.
namespace rgimp::tests {
namespace {

/// Pushes a block to and fro along x.
Vector pushing(const Vector& x, double time) {
  return {3e5 * std::sin(2e5 * time) * (1.0 + 40.0 * x.y()), 0.0, 0.0};
}

/// Weak in tension along a seam.
FailureMode seam(const IntactParticle& particle) {
  const bool is_weak = std::abs(particle.position.y() - 1e-3) < 1e-3 && particle.stress(0, 0) > 2e4;
  return is_weak ? FailureMode::tension : FailureMode::intact;
}

Simulation simulation_with_functions() {
  Case settings = compressed_block(6.0, 10.0, 0.2);
  settings.local_damping = 0.3;
  Simulation simulation(settings);
  simulation.set_acceleration(pushing);
  simulation.set_criterion(seam);
  return simulation;
}

}  // namespace

TEST_CASE("an own acceleration that is not finite stops the run with the particles' state") {
  const WithoutTraps without_traps;
  const double value =
      GENERATE(std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity());
  Simulation simulation(free_block(6.0, 10.0));
  simulation.set_acceleration(
      [&](const Vector&, double time) { return Vector(0.0, time > 1e-6 ? value : 0.0, 0.0); });
  try {
    simulation.run_until(1000);
    FAIL("no error");
  } catch (const PhysicsError& error) {
    // Steps look at velocities; the load counts from the step that starts past 1e-6 s.
    CHECK(std::string(error.what()).find("finite") != std::string::npos);
    CHECK(error.report().step == simulation.steps_done());
    CHECK(simulation.time() - 1e-6 < 3.0 * simulation.facts().dt);
  }
  const TemporaryDirectory directory;
  CHECK_THROWS_AS(simulation.save(directory.path() / "state.rgimp"), PhysicsError);
}

TEST_CASE("what an own criterion throws ends a step half done, which only a restore mends") {
  const TemporaryDirectory directory;
  const auto path = directory.path() / "state.rgimp";
  Simulation simulation(free_block(6.0, 10.0));
  simulation.run_until(5);
  simulation.save(path);
  simulation.set_criterion(
      [](const IntactParticle&) -> FailureMode { throw std::domain_error("no such rock"); });

  CHECK_THROWS_WITH(simulation.run_until(10), "no such rock");
  CHECK_THROWS_AS(simulation.step(), Error);
  CHECK_THROWS_AS(simulation.save(path), Error);
  simulation.set_criterion({});
  simulation.restore(path);
  simulation.run_until(10);
  Simulation expected(free_block(6.0, 10.0));
  expected.run_until(10);
  REQUIRE(simulation.state_hash() == expected.state_hash());
}

TEST_CASE("a restored simulation with its functions set again goes on to the same bits") {
  const TemporaryDirectory directory;
  const auto path = directory.path() / "state.rgimp";
  Simulation whole = simulation_with_functions();
  whole.run_until(250);
  whole.save(path);
  const std::int64_t failed_by_then = whole.history().failed_tension;
  whole.run_until(500);
  REQUIRE(failed_by_then > 0);
  REQUIRE(whole.history().failed_tension > failed_by_then);

  Simulation resumed = simulation_with_functions();
  resumed.restore(path);
  resumed.run_until(500);
  REQUIRE(resumed.state_hash() == whole.state_hash());
  REQUIRE(resumed.history().external_work == whole.history().external_work);
  REQUIRE(resumed.history().released_energy == whole.history().released_energy);
}

TEST_CASE("a checkpoint is refused where a function that acted on it is missing") {
  const TemporaryDirectory directory;
  const auto path = directory.path() / "state.rgimp";
  Simulation with_both = simulation_with_functions();
  with_both.run_until(5);
  with_both.save(path);

  Simulation with_neither(with_both.settings());
  const std::uint64_t hash = with_neither.state_hash();
  CHECK_THROWS_WITH(with_neither.restore(path), "checkpoint '" + path.string() +
                                                    "': a function of the program acted on it: " +
                                                    "call set_acceleration() before restore()");
  Simulation with_load(with_both.settings());
  with_load.set_acceleration(pushing);
  CHECK_THROWS_WITH(with_load.restore(path),
                    Catch::EndsWith("call set_criterion() before restore()"));
  CHECK(with_neither.steps_done() == 0);
  CHECK(with_neither.state_hash() == hash);

  // One that has ended is not asked for.
  with_both.set_acceleration({});
  with_both.set_criterion({});
  with_both.save(path);
  with_neither.restore(path);
  CHECK(with_neither.state_hash() == with_both.state_hash());
}

TEST_CASE("the budget closes under an own load, moving platens and damping") {
  Case settings = compressed_block(6.0, 10.0, 0.2);
  settings.local_damping = 0.3;
  settings.time.step_factor = 0.1;
  Simulation simulation(settings);
  simulation.set_acceleration(pushing);
  simulation.run_until(2000);
  const HistoryRow row = simulation.history();
  REQUIRE(row.external_work > 0.0);
  CHECK(row.damping_work > 0.1 * row.external_work);
  CHECK(std::abs(missing(row)) < 0.01);
}

}  // namespace rgimp::tests
