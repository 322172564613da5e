#include <catch2/catch.hpp>
#include <fstream>
#include <map>
#include <memory>

#include "models.hpp"
#include "rgimp/rgimp.hpp"
#include "temporary_directory.hpp"

namespace rgimp::tests {
namespace {

constexpr std::int64_t kSteps = 1600;

/// Everything that a run writes of its last step.
void check_equal(const Simulation& one, const Simulation& other) {
  CHECK(one.steps_done() == other.steps_done());
  CHECK(one.state_hash() == other.state_hash());
  const HistoryRow a = one.history();
  const HistoryRow b = other.history();
  CHECK(a.time == b.time);
  CHECK(a.reaction == b.reaction);
  CHECK(a.external_work == b.external_work);
  CHECK(a.damping_work == b.damping_work);
  CHECK(a.viscous_work == b.viscous_work);
  CHECK(a.released_energy == b.released_energy);
  CHECK(a.failed_tension == b.failed_tension);
  CHECK(a.failed_shear == b.failed_shear);
  CHECK(one.peak_axial_stress() == other.peak_axial_stress());
  CHECK(one.critical_step_ratio() == other.critical_step_ratio());
  REQUIRE(one.first_failure().has_value() == other.first_failure().has_value());
  if (one.first_failure()) {
    CHECK(one.first_failure()->step == other.first_failure()->step);
    CHECK(one.first_failure()->position == other.first_failure()->position);
    CHECK(one.first_failure()->closure == other.first_failure()->closure);
    CHECK(one.first_failure()->axial_stress == other.first_failure()->axial_stress);
    CHECK(one.first_failure()->mode == other.first_failure()->mode);
  }
}

Case with_integrator(Case settings, Integrator integrator) {
  settings.time.integrator = integrator;
  settings.tuning.threads = 2;
  return settings;
}

}  // namespace

TEST_CASE("a restored simulation goes on to the same bits") {
  const auto integrator = GENERATE(Integrator::musl, Integrator::usl, Integrator::usf);
  const auto [name, make] = GENERATE(std::pair("the paper's rule", &cracking_block),
                                     std::pair("softening", &softening_block),
                                     std::pair("softening in space", &softening_block_in_space));
  const Case settings = with_integrator(make(), integrator);
  const TemporaryDirectory directory;
  Simulation whole(settings);
  std::map<std::int64_t, HistoryRow> rows;
  std::map<std::int64_t, double> critical;
  // From the start, before and after failure, and in odd and even steps, for the grid has two
  // layers.
  for (const std::int64_t step : {0, 1, 700, 1301}) {
    whole.run_until(step);
    whole.save(directory / std::to_string(step));
    rows[step] = whole.history();
    critical[step] = whole.critical_step_ratio();
  }
  whole.run_until(kSteps);
  REQUIRE(whole.history().failed_tension > 0);
  for (const std::int64_t step : {0, 1, 700, 1301}) {
    INFO("from step " << step << " with " << name);
    Simulation resumed(settings);
    resumed.restore(directory / std::to_string(step));
    REQUIRE(resumed.steps_done() == step);
    CHECK(resumed.history().reaction == rows[step].reaction);
    CHECK(resumed.history().axial_stress == rows[step].axial_stress);
    CHECK(resumed.critical_step_ratio() == critical[step]);
    resumed.run_until(kSteps);
    check_equal(resumed, whole);
  }
}

TEST_CASE("a simulation can go back to its own past") {
  const TemporaryDirectory directory;
  Simulation simulation(cracking_block());
  simulation.run_until(101);
  simulation.save(directory / "past", "a note");
  simulation.run_until(300);
  const std::uint64_t hash = simulation.state_hash();
  CHECK(simulation.restore(directory / "past") == "a note");
  CHECK(simulation.steps_done() == 101);
  simulation.run_until(300);
  CHECK(simulation.state_hash() == hash);
}

TEST_CASE("a checkpoint is of its own case only") {
  const TemporaryDirectory directory;
  Simulation simulation(cracking_block());
  simulation.run_until(10);
  simulation.save(directory / "checkpoint");
  Case other = cracking_block();
  other.local_damping = 0.6;
  Simulation different(other);
  const std::uint64_t before = different.state_hash();
  CHECK_THROWS_AS(different.restore(directory / "checkpoint"), CaseError);
  CHECK_THROWS_WITH(different.restore(directory / "checkpoint"),
                    Catch::Contains("it has 'local = 0.7' where this one has 'local = 0.6'"));
  CHECK(different.steps_done() == 0);
  CHECK(different.state_hash() == before);

  other = cracking_block();
  other.title = "another title";
  other.time.steps = 5;
  other.output.history_every = 7;
  other.grid.on_exit = OnExit::remove;
  other.tuning.threads = 3;
  Simulation same(other);
  same.restore(directory / "checkpoint");
  CHECK(same.state_hash() == simulation.state_hash());
}

TEST_CASE("a file that is no state of the case leaves the simulation as it was") {
  const TemporaryDirectory directory;
  Model model(cracking_block());
  model.steps(5);
  {
    CheckpointWriter writer(directory / "larger", 5);
    model.solver.save(writer);
    writer.finish({"", ""});
  }
  Case smaller = cracking_block();
  smaller.bodies.front().size.y() = 20e-3;
  Model other(smaller);
  other.steps(3);
  const CheckpointReader reader("larger", std::make_unique<std::ifstream>(directory / "larger"));
  CHECK_THROWS_AS(other.solver.restore(reader), FileError);
  CHECK(other.solver.steps_done() == 3);
  other.steps(1);
  Model undisturbed(smaller);
  undisturbed.steps(4);
  CHECK(other.solver.history().external_work == undisturbed.solver.history().external_work);
  CHECK(other.solver.history().kinetic_energy == undisturbed.solver.history().kinetic_energy);
}

}  // namespace rgimp::tests
