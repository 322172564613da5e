#include <catch2/catch.hpp>

#include "case_text.hpp"
#include "rgimp/rgimp.hpp"

namespace {

using rgimp::testing::kRightCase;
using rgimp::testing::read_text;
using rgimp::testing::ScratchDirectory;
using rgimp::testing::with;
using Warnings = std::vector<std::string>;

}  // namespace

TEST_CASE("warnings are sentences with their place") {
  const ScratchDirectory scratch;
  const auto path = scratch.write(with("width = 1.5e-3", "width = 1e-3"));
  const std::vector<std::string> warnings = rgimp::check_case(rgimp::read_case(path));
  REQUIRE(warnings.size() == 1);
  CHECK(warnings[0] == path.string() +
                           ":14: flaw[0].width: an oblique slot 2 cells across still carries load "
                           "(at two cells, 27 % of a 45 degree slot's compliance is missing); "
                           "better three cells, 0.0015 m");

  // Along a grid line two cells are enough.
  for (const char* angle : {"flaw[0].angle=0", "flaw[0].angle=90", "flaw[0].angle=-180.0"}) {
    CHECK(rgimp::check_case(rgimp::read_case(path, std::vector<std::string>{angle})).empty());
  }
}

TEST_CASE("snapshots past the last step are named") {
  CHECK(rgimp::check_case(read_text(kRightCase, {"output.snapshot_steps=[1000, 1001, 0, 5000]"})) ==
        Warnings{"--set output.snapshot_steps=[1000, 1001, 0, 5000]: output.snapshot_steps: no "
                 "snapshot of 1001, 5000; the last step is 1000"});
  CHECK(rgimp::check_case(read_text(kRightCase, {"output.snapshot_steps=[0, 1000]"})).empty());
}

TEST_CASE("a box that particles do not fill is named with the sizes next to it") {
  rgimp::Case settings = read_text(kRightCase);
  settings.source = {};
  settings.platens.clear();
  settings.bodies[0].size = {20.1e-3, 40.4e-3, 0.0};
  CHECK(rgimp::check_case(settings) ==
        Warnings{"body[0].size[0]: is 0.0201 m, 80.4 particles of 0.00025 m; whole numbers of "
                 "particles make 0.02 or 0.02025 m",
                 "body[0].size[1]: is 0.0404 m, 161.6 particles of 0.00025 m; whole numbers of "
                 "particles make 0.04025 or 0.0405 m"});

  settings.bodies[0].size = {20.25e-3, 0.3 * 0.1, 0.0};  // round-off is no remainder
  CHECK(rgimp::check_case(settings).empty());
  settings.bodies[0].shape = rgimp::BodyShape::disk;
  settings.bodies[0].size = {20.1e-3, 0.0, 0.0};
  CHECK(rgimp::check_case(settings).empty());
}
