#include <catch2/catch.hpp>

#include "models.hpp"
#include "rgimp/rgimp.hpp"
#include "temporary_directory.hpp"

namespace rgimp::tests {
namespace {

Case short_case() {
  Case settings = compressed_block(5.0, 10.0, 0.2);
  settings.time.steps = 300;
  settings.output.snapshot_every = 100;
  return settings;
}

/// Runs the case and returns how it ended and what it had to say.
struct Outcome {
  RunEnd end;
  std::vector<std::string> notices;
  std::int64_t steps;
};

Outcome run(const Case& settings, RunOptions options) {
  Outcome outcome;
  options.on_notice = [&](const std::string& text) { outcome.notices.push_back(text); };
  Simulation simulation(settings);
  outcome.end = run_case(simulation, options);
  outcome.steps = simulation.steps_done();
  return outcome;
}

RunOptions into(const std::filesystem::path& directory,
                ExistingOutput existing = ExistingOutput::refuse) {
  RunOptions options;
  options.directory = directory;
  options.existing = existing;
  return options;
}

}  // namespace

TEST_CASE("a run that is asked to stop leaves a checkpoint and goes on from it") {
  const TemporaryDirectory directory;
  RunOptions options = into(directory / "run");
  options.stop_requested = [] { return true; };
  const Outcome stopped = run(short_case(), options);
  CHECK(stopped.end == RunEnd::stopped);
  CHECK(stopped.steps < 300);
  CHECK_FALSE(std::filesystem::exists(directory / "run" / "summary.json"));

  const Outcome resumed = run(short_case(), into(directory / "run", ExistingOutput::resume));
  CHECK(resumed.end == RunEnd::finished);
  CHECK(resumed.steps == 300);
  REQUIRE(resumed.notices.size() == 1);
  CHECK_THAT(resumed.notices[0], Catch::StartsWith("going on from step "));

  run(short_case(), into(directory / "whole"));
  for (const char* name : {"history.csv", "case.toml", "snapshots/step_000000300.vtkhdf",
                           "snapshots/snapshots.hdf.series"}) {
    INFO(name);
    CHECK(read_text(directory / "run" / name) == read_text(directory / "whole" / name));
  }

  const Outcome again = run(short_case(), into(directory / "run", ExistingOutput::resume));
  CHECK(again.end == RunEnd::was_finished);
  CHECK(again.steps == 0);
}

TEST_CASE("checkpoints keep the pace of the clock where the case names no steps") {
  const TemporaryDirectory directory;
  run(short_case(), into(directory / "slow"));
  CHECK_FALSE(std::filesystem::exists(directory / "slow" / "checkpoint_a.rgimp"));
  RunOptions options = into(directory / "fast");
  options.checkpoint_pace = std::chrono::duration<double>(0.0);
  run(short_case(), options);
  CHECK(std::filesystem::exists(directory / "fast" / "checkpoint_a.rgimp"));
  CHECK(std::filesystem::exists(directory / "fast" / "checkpoint_b.rgimp"));
}

TEST_CASE("going on with another kind of rounding is said") {
  if (!kernels::available(kernels::Isa::avx2)) {
    return;
  }
  const TemporaryDirectory directory;
  RunOptions options = into(directory / "run");
  options.stop_requested = [] { return true; };
  run(short_case(), options);
  setenv("RGIMP_ISA", "baseline", 1);
  const Outcome resumed = run(short_case(), into(directory / "run", ExistingOutput::resume));
  unsetenv("RGIMP_ISA");
  CHECK(resumed.end == RunEnd::finished);
  REQUIRE(resumed.notices.size() == 2);
  CHECK_THAT(resumed.notices[0], Catch::Contains("goes on with baseline") &&
                                     Catch::Contains("may differ in round-off"));
}

}  // namespace rgimp::tests
