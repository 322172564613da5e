#include <catch2/catch.hpp>

#include "case_text.hpp"
#include "rgimp/rgimp.hpp"

namespace {

using rgimp::testing::kExamples;
using rgimp::testing::kRightCase;
using rgimp::testing::read_text;
using rgimp::testing::with;

/// What is wrong with an override of the right case.
std::string message_of_override(const std::string& override) {
  try {
    read_text(kRightCase, {override});
  } catch (const rgimp::CaseError& error) {
    return error.what();
  }
  return "accepted";
}

}  // namespace

TEST_CASE("a case file gives the case it describes") {
  const rgimp::Case read = rgimp::read_case(kExamples / "single_flaw.toml");
  CHECK(read.title == "single 45 degree flaw under compression");
  CHECK(read.dimension == 2);
  CHECK(read.grid.cell_size == 0.5e-3);
  CHECK_FALSE(read.grid.min.has_value());
  REQUIRE(read.bodies.size() == 1);
  CHECK(read.bodies[0].size == rgimp::Vector(50e-3, 100e-3, 0.0));
  CHECK(read.bodies[0].particles_per_cell == 2);
  REQUIRE(read.flaws.size() == 1);
  CHECK(read.flaws[0].shape == rgimp::FlawShape::slot);
  CHECK(read.flaws[0].length == 15e-3);
  CHECK(read.flaws[0].width == 1.5e-3);
  CHECK(read.flaws[0].angle == 45.0);
  const rgimp::Material& rock = read.materials.at("rock");
  CHECK(rock.youngs_modulus == 17e9);
  REQUIRE(rock.failure.has_value());
  CHECK(rock.failure->cohesion == 5.95e6);
  CHECK(rock.failure->friction_angle == 40.0);
  CHECK(rock.failure->tensile_strength == 2e6);
  CHECK(rock.failure->treatment == rgimp::Treatment::no_tension);
  REQUIRE(read.platens.size() == 2);
  CHECK(read.platens[1].side == rgimp::Side::bottom);
  CHECK(read.platens[1].speed == 0.005);
  CHECK(read.platens[1].ramp == 2e-4);
  CHECK(read.time.steps == 222440);
  CHECK_FALSE(read.time.duration.has_value());
  CHECK(read.local_damping == 0.7);
  CHECK(read.quadratic_viscosity == 1.5);
  CHECK(read.linear_viscosity == 0.06);
  CHECK(read.output.history_every == 100);
  CHECK(read.output.snapshot_steps == std::vector<std::int64_t>{37000, 66240, 135360, 222440});
}

TEST_CASE("the moving platen of the disk is the lower one") {
  const rgimp::Case disk = rgimp::read_case(kExamples / "brazilian_disk.toml");
  CHECK(disk.bodies.at(0).size.x() == 40e-3);
  CHECK(disk.platens.at(0).side == rgimp::Side::bottom);
  CHECK(disk.platens.at(0).speed == 0.004);
  CHECK(disk.platens.at(1).speed == 0.0);
  CHECK(disk.platens.at(1).half_width == 1e-3);
}

TEST_CASE("lines of keys and tables are known") {
  const rgimp::Case read = read_text(kRightCase);
  CHECK(read.source.line.at("grid.cell_size") == 4);
  CHECK(read.source.line.at("body[0]") == 5);
  CHECK(read.source.line.at("body[0].size[1]") == 8);
  CHECK(read.source.line.at("material.rock.failure.cohesion") == 22);
  CHECK(read.source.line.at("platen[1].side") == 29);
}

TEST_CASE("overrides change values before anything is checked") {
  const rgimp::Case read =
      read_text(kRightCase, {"body[0].size=[0.03, 0.05]", "flaw.0.angle=30", "time.integrator=usl",
                             "material.rock.failure.cohesion=6e6", "damping.local=0.5",
                             "title=\"two words\"", "grid.min=[-0.02, -0.03]", "time.steps=10",
                             "time.steps=20", "output.snapshot_steps=[1, 2]"});
  CHECK(read.bodies[0].size == rgimp::Vector(0.03, 0.05, 0.0));
  CHECK(read.flaws[0].angle == 30.0);
  CHECK(read.time.integrator == rgimp::Integrator::usl);
  CHECK(read.materials.at("rock").failure->cohesion == 6e6);
  CHECK(read.local_damping == 0.5);
  CHECK(read.title == "two words");
  CHECK(read.grid.min.value() == rgimp::Vector(-0.02, -0.03, 0.0));
  CHECK(read.time.steps == 20);
  CHECK(read.output.snapshot_steps.size() == 2);

  // What would be wrong in the file is right once it is overridden.
  CHECK_NOTHROW(read_text(with("0.5e-3", "-1"), {"grid.cell_size=0.5e-3"}));
  CHECK(read_text(kRightCase, {"flaw=[]"}).flaws.empty());
}

TEST_CASE("errors of overrides name the override") {
  CHECK(message_of_override("grid.cel_size=1e-3") ==
        "--set grid.cel_size=1e-3: grid.cel_size: unknown key; did you mean \"cell_size\"?");
  CHECK(message_of_override("body.0.size=3") ==
        "--set body.0.size=3: body[0].size: found an integer; expected an array of 2 real numbers");
  CHECK(message_of_override("time.integrator=foo") ==
        "--set time.integrator=foo: time.integrator: \"foo\" is not one of musl, usl, usf");
  CHECK(message_of_override("grid={cell_size=-1}") ==
        "--set grid={cell_size=-1}: grid.cell_size: is -1; expected a number above 0");
  CHECK(message_of_override("body[0].size=[0.02, -1]") ==
        "--set body[0].size=[0.02, -1]: body[0].size[1]: is -1; expected a number above 0");
  CHECK(message_of_override("material.rock.poisson_ratio=0.7") ==
        "--set material.rock.poisson_ratio=0.7: material.rock.poisson_ratio: is 0.7; expected 0 or "
        "more and less than 0.5");
  CHECK(message_of_override("time.steps") == "--set time.steps: expected KEY=VALUE");
  CHECK(message_of_override("time..steps=1") ==
        "--set time..steps=1: expected a dotted key before '=', as in body[0].size=[0.05, 0.1]");
  for (const std::string key :
       {"", "body[0", "body0].size", "body[0]size", "body.", ".body", "a b"}) {
    CHECK(message_of_override(key + "=1") ==
          "--set " + key + "=1: expected a dotted key before '=', as in body[0].size=[0.05, 0.1]");
  }
  CHECK(message_of_override("time.steps=1 2") ==
        "--set time.steps=1 2: \"1 2\" is not a TOML value; expected a number, a \"string\", an "
        "[array] or a bare word");
  CHECK(message_of_override("time.steps=1\nfoo=2") ==
        "--set time.steps=1\nfoo=2: \"1\nfoo=2\" is not a TOML value; expected a number, a "
        "\"string\", an [array] or a bare word");
  CHECK(message_of_override("body[1].size=[1, 1]") ==
        "--set body[1].size=[1, 1]: body[1] does not exist; the array's length is 1");
  CHECK(message_of_override("body.rock=1") ==
        "--set body.rock=1: body[rock] does not exist; the array's length is 1");
  CHECK(message_of_override("grid.cell_size.x=1") ==
        "--set grid.cell_size.x=1: grid.cell_size is a single value and has no \"x\"");
}

TEST_CASE("a case built in code is checked under the names of its keys") {
  rgimp::Case settings = read_text(kRightCase);
  settings.source = {};
  CHECK(rgimp::check_case(settings).empty());
  settings.platens[0].speed = -0.005;  // pulls
  CHECK_NOTHROW(rgimp::check_case(settings));
  settings.platens.clear();
  CHECK_NOTHROW(rgimp::check_case(settings));

  rgimp::Case flat = settings;
  flat.bodies[0].center.z() = 1.0;
  CHECK_THROWS_WITH(rgimp::check_case(flat),
                    "body[0].center: is 1 along z; expected 0 in two dimensions");
  rgimp::Case bare = settings;
  bare.bodies.clear();
  CHECK_THROWS_WITH(rgimp::check_case(bare), "body: missing; expected at least one [[body]]");
  rgimp::Case infinite = settings;
  infinite.grid.cell_size = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_WITH(rgimp::check_case(infinite),
                    "grid.cell_size: is nan; expected a finite number");
}

TEST_CASE("without friction the tensile strength has no limit, and bodies may touch") {
  CHECK_NOTHROW(read_text(with("friction_angle = 40.0\ntensile_strength = 2e6",
                               "friction_angle = 0\ntensile_strength = 2e9")));
  CHECK_NOTHROW(read_text(with("[[flaw]]",
                               "[[body]]\nshape = \"disk\"\ncenter = [15e-3, 0]\nsize = 10e-3\n"
                               "material = \"rock\"\n[[flaw]]")));
}
