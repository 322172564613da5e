#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "models.hpp"
#include "rgimp/rgimp.hpp"
#include "temporary_directory.hpp"

// What a program puts into a simulation: an initial state, a load, a criterion.
namespace rgimp::tests {
namespace {

Case block_in(int dimension) {
  return dimension == 3 ? free_block_in_space(Vector(5.0, 8.0, 4.0)) : free_block(6.0, 10.0);
}

Case with_threads(Case settings, int threads) {
  settings.tuning.threads = threads;
  return settings;
}

/// A load that turns with time and differs from place to place.
Vector swaying(const Vector& x, double time) {
  return {2e4 * std::sin(4e5 * time) * (1.0 + 50.0 * x.y()), -1e4 * (1.0 + 100.0 * x.x()), 0.0};
}

/// Mohr-Coulomb with tension first, as a user would write it [Eq. 20, 21].
FailureMode mohr_coulomb(const IntactParticle& particle) {
  const Failure strength = rock_failure();
  const Eigen::Matrix3d& s = particle.stress;
  const double centre = 0.5 * (s(0, 0) + s(1, 1));
  const double radius = std::hypot(0.5 * (s(0, 0) - s(1, 1)), s(0, 1));
  const double major = std::max(centre + radius, s(2, 2));
  const double minor = std::min(centre - radius, s(2, 2));
  if (major >= strength.tensile_strength) {
    return FailureMode::tension;
  }
  const double angle = strength.friction_angle * std::numbers::pi / 180.0;
  const double shear = 0.5 * (major - minor) + 0.5 * (major + minor) * std::sin(angle);
  return shear >= strength.cohesion * std::cos(angle) ? FailureMode::shear : FailureMode::intact;
}

Case without_failure(Case settings) {
  settings.materials["rock"].failure = std::nullopt;
  return settings;
}

}  // namespace

TEST_CASE("an initial velocity is the bodies' velocity to the bit") {
  const int dimension = GENERATE(2, 3);
  Case moving = block_in(dimension);
  moving.bodies.front().velocity = Vector(1.0, -2.0, dimension == 3 ? 0.5 : 0.0);
  Simulation expected(moving);
  Simulation simulation(block_in(dimension));
  simulation.set_initial_state(
      [&](const Vector&) { return InitialState{.velocity = moving.bodies.front().velocity}; });

  REQUIRE(simulation.critical_step_ratio() == expected.critical_step_ratio());
  expected.run_until(50);
  simulation.run_until(50);
  REQUIRE(simulation.state_hash() == expected.state_hash());
}

TEST_CASE("an initial stress is the particles' stress, and its energy is in the budget") {
  const int dimension = GENERATE(2, 3);
  Simulation simulation(block_in(dimension));
  Eigen::Matrix3d stress = Eigen::Vector3d(-1e6, -3e6, -5e5).asDiagonal();
  stress(0, 1) = stress(1, 0) = 2e5;
  simulation.set_initial_state([&](const Vector&) { return InitialState{.stress = stress}; });

  const ParticleTable table = simulation.particles();
  REQUIRE(table.stress.front() == std::array<double, 6>{-1e6, -3e6, -5e5, 2e5, 0.0, 0.0});
  const Material material = rock();
  const double square = stress.squaredNorm();
  const double trace = stress.trace();
  const double density =
      0.5 / material.youngs_modulus *
      ((1.0 + material.poisson_ratio) * square - material.poisson_ratio * trace * trace);
  const double volume = dimension == 3 ? 5e-3 * 8e-3 * 4e-3 : 6e-3 * 10e-3;
  const HistoryRow start = simulation.history();
  REQUIRE(start.strain_energy == Approx(density * volume).epsilon(1e-12));
  REQUIRE(start.kinetic_energy == 0.0);

  simulation.run_until(100);  // free faces let go
  const HistoryRow row = simulation.history();
  CHECK(row.kinetic_energy > 0.1 * start.strain_energy);
  const double held = row.kinetic_energy + row.strain_energy + row.viscous_work;
  CHECK(std::abs(held - start.strain_energy) < 0.02 * start.strain_energy);  // MUSL's own error
}

TEST_CASE("an initial state that cannot be is refused, and changes nothing") {
  Simulation simulation(block_in(2));
  const std::uint64_t before = simulation.state_hash();
  const auto with = [&](const InitialState& state) {
    simulation.set_initial_state([&](const Vector&) { return state; });
  };
  Eigen::Matrix3d skew = Eigen::Matrix3d::Zero();
  skew(0, 1) = 1.0;
  Eigen::Matrix3d out_of_plane = Eigen::Matrix3d::Zero();
  out_of_plane(1, 2) = out_of_plane(2, 1) = 1.0;

  CHECK_THROWS_WITH(with({.velocity = Vector(NAN, 0.0, 0.0)}),
                    Catch::Matchers::StartsWith("initial state: a value that is not finite at ("));
  CHECK_THROWS_AS(with({.stress = skew}), CaseError);
  CHECK_THROWS_AS(with({.stress = out_of_plane}), CaseError);
  CHECK_THROWS_AS(with({.velocity = Vector(0.0, 0.0, 1.0)}), CaseError);
  CHECK_THROWS_AS(simulation.set_initial_state({}), CaseError);
  REQUIRE(simulation.state_hash() == before);
  simulation.step();
  CHECK_THROWS_WITH(with({}), "initial state: 1 steps are done, expected none");
}

TEST_CASE("a constant own acceleration is the case's to the bit, with every integrator") {
  const int dimension = GENERATE(2, 3);
  Case settings = block_in(dimension);
  settings.time.integrator = GENERATE(Integrator::musl, Integrator::usl, Integrator::usf);
  settings.local_damping = 0.4;
  settings.platens = {holding(Side::bottom)};
  Vector gravity(50.0, -2e4, 0.0);
  Simulation simulation(settings);
  simulation.set_acceleration([&](const Vector&, double) { return gravity; });
  settings.body_acceleration = gravity;
  Simulation expected(settings);

  expected.run_until(120);
  simulation.run_until(120);
  REQUIRE(simulation.state_hash() == expected.state_hash());
  REQUIRE(simulation.history().external_work ==
          Approx(expected.history().external_work).epsilon(1e-12));
  CHECK(simulation.history().external_work > 0.0);
}

TEST_CASE("an own acceleration sees the nodes' places and the step's start") {
  Case settings = compressed_block(6.0, 10.0, 0.5);
  Simulation simulation(with_threads(settings, 1));
  double latest = -1.0;
  double highest = 0.0;
  simulation.set_acceleration([&](const Vector& x, double time) {
    latest = std::max(latest, time);
    highest = std::max(highest, x.y());
    return Vector::Zero();
  });
  simulation.run_until(40);
  // The last pass of a step sets the next one's nodes in motion.
  CHECK(latest == Approx(simulation.time()).epsilon(1e-12));
  CHECK(highest == Approx(5e-3).epsilon(1e-3));  // the end, which the platen has moved by 1e-7 m
}

TEST_CASE("the work of an own acceleration is the kinetic energy of a free block") {
  const int dimension = GENERATE(2, 3);
  Case settings = block_in(dimension);
  settings.time.integrator = GENERATE(Integrator::musl, Integrator::usl, Integrator::usf);
  Simulation simulation(settings);
  const double frequency = 2e5;  // rad/s: changes within some steps
  simulation.set_acceleration([&](const Vector&, double time) {
    return Vector(3e3 * std::cos(frequency * time), 1e4, 0.0);
  });
  simulation.run_until(100);
  const HistoryRow row = simulation.history();
  REQUIRE(row.strain_energy < 1e-12 * row.kinetic_energy);
  REQUIRE(row.kinetic_energy > 0.0);
  REQUIRE(row.external_work == Approx(row.kinetic_energy).epsilon(1e-10));
}

TEST_CASE("an own acceleration gives the same bits on any number of threads") {
  const int dimension = GENERATE(2, 3);
  Case settings = block_in(dimension);
  settings.local_damping = 0.3;
  settings.platens = {holding(Side::bottom)};
  std::uint64_t hash = 0;
  double work = 0.0;
  for (const int threads : {1, 2, 3}) {
    Simulation simulation(with_threads(settings, threads));
    simulation.set_acceleration(swaying);
    simulation.run_until(300);
    hash = threads == 1 ? simulation.state_hash() : hash;
    work = threads == 1 ? simulation.history().external_work : work;
    REQUIRE(simulation.state_hash() == hash);
    REQUIRE(simulation.history().external_work == work);
  }
  CHECK(work > 0.0);
}

TEST_CASE("an own acceleration set between two steps acts in the second") {
  Case settings = block_in(2);
  settings.time.integrator = GENERATE(Integrator::musl, Integrator::usl, Integrator::usf);
  Simulation simulation(settings);
  Simulation expected(settings);
  simulation.run_until(5);
  expected.run_until(6);
  simulation.set_acceleration([](const Vector&, double) { return Vector(0.0, -1e4, 0.0); });
  simulation.step();
  const double gained =
      simulation.particles().velocity.front()[1] - expected.particles().velocity.front()[1];
  CHECK(gained == Approx(-1e4 * simulation.facts().dt).epsilon(1e-9));
}

TEST_CASE("an own acceleration that ends leaves the steps as without") {
  Simulation simulation(block_in(2));
  Simulation expected(block_in(2));
  simulation.set_acceleration(swaying);
  simulation.set_acceleration({});
  simulation.run_until(20);
  expected.run_until(20);
  REQUIRE(simulation.state_hash() == expected.state_hash());
}

TEST_CASE("Mohr-Coulomb as an own criterion cracks a block as the built-in one does") {
  Case settings = cracking_block();
  settings.time.integrator = GENERATE(Integrator::musl, Integrator::usl);
  Simulation expected(settings);
  Simulation simulation(without_failure(settings));
  simulation.set_criterion(mohr_coulomb);
  expected.run_until(700);
  simulation.run_until(700);

  const HistoryRow row = simulation.history();
  const HistoryRow known = expected.history();
  REQUIRE(known.failed_tension > 10);
  CHECK(row.failed_tension == known.failed_tension);
  CHECK(row.failed_shear == known.failed_shear);
  CHECK(simulation.first_failure()->step == expected.first_failure()->step);
  const ParticleTable table = simulation.particles();
  const ParticleTable known_table = expected.particles();
  CHECK((table.failure_step == known_table.failure_step));
  CHECK(row.released_energy == Approx(known.released_energy).epsilon(0.04));  // see set_criterion
  double farthest = 0.0;
  for (std::size_t i = 0; i < table.size(); ++i) {
    for (int a = 0; a < 2; ++a) {
      farthest = std::max(farthest, std::abs(table.position[i][a] - known_table.position[i][a]));
    }
  }
  // Not the same bits: after a failure the nodes' sums start from the particles anew.
  CHECK(farthest < 1e-15);  // m
}

TEST_CASE("with USF an own criterion acts on forces a step later than the built-in one") {
  Case settings = cracking_block();
  settings.time.integrator = Integrator::usf;
  Simulation expected(settings);
  Simulation simulation(without_failure(settings));
  simulation.set_criterion(mohr_coulomb);
  expected.run_until(600);
  simulation.run_until(600);
  REQUIRE(expected.first_failure());
  CHECK(simulation.first_failure()->step == expected.first_failure()->step);
  CHECK((simulation.first_failure()->position - expected.first_failure()->position).norm() < 1e-7);
}

TEST_CASE("an own criterion acts beside the material's, on any number of threads alike") {
  const int dimension = GENERATE(2, 3);
  const Case settings = dimension == 3 ? cracking_block_in_space() : cracking_block();
  const std::int64_t steps = dimension == 3 ? 600 : 700;
  // Weak along a seam: half the tensile strength.
  const auto seam = [](const IntactParticle& particle) {
    const bool is_weak = std::abs(particle.position.y() - 3e-3) < 1e-3 &&
                         particle.stress.topLeftCorner<2, 2>().trace() > 1e5;
    return is_weak ? FailureMode::shear : FailureMode::intact;
  };
  std::uint64_t hash = 0;
  for (const int threads : {1, 2, 3}) {
    Simulation simulation(with_threads(settings, threads));
    simulation.set_criterion(seam);
    simulation.run_until(steps);
    CHECK(simulation.history().failed_shear > 0);
    CHECK(simulation.history().failed_tension > 0);
    hash = threads == 1 ? simulation.state_hash() : hash;
    REQUIRE(simulation.state_hash() == hash);
  }
}

TEST_CASE("points that fail by an own criterion carry no deviator and no tension") {
  Simulation simulation(compressed_block(6.0, 10.0, 0.5));
  simulation.set_criterion([](const IntactParticle& particle) {
    return particle.id % 3 == 0 ? FailureMode::tension : FailureMode::intact;
  });
  simulation.step();
  const auto first = simulation.first_failure();  // of many at once: that of the lowest id
  REQUIRE(first);
  CHECK(first->step == 1);
  const std::array<double, 3> place = simulation.particles().position.front();
  CHECK((first->position == Vector(place[0], place[1], place[2])));
  simulation.run_until(200);
  const ParticleTable table = simulation.particles();
  for (std::size_t row = 0; row < table.size(); ++row) {
    if (table.id[row] % 3 == 0) {
      REQUIRE(table.failed[row] == FailureMode::tension);
      REQUIRE(table.failure_step[row] == 1);
      const auto& s = table.stress[row];
      REQUIRE((s[0] == s[1] && s[1] == s[2] && s[3] == 0.0 && s[0] <= 0.0));
    } else {
      REQUIRE(table.failed[row] == FailureMode::intact);
    }
  }
}

TEST_CASE("what an own function throws ends a step half done, which only a restore mends") {
  const TemporaryDirectory directory;
  const auto path = directory.path() / "state.rgimp";
  Simulation simulation(block_in(2));
  simulation.run_until(5);
  simulation.save(path);
  simulation.set_acceleration(
      [](const Vector&, double) -> Vector { throw std::domain_error("no such place"); });

  CHECK_THROWS_WITH(simulation.step(), "no such place");
  CHECK_THROWS_AS(simulation.step(), Error);
  CHECK_THROWS_AS(simulation.save(path), Error);
  simulation.set_acceleration({});
  simulation.restore(path);
  simulation.run_until(10);
  Simulation expected(block_in(2));
  expected.run_until(10);
  REQUIRE(simulation.state_hash() == expected.state_hash());
}

}  // namespace rgimp::tests
