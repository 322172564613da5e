#include <catch2/catch.hpp>

#include "case_size.hpp"
#include "case_text.hpp"
#include "rgimp/error.hpp"
#include "rgimp/sweep.hpp"
#include "sweep_memory.hpp"

using namespace rgimp;
using namespace rgimp::testing;

namespace {

Sweep small_sweep(const std::vector<std::string>& overrides) {
  const ScratchDirectory scratch;
  return read_sweep(scratch.write(kRightCase), overrides);
}

double bytes_of(const SweepCase& one) {
  const CaseSize size = estimate_size(one.settings);
  return peak_bytes(size.state_bytes, size.particles);
}

}  // namespace

TEST_CASE("a sweep reads the product of its ranges, the last one varying fastest") {
  const Sweep sweep =
      small_sweep({"flaw[0].angle=30|45", "time.steps=10", "platen[0].speed=1e-3:3e-3:1e-3"});
  REQUIRE(sweep.ranges.size() == 2);
  CHECK(sweep.ranges[1].values == std::vector<std::string>{"0.001", "0.002", "0.003"});
  REQUIRE(sweep.cases.size() == 6);
  const SweepCase& fifth = sweep.cases[4];
  CHECK(fifth.name == "005");
  CHECK(fifth.settings.flaws[0].angle == 45.0);
  CHECK(fifth.settings.platens[0].speed == 0.002);
  CHECK(fifth.settings.time.steps == 10);
  CHECK(fifth.settings.tuning.threads == 1);
  CHECK(describe(sweep, fifth) == "flaw[0].angle=45, platen[0].speed=0.002");
}

TEST_CASE("the largest cases that a sweep may run at once must fit the memory together") {
  const Sweep sweep = small_sweep({"grid.cell_size=0.5e-3|0.25e-3|0.4e-3"});
  const double largest = bytes_of(sweep.cases[1]);
  const double next = bytes_of(sweep.cases[2]);
  REQUIRE(largest > next);
  REQUIRE(next > bytes_of(sweep.cases[0]));
  CHECK_NOTHROW(check_memory(sweep, 1, largest));
  CHECK_THROWS_WITH(check_memory(sweep, 1, 0.99 * largest), Catch::Contains("--jobs"));
  CHECK_NOTHROW(check_memory(sweep, 2, largest + next));
  CHECK_THROWS_AS(check_memory(sweep, 2, 0.99 * (largest + next)), CaseError);
  CHECK_NOTHROW(check_memory(sweep, 9, largest + next + bytes_of(sweep.cases[0])));
  CHECK_NOTHROW(check_memory(sweep, 3, std::nullopt));
}

TEST_CASE("a sweep that was changed in code is checked before its first case runs") {
  Sweep sweep = small_sweep({"flaw[0].angle=30|45"});
  sweep.cases[1].settings.bodies.clear();
  SweepOptions options;
  options.directory = "sweep_of_a_wrong_case";
  CHECK_THROWS_WITH(run_sweep(sweep, options), Catch::Contains("case 002 (flaw[0].angle=45)"));
  CHECK_FALSE(std::filesystem::exists(options.directory));
  options.jobs = 0;
  CHECK_THROWS_AS(run_sweep(sweep, options), CaseError);
}
