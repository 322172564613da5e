#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <set>
#include <string>

#include "floating_point_traps.hpp"
#include "models.hpp"
#include "rgimp/rgimp.hpp"
#include "state_hash.hpp"
#include "summary.hpp"
#include "temporary_directory.hpp"

namespace rgimp::tests {
namespace {

constexpr std::int64_t kSteps = 250;     // the fragment leaves at about step 105
constexpr std::size_t kBlock = 16 * 16;  // particles, and the ids below it
constexpr std::size_t kFragment = 4 * 4;

/// A block that is pressed, and a fragment that is shot out of the grid.
Case shooting(OnExit on_exit) {
  Case settings = compressed_block(4.0, 4.0, 0.2);
  settings.grid.on_exit = on_exit;
  Body fragment;
  fragment.center = Vector(5e-3, 0.3e-3, 0.0);
  fragment.size = Vector(1e-3, 1e-3, 0.0);
  fragment.material = "rock";
  fragment.velocity = Vector(500.0, 40.0, 0.0);
  settings.bodies.push_back(fragment);
  return settings;
}

double mass_of(Particles<2>& particles) {
  double sum = 0.0;
  for (const std::size_t lane : lanes_by_id(particles)) {
    sum += particles.mass[lane];
  }
  return sum;
}

}  // namespace

TEST_CASE("a fragment that leaves the grid stops the run, or the run goes on without it") {
  Model stopping(shooting(OnExit::stop));
  CHECK_THROWS_WITH(stopping.steps(kSteps), Catch::Contains("particle 259 left the grid") &&
                                                Catch::Contains("grid.on_exit = \"remove\""));
  CHECK(stopping.solver.particles().count == kBlock + kFragment);

  Model model(shooting(OnExit::remove));
  const double before = mass_of(model.solver.particles());
  model.steps(kSteps);
  const RemovedParticles& removed = model.solver.removed();
  CHECK(removed.particles == static_cast<std::int64_t>(kFragment));
  CHECK(model.solver.particles().count == kBlock);
  CHECK(removed.mass == Approx(2600.0 * 1e-6).epsilon(1e-12));
  CHECK(mass_of(model.solver.particles()) + removed.mass == Approx(before).epsilon(1e-14));
  const std::vector<std::size_t> lanes = lanes_by_id(model.solver.particles());
  for (std::size_t i = 0; i < kBlock; ++i) {
    REQUIRE(model.solver.particles().id[lanes[i]] == i);
  }
}

TEST_CASE(
    "in space a fragment that leaves the grid along z is taken out with its mass and energy") {
  Case settings = in_space(shooting(OnExit::remove), 2.0);
  constexpr std::int64_t kDeep = 8;  // particles
  settings.bodies.back().velocity = Vector(0.0, 0.0, 500.0);
  ModelIn<3> model(settings);
  model.steps(kSteps);
  const RemovedParticles& removed = model.solver.removed();
  CHECK(removed.particles == kDeep * static_cast<std::int64_t>(kFragment));
  CHECK(model.solver.particles().count == kDeep * kBlock);
  CHECK(removed.mass == Approx(2600.0 * 2e-9).epsilon(1e-12));
  CHECK(removed.energy == Approx(0.5 * removed.mass * 500.0 * 500.0).epsilon(1e-3));
}

TEST_CASE("the energy that removed particles take along is accounted for") {
  Case settings = shooting(OnExit::remove);
  settings.platens.clear();
  settings.bodies.front().velocity.y() = 1.0;
  for (const Integrator integrator : {Integrator::musl, Integrator::usl, Integrator::usf}) {
    settings.time.integrator = integrator;
    Model model(settings);
    const HistoryRow first = model.solver.history();
    model.steps(kSteps);
    const HistoryRow last = model.solver.history();
    CHECK(last.removed_energy == Approx(0.5 * 2600.0 * 1e-6 * (500.0 * 500.0 + 40.0 * 40.0)));
    CHECK(last.kinetic_energy == Approx(0.5 * 2600.0 * 16e-6));
    CHECK(std::abs(energy_error(first, last, 0.0)) < 1e-9);
  }
}

TEST_CASE("a loaded particle takes its strain energy along") {
  Case settings = cracking_block();
  settings.grid.on_exit = OnExit::remove;
  Model model(settings);
  model.steps(300);
  const HistoryRow before = model.solver.history();
  Particles<2>& particles = model.solver.particles();
  const std::size_t lane = lanes_by_id(particles)[100];
  particles.position[1][lane] += 1.0;
  const double kinetic =
      0.5 * particles.mass[lane] *
      (std::pow(particles.velocity[0][lane], 2) + std::pow(particles.velocity[1][lane], 2));
  model.solver.rebin();
  const HistoryRow after = model.solver.history();
  CHECK(after.removed_energy > 1.1 * kinetic);
  const double held = before.kinetic_energy + before.strain_energy;
  CHECK(after.kinetic_energy + after.strain_energy + after.removed_energy ==
        Approx(held).epsilon(1e-13));
  CHECK(after.removed_energy > 1e-9 * held);
}

TEST_CASE("removals have the same bits for any number of threads") {
  std::set<std::uint64_t> hashes;
  std::set<double> energies;
  for (const int threads : {1, 2, 7}) {
    Model model(shooting(OnExit::remove), threads);
    model.steps(kSteps);
    REQUIRE(model.solver.removed().particles == static_cast<std::int64_t>(kFragment));
    hashes.insert(state_hash(model.solver.particles()));
    energies.insert(model.solver.removed().energy);
  }
  CHECK(hashes.size() == 1);
  CHECK(energies.size() == 1);
}

TEST_CASE("a policy that nothing needs changes nothing") {
  Case settings = cracking_block();
  Model stopping(settings);
  settings.grid.on_exit = OnExit::remove;
  Model removing(settings);
  stopping.steps(300);
  removing.steps(300);
  removing.solver.rebin();
  CHECK(removing.solver.removed().particles == 0);
  CHECK(state_hash(stopping.solver.particles()) == state_hash(removing.solver.particles()));
}

TEST_CASE("the last particles do not leave: the run stops with them") {
  Case settings = free_block(4.0, 4.0);
  settings.grid.on_exit = OnExit::remove;
  Model model(settings);
  Particles<2>& particles = model.solver.particles();
  for (std::size_t lane = 0; lane < particles.lanes(); ++lane) {
    particles.position[0][lane] += 1.0;
  }
  CHECK_THROWS_WITH(model.solver.rebin(), Catch::Contains("none of the particles is in the grid"));
  CHECK(particles.count == kBlock);
  CHECK(model.solver.removed().particles == 0);
}

TEST_CASE("a particle nowhere never leaves: it stops the run") {
  const WithoutTraps without_traps;
  Model model(shooting(OnExit::remove));
  model.solver.particles().position[1][lanes_by_id(model.solver.particles())[7]] =
      std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_WITH(model.solver.rebin(),
                    Catch::Contains("position of particle 7 is not a finite"));
}

TEST_CASE("the first failure stays in the record when its particle leaves") {
  Case settings = cracking_block();
  settings.grid.on_exit = OnExit::remove;
  Model model(settings);
  while (!model.solver.first_failure()) {
    model.steps(1);
  }
  const FirstFailure first = *model.solver.first_failure();
  const std::int64_t failed = model.solver.history().failed_tension;
  Particles<2>& particles = model.solver.particles();
  for (std::size_t lane = 0; lane < particles.lanes(); ++lane) {
    if (particles.failure_mode[lane] >= kernels::kFailedInTension) {
      particles.position[0][lane] += 1.0;
    }
  }
  model.solver.rebin();
  REQUIRE(model.solver.removed().particles > 0);
  model.steps(1);
  CHECK(model.solver.first_failure()->step == first.step);
  CHECK(model.solver.first_failure()->position == first.position);
  CHECK(model.solver.history().failed_tension >= failed);
}

TEST_CASE("a checkpoint knows who left") {
  const TemporaryDirectory directory;
  Simulation whole(shooting(OnExit::remove));
  whole.run_until(kSteps);
  REQUIRE(whole.removed().particles > 0);
  whole.save(directory / "state");
  Simulation resumed(shooting(OnExit::remove));
  resumed.restore(directory / "state");
  CHECK(resumed.removed().particles == whole.removed().particles);
  CHECK(resumed.removed().mass == whole.removed().mass);
  CHECK(resumed.history().removed_energy == whole.history().removed_energy);
  whole.run_until(2 * kSteps);
  resumed.run_until(2 * kSteps);
  CHECK(resumed.state_hash() == whole.state_hash());
  CHECK(resumed.particles().id == whole.particles().id);
}

}  // namespace rgimp::tests
