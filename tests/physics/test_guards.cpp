#include <catch2/catch.hpp>
#include <limits>
#include <string>
#include <vector>

#include "floating_point_traps.hpp"
#include "models.hpp"
#include "rgimp/error.hpp"
#include "state_hash.hpp"
#include "temporary_directory.hpp"
#include "time_step.hpp"

namespace rgimp::tests {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::uint32_t kParticle = 37;

template <int Dim>
std::size_t lane_of(const Particles<Dim>& particles, std::uint32_t id) {
  for (std::size_t lane = 0; lane < particles.lanes(); ++lane) {
    if (particles.id[lane] == id) {
      return lane;
    }
  }
  FAIL("no particle " << id);
  return 0;
}

/// Steps until a guard stops the run, at most `most`.
template <int Dim>
std::optional<PhysicsError> stop_within(ModelIn<Dim>& model, std::int64_t most) {
  try {
    model.steps(most);
  } catch (const PhysicsError& error) {
    return error;
  }
  return std::nullopt;
}

template <int Dim>
Case small_block(Integrator integrator) {
  Case settings = compressed_block(4.0, 4.0, 0.2);
  settings.time.integrator = integrator;
  return Dim == 2 ? settings : in_space(settings, 2.0);
}

/// A column, and how many steps a value that is not finite may stay in it.
struct Place {
  std::string name;
  Column<double>& column;
  std::int64_t steps;
};

template <int Dim>
std::vector<Place> places(Particles<Dim>& particles) {
  std::vector<Place> all{{"volume", particles.volume, 2},
                         {"viscous energy", particles.viscous_energy, 1}};
  for (int a = 0; a < Dim; ++a) {
    all.push_back({"position " + std::to_string(a), particles.position[a], 1});
    all.push_back({"velocity " + std::to_string(a), particles.velocity[a], 2});
  }
  for (int c = 0; c < Particles<Dim>::kStress; ++c) {
    const bool is_out_of_plane = Dim == 2 && c == 2;
    all.push_back({"stress " + std::to_string(c), particles.stress[c],
                   is_out_of_plane ? kFullCheckEvery : 2});
  }
  return all;
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("a value that is not finite is found in whatever column it lies", "",
                       ((int Dim), Dim), 2, 3) {
  constexpr std::size_t kPlaces = 2 + 2 * Dim + Particles<Dim>::kStress;
  const WithoutTraps without_traps;
  for (const Integrator integrator : {Integrator::musl, Integrator::usl, Integrator::usf}) {
    for (std::size_t p = 0; p < kPlaces; ++p) {
      for (const double value : {kNaN, kInfinity, -kInfinity}) {
        ModelIn<Dim> model(small_block<Dim>(integrator));
        model.steps(10);
        Particles<Dim>& particles = model.solver.particles();
        const Place place = places(particles).at(p);
        place.column[lane_of(particles, kParticle)] = value;
        INFO("integrator " << static_cast<int>(integrator) << ", " << place.name << " " << value);
        CHECK_THROWS_WITH(model.solver.verify(), Catch::Contains("of particle 37 is not a finite"));
        const auto error = stop_within(model, kFullCheckEvery);
        REQUIRE(error);
        CHECK_THAT(error->what(), Catch::Contains("not finite") || Catch::Contains("not a finite"));
        CHECK(error->report().step <= 10 + place.steps);
      }
    }
  }
}

TEST_CASE("damage that is not a number is found where a material softens") {
  const WithoutTraps without_traps;
  Model model(softening_block());
  Particles<2>& particles = model.solver.particles();
  particles.damage[lane_of(particles, kParticle)] = kNaN;
  CHECK_THROWS_WITH(model.solver.rebin(), Catch::Contains("damage of particle 37"));
}

TEMPLATE_TEST_CASE_SIG("a volume that is not positive stops the run", "", ((int Dim), Dim), 2, 3) {
  const WithoutTraps without_traps;
  for (const double volume : {0.0, -1e-9}) {
    ModelIn<Dim> model(small_block<Dim>(Integrator::musl));
    Particles<Dim>& particles = model.solver.particles();
    particles.volume[lane_of(particles, kParticle)] = volume;
    CHECK_THROWS_WITH(model.solver.rebin(), Catch::Contains("particle 37 is turned inside out"));
    const auto error = stop_within(model, kFullCheckEvery);
    REQUIRE(error);
    CHECK(error->report().particle == kParticle);
    CHECK(error->report().step <= kFullCheckEvery);
  }
}

namespace {

// Closing by more than a cell within a step, below the critical step as the paper has it: nothing
// but the volume tells.
Case violent_collision() {
  Case settings = free_block(4.25, 4.0);  // meets the other in the middle of a cell
  settings.quadratic_viscosity = 0.0;
  settings.linear_viscosity = 0.0;
  settings.time.step_factor = 0.1;
  Body other = settings.bodies.front();
  other.center.x() = 4.25e-3;
  const double speed = 0.85 * 0.5e-3 / time_step(settings);
  settings.bodies.front().velocity.x() = speed;
  other.velocity.x() = -speed;
  settings.bodies.push_back(other);
  return settings;
}

}  // namespace

TEST_CASE("a violent collision that turns particles inside out stops the run") {
  Model model(violent_collision());
  const auto error = stop_within(model, 20);
  REQUIRE(error);
  CHECK_THAT(error->what(), Catch::Contains("is turned inside out, its volume is -"));
  CHECK(error->report().critical_step_ratio < 1.0);
}

TEST_CASE("no checkpoint is written of a state that is wrong") {
  const TemporaryDirectory directory;
  Simulation simulation(violent_collision());
  simulation.save(directory / "good");
  CHECK_THROWS_AS(simulation.run_until(20), PhysicsError);
  CHECK_THROWS_AS(simulation.save(directory / "bad"), PhysicsError);
  CHECK(std::filesystem::exists(directory / "good"));
  CHECK(std::distance(std::filesystem::directory_iterator(directory.path()), {}) == 1);
}

TEST_CASE("a time step beyond the critical one stops the run with the fastest particle") {
  Case settings = free_block(4.0, 4.0);
  settings.bodies.front().velocity = Vector(6000.0, 0.0, 0.0);
  Model model(settings);
  const auto error = stop_within(model, 1);
  REQUIRE(error);
  CHECK(error->report().step == 1);
  CHECK(error->report().particle == 0U);
  CHECK(error->report().velocity[0] == Approx(6000.0));
  CHECK(error->report().critical_step_ratio == model.solver.critical_step_ratio());
  CHECK(error->report().critical_step_ratio > 1.0);
  CHECK_THROWS_AS(model.solver.verify(), PhysicsError);
  CHECK_THAT(error->what(), Catch::StartsWith("step 1: the time step ") &&
                                Catch::Contains("particle 0 is the fastest: position (") &&
                                Catch::Contains(") m, velocity (6000, ") &&
                                Catch::Contains("dt/dt_cr 1.") &&
                                Catch::Contains("; lower time.step_factor"));
}

TEST_CASE("a particle out of the grid stops the run with its place") {
  Case settings = free_block(4.0, 4.0);
  settings.bodies.front().velocity = Vector(500.0, 0.0, 0.0);
  Model model(settings);
  const auto error = stop_within(model, 1000);
  REQUIRE(error);
  REQUIRE(error->report().particle);
  CHECK(*error->report().particle % 16 == 15);  // of the right end, in rows of 16
  CHECK(error->report().velocity[0] == Approx(500.0));
  CHECK(error->report().position[0] > 2e-3);
  CHECK_THAT(error->what(), Catch::Contains("left the grid: position (") &&
                                Catch::Contains("; enlarge the grid with grid.min and grid.max"));
}

TEST_CASE("in space a particle out of the grid along z stops the run with its place") {
  Case settings = free_block_in_space(Vector(2.0, 2.0, 2.0));
  settings.bodies.front().velocity = Vector(0.0, 0.0, -500.0);
  ModelIn<3> model(settings);
  const auto error = stop_within(model, 1000);
  REQUIRE(error);
  REQUIRE(error->report().particle);
  CHECK(*error->report().particle < 64);  // of the back, in planes of 8 by 8
  CHECK(error->report().velocity[2] == Approx(-500.0));
  CHECK(error->report().position[2] < -1e-3);
  CHECK_THAT(error->what(),
             Catch::Contains("left the grid: position (") && Catch::Contains(", -500) m/s"));
}

TEST_CASE("of several broken particles the lowest id is named, for any number of threads") {
  const WithoutTraps without_traps;
  std::vector<std::string> messages;
  for (const int threads : {1, 2, 7}) {
    Model model(cracking_block(), threads);
    Particles<2>& particles = model.solver.particles();
    for (const std::uint32_t id : {4001U, 38U, 2077U, 37U, 40U}) {
      particles.stress[2][lane_of(particles, id)] = kNaN;
    }
    const auto error = stop_within(model, kFullCheckEvery);
    REQUIRE(error);
    CHECK(error->report().particle == kParticle);
    messages.emplace_back(error->what());
  }
  CHECK(messages[0] == messages[1]);
  CHECK(messages[0] == messages[2]);
}

TEST_CASE("looking changes nothing") {
  Model model(cracking_block());
  Model looked_at(cracking_block());
  for (int i = 0; i < 10; ++i) {
    model.steps(3);
    looked_at.steps(3);
    looked_at.solver.verify();
  }
  CHECK(state_hash(model.solver.particles()) == state_hash(looked_at.solver.particles()));
}

}  // namespace rgimp::tests
