#include <catch2/catch.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "models.hpp"
#include "rgimp/rgimp.hpp"
#include "temporary_directory.hpp"

// Observers see the steps they asked for, and change nothing.
namespace rgimp::tests {
namespace {

Case observed_case() {
  Case settings = cracking_block();
  settings.time.steps = 300;
  return settings;
}

}  // namespace

TEST_CASE("observers are called after the multiples of their steps, in order") {
  Simulation simulation(observed_case());
  std::vector<std::string> calls;
  simulation.every(40, [&](const Simulation& s) {
    calls.push_back("forty " + std::to_string(s.history().step));
  });
  simulation.every(
      60, [&](const Simulation& s) { calls.push_back("sixty " + std::to_string(s.steps_done())); });
  simulation.run_until(100);
  simulation.run_until(119);
  simulation.step();
  CHECK(calls ==
        std::vector<std::string>{"forty 40", "sixty 60", "forty 80", "forty 120", "sixty 120"});
}

TEST_CASE("observers change no bit, and see runs that write files too") {
  Simulation plain(observed_case());
  plain.run_until(300);

  const TemporaryDirectory directory;
  Simulation observed(observed_case());
  std::vector<double> stress;
  observed.every(7, [&](const Simulation& s) { stress.push_back(s.history().axial_stress); });
  RunOptions options;
  options.directory = directory / "out";
  run_case(observed, options);
  CHECK(stress.size() == 300 / 7);
  CHECK(stress.back() != 0.0);
  CHECK(observed.state_hash() == plain.state_hash());
}

TEST_CASE("what an observer throws comes out, and the simulation goes on") {
  Simulation plain(observed_case());
  plain.run_until(200);

  Simulation simulation(observed_case());
  simulation.every(50, [](const Simulation& s) {
    if (s.steps_done() == 100) {
      throw std::runtime_error("enough");
    }
  });
  CHECK_THROWS_WITH(simulation.run_until(200), "enough");
  CHECK(simulation.steps_done() == 100);
  simulation.run_until(200);
  CHECK(simulation.state_hash() == plain.state_hash());
}

TEST_CASE("an observer that can never be called is refused") {
  Simulation simulation(observed_case());
  CHECK_THROWS_AS(simulation.every(0, [](const Simulation&) {}), CaseError);
  CHECK_THROWS_AS(simulation.every(-3, [](const Simulation&) {}), CaseError);
  CHECK_THROWS_AS(simulation.every(10, nullptr), CaseError);
}

TEST_CASE("a simulation writes the snapshot that a run writes") {
  const TemporaryDirectory directory;
  Case settings = observed_case();
  settings.output.snapshot_every = 100;
  Simulation simulation(settings);
  simulation.every(100, [&](const Simulation& s) {
    s.write_snapshot(directory / (std::to_string(s.steps_done()) + ".vtkhdf"));
  });
  RunOptions options;
  options.directory = directory / "out";
  run_case(simulation, options);
  for (const char* step : {"100", "200", "300"}) {
    const auto own = directory / (std::string(step) + ".vtkhdf");
    const auto of_run =
        directory / "out" / "snapshots" / ("step_000000" + std::string(step) + ".vtkhdf");
    CHECK(read_text(own) == read_text(of_run));
  }
}

}  // namespace rgimp::tests
