#include <catch2/catch.hpp>

#include "case_text.hpp"
#include "rgimp/rgimp.hpp"

namespace {

using rgimp::testing::kExamples;
using rgimp::testing::read_text;

/// Every table, and values that are hard to write.
const std::string kEverything = R"(title = "quote \" backslash \\ tab \t end"
[grid]
cell_size = 0.30000000000000004e-3
min = [-0.0171, -0.0201]
max = [0.05, 0.02]
on_exit = "remove"
[[body]]
shape = "disk"
center = [0.1e-3, 0.2e-3]
size = 0.03
material = "hard rock"
particles_per_cell = 3
velocity = [1e-300, -7]
[[flaw]]
shape = "circle"
center = [0.0, 0.0]
length = 1e-3
[[flaw]]
shape = "box"
center = [3e-3, 0.0]
size = [1e-3, 2e-3]
[[flaw]]
shape = "slot"
center = [-3e-3, 0.0]
length = 5e-3
width = 1e-3
angle = 33.333333333333336
ends = "round"
[material."hard rock"]
density = 2600
youngs_modulus = 1e22
poisson_ratio = 0
failure = {criterion = "shear-strain", shear_strain = 1e-4, treatment = "pressure-window", pressure_min = -1.5, pressure_max = 2e5}
[material.soft]
density = 1
youngs_modulus = 2
poisson_ratio = 0.3
[material.tough]
density = 1
youngs_modulus = 2e6
poisson_ratio = 0.3
failure = {criterion = "principal-stress", tensile_strength = 1e2, fracture_energy = 0.75}
[time]
duration = 1e-6
integrator = "usf"
[damping]
local = 0.1
[viscosity]
quadratic = 0
linear = 0.1
[body_force]
acceleration = [0.0, -9.81]
[output]
history_every = 7
snapshot_every = 3
snapshot_steps = [1, 2]
checkpoint_every = 11
[numerics]
band_height = 6
[tuning]
threads = 2
bands_per_task = 3
)";

/// The same for three dimensions; the grid lines stay on the cylinder's ends.
const std::string kEverySolid = R"(dimension = 3
[grid]
cell_size = 1e-3
min = [-0.02, -0.03, -0.02]
max = [0.08, 0.03, 0.025]
[[body]]
shape = "cylinder"
center = [0.0, 0.0, 0.0]
size = [0.02, 0.04]
axis = [0.0, -2.5, 0.0]
material = "rock"
velocity = [1.0, -7.0, 1e-300]
[[body]]
shape = "sphere"
center = [0.03, 0.0, 0.0]
size = 0.02
material = "rock"
[[body]]
shape = "box"
center = [0.05, 0.0, 0.0]
size = [0.01, 0.02, 0.03]
material = "rock"
[[flaw]]
shape = "slot"
center = [0.0, 0.0, 0.0]
length = 8e-3
width = 3e-3
direction = [1.0, 2.0, 0.30000000000000004]
normal = [-2.0, 1.0, 0.0]
ends = "round"
[[flaw]]
shape = "slot"
center = [0.0, 0.0, 0.0]
length = 8e-3
width = 3e-3
depth = 4e-3
angle = 33.333333333333336
[[flaw]]
shape = "penny"
center = [0.0, 0.0, 1e-3]
length = 8e-3
width = 3e-3
normal = [0.1, 0.2, -0.3]
[[flaw]]
shape = "sphere"
center = [0.0, 0.01, 0.0]
length = 4e-3
[[flaw]]
shape = "box"
center = [0.05, 0.0, 0.0]
size = [3e-3, 4e-3, 5e-3]
[material.rock]
density = 2600
youngs_modulus = 17e9
poisson_ratio = 0.14
[[platen]]
side = "back"
speed = 0.0
half_width = 2e-3
[[platen]]
side = "front"
speed = 0.1
[time]
steps = 10
[body_force]
acceleration = [0.0, -9.81, 0.5]
)";

rgimp::Case read_back() {
  return read_text(rgimp::write_case(read_text(kEverything)));
}

}  // namespace

TEST_CASE("what is written reads back to the same text") {
  const std::string text = rgimp::write_case(read_text(kEverything));
  CHECK(rgimp::write_case(read_text(text)) == text);
  CHECK(text.find("\nsnapshot_steps = [1, 2]             # besides") != std::string::npos);
}

TEST_CASE("what is written reads back to the same shapes") {
  const rgimp::Case second = read_back();
  CHECK(second.title == "quote \" backslash \\ tab \t end");
  CHECK(second.grid.cell_size == 0.30000000000000004e-3);
  CHECK(second.grid.min.value() == rgimp::Vector(-0.0171, -0.0201, 0.0));
  CHECK(second.grid.max.value() == rgimp::Vector(0.05, 0.02, 0.0));
  CHECK(second.grid.on_exit == rgimp::OnExit::remove);
  CHECK(second.bodies.at(0).velocity == rgimp::Vector(1e-300, -7.0, 0.0));
  CHECK(second.bodies.at(0).particles_per_cell == 3);
  CHECK(second.bodies.at(0).size == rgimp::Vector(0.03, 0.0, 0.0));
  CHECK(second.flaws.at(0).length == 1e-3);
  CHECK(second.flaws.at(1).size == rgimp::Vector(1e-3, 2e-3, 0.0));
  CHECK(second.flaws.at(2).ends == rgimp::SlotEnds::round);
  CHECK(second.flaws.at(2).angle == 33.333333333333336);
}

TEST_CASE("what is written reads back to the same materials") {
  const rgimp::Case second = read_back();
  const rgimp::Material& hard = second.materials.at("hard rock");
  CHECK(hard.youngs_modulus == 1e22);
  CHECK(hard.failure->criterion == rgimp::Criterion::shear_strain);
  CHECK(hard.failure->shear_strain == 1e-4);
  CHECK(hard.failure->shear_strength == 0.0);
  CHECK(hard.failure->treatment == rgimp::Treatment::pressure_window);
  CHECK(hard.failure->pressure_min == -1.5);
  CHECK(second.materials.at("tough").failure->fracture_energy == 0.75);
  CHECK_FALSE(second.materials.at("soft").failure.has_value());
}

TEST_CASE("what is written reads back to the same loads, times and outputs") {
  const rgimp::Case second = read_back();
  CHECK(second.platens.empty());
  CHECK(second.time.duration == 1e-6);
  CHECK_FALSE(second.time.steps.has_value());
  CHECK(second.time.integrator == rgimp::Integrator::usf);
  CHECK(second.quadratic_viscosity == 0.0);
  CHECK(second.body_acceleration.y() == -9.81);
  CHECK(second.output.snapshot_steps == std::vector<std::int64_t>{1, 2});
  CHECK(second.output.checkpoint_every == 11);
  CHECK(second.tuning.threads == 2);
  CHECK(second.tuning.bands_per_task == 3);
  CHECK(second.numerics.band_height == 6);
}

TEST_CASE("what is written of a solid reads back to the same text and values") {
  const std::string text = rgimp::write_case(read_text(kEverySolid));
  const rgimp::Case second = read_text(text);
  CHECK(rgimp::write_case(second) == text);
  CHECK(text.find("\nside = \"back\"                       # top | bottom | left | right | front | "
                  "back") != std::string::npos);
  CHECK(second.dimension == 3);
  CHECK(second.grid.max.value() == rgimp::Vector(0.08, 0.03, 0.025));
  CHECK(second.bodies.at(0).shape == rgimp::BodyShape::cylinder);
  CHECK(second.bodies.at(0).size == rgimp::Vector(0.02, 0.04, 0.0));
  CHECK(second.bodies.at(0).axis == rgimp::Vector(0.0, -2.5, 0.0));
  CHECK(second.bodies.at(0).velocity == rgimp::Vector(1.0, -7.0, 1e-300));
  CHECK(second.bodies.at(1).size == rgimp::Vector(0.02, 0.0, 0.0));
  CHECK(second.bodies.at(2).size == rgimp::Vector(0.01, 0.02, 0.03));
  CHECK(second.flaws.at(0).direction.value() == rgimp::Vector(1.0, 2.0, 0.30000000000000004));
  CHECK(second.flaws.at(0).normal.value() == rgimp::Vector(-2.0, 1.0, 0.0));
  CHECK_FALSE(second.flaws.at(0).depth.has_value());
  CHECK(second.flaws.at(0).ends == rgimp::SlotEnds::round);
  CHECK_FALSE(second.flaws.at(1).direction.has_value());
  CHECK(second.flaws.at(1).depth == 4e-3);
  CHECK(second.flaws.at(1).angle == 33.333333333333336);
  CHECK(second.flaws.at(2).normal.value() == rgimp::Vector(0.1, 0.2, -0.3));
  CHECK(second.flaws.at(2).width == 3e-3);
  CHECK(second.flaws.at(3).length == 4e-3);
  CHECK(second.flaws.at(4).size == rgimp::Vector(3e-3, 4e-3, 5e-3));
  CHECK(second.platens.at(0).side == rgimp::Side::back);
  CHECK(second.platens.at(0).half_width == 2e-3);
  CHECK(second.body_acceleration == rgimp::Vector(0.0, -9.81, 0.5));
}

TEST_CASE("the examples survive writing, and defaults are spelt out") {
  for (const char* name : {"single_flaw.toml", "single_flaw_fracture_energy.toml",
                           "double_flaw.toml", "brazilian_disk.toml"}) {
    INFO(name);
    const rgimp::Case example = rgimp::read_case(kExamples / name);
    const std::string text = rgimp::write_case(example);
    CHECK(rgimp::write_case(read_text(text)) == text);
    CHECK(text.find("integrator = \"musl\"") != std::string::npos);
    CHECK(text.find("quadratic = 1.5") != std::string::npos);
    CHECK(text.find("on_exit = \"stop\"") != std::string::npos);
    CHECK(text.find("lateral = \"slip\"") != std::string::npos);
    CHECK(rgimp::check_case(example).empty());
  }
}
