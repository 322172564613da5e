#include <catch2/catch.hpp>

#include "case_check.hpp"
#include "case_text.hpp"
#include "rgimp/rgimp.hpp"
#include "wrong_case.hpp"

namespace {

using rgimp::testing::check_rows;
using rgimp::testing::kRightCase;
using rgimp::testing::message_of;
using rgimp::testing::read_text;
using rgimp::testing::ScratchDirectory;
using rgimp::testing::with;

const std::string kDisk = "[[body]]\nshape = \"disk\"\ncenter = ";

}  // namespace

TEST_CASE("the case that the wrong ones are made from is right") {
  CHECK(message_of(kRightCase) == "accepted");
}

TEST_CASE("keys and types are refused with line, key and what was expected") {
  check_rows({
      {"size = [", "siez = [", "8: body[0].siez: unknown key; did you mean \"size\"?"},
      {"cell_size", "cel_size", "4: grid.cel_size: unknown key; did you mean \"cell_size\"?"},
      {"steps = 1000", "steps = 1000\nquux = 1",
       "33: time.quux: unknown key; the keys here are steps, duration, step_factor, integrator"},
      {"[time]", "[tiem]", "31: tiem: unknown key; did you mean \"time\"?"},
      {"[[flaw]]", "[[flaws]]", "10: flaws: unknown key; did you mean \"flaw\"?"},
      {"tensile_strength = 2e6", "tensile_strength = 2e6\nfracture_toughness = 1.0",
       "25: material.rock.failure.fracture_toughness: unknown key; the keys here are criterion, "
       "treatment, cohesion, friction_angle, tensile_strength, shear_strength, tensile_strain, "
       "shear_strain, fracture_energy, shear_fracture_energy, pressure_min, pressure_max"},
      {"cell_size = 0.5e-3", "", "3: grid.cell_size: missing; expected a real number"},
      {"[time]\nsteps = 1000\n", "", "1: time: missing; expected a table"},
      {"shape = \"box\"", "", "5: body[0].shape: missing; expected one of box, disk"},
      {"density = 2600.0", "", "16: material.rock.density: missing; expected a real number"},
      {"speed = 0.005", "", "25: platen[0].speed: missing; expected a real number"},
      {"length = 6e-3", "", "10: flaw[0].length: missing; expected a real number"},
      {"0.5e-3", "\"0.5e-3\"", "4: grid.cell_size: found a string; expected a real number"},
      {"0.5e-3", "true", "4: grid.cell_size: found a boolean; expected a real number"},
      {"0.5e-3", "2024-01-01", "4: grid.cell_size: found a date or time; expected a real number"},
      {"0.5e-3", "inf", "4: grid.cell_size: is inf; expected a finite number"},
      {"2600.0", "nan", "17: material.rock.density: is nan; expected a finite number"},
      {"steps = 1000", "steps = 1000.0",
       "32: time.steps: found a real number; expected an integer"},
      {"title = \"small\"", "title = 3", "1: title: found an integer; expected a string"},
      {"[20e-3, 40e-3]", "20e-3",
       "8: body[0].size: found a real number; expected an array of 2 real numbers"},
      {"[20e-3, 40e-3]", "[20e-3, 40e-3, 1.0]", "8: body[0].size: has 3 components; expected 2"},
      {"[20e-3, 40e-3]", "[20e-3,\n\"x\"]",
       "9: body[0].size[1]: found a string; expected a real number"},
      {"[[platen]]\nside = \"top\"\nspeed = 0.005\n[[platen]]\nside = \"bottom\"", "[platen]",
       "25: platen: found a table; expected an array of tables, [[platen]]"},
      {"title", "damping = 3\n#", "1: damping: found an integer; expected a table"},
      {"dimension = 2", "dimension = 99999999999",
       "2: dimension: is 99999999999; expected an integer of 32 bits"},
  });
}

TEST_CASE("words are refused with the ones there are") {
  check_rows({
      {"\"box\"", "\"bix\"",
       "6: body[0].shape: \"bix\" is not one of box, disk; did you mean \"box\"?"},
      {"\"slot\"", "\"penny\"", "11: flaw[0].shape: \"penny\" is not one of slot, circle, box"},
      {"\"mohr-coulomb\"", "\"mohr-columb\"",
       "21: material.rock.failure.criterion: \"mohr-columb\" is not one of mohr-coulomb, "
       "hydrostatic-tension, principal-stress, shear-stress, principal-strain, shear-strain; did "
       "you mean \"mohr-coulomb\"?"},
      {"side = \"top\"", "side = \"front\"",
       "26: platen[0].side: \"front\" is not one of top, bottom, left, right"},
      {"side = \"top\"", "side = \"top\"\nlateral = \"stik\"",
       "27: platen[0].lateral: \"stik\" is not one of slip, stick; did you mean \"stick\"?"},
      {"steps = 1000", "steps = 1000\nintegrator = \"musk\"",
       "33: time.integrator: \"musk\" is not one of musl, usl, usf; did you mean \"musl\"?"},
      {"angle = 45.0", "angle = 45.0\nends = \"flat\"",
       "16: flaw[0].ends: \"flat\" is not one of square, round"},
      {"tensile_strength = 2e6", "tensile_strength = 2e6\ntreatment = \"no-tensions\"",
       "25: material.rock.failure.treatment: \"no-tensions\" is not one of no-tension, "
       "stress-free, pressure-window; did you mean \"no-tension\"?"},
      {"material = \"rock\"", "material = \"rok\"",
       "9: body[0].material: no material \"rok\"; did you mean \"rock\"?"},
      {"material = \"rock\"", "material = \"granite\"",
       "9: body[0].material: no material \"granite\"; the materials are rock"},
  });
}

TEST_CASE("a shape reads its own keys and no others") {
  check_rows({
      {"\"slot\"", "\"circle\"",
       "14: flaw[0].width: not read by shape \"circle\", which reads length"},
      {"\"slot\"", "\"box\"", "13: flaw[0].length: not read by shape \"box\", which reads size"},
  });
}

TEST_CASE("values out of range are refused") {
  check_rows({
      {"dimension = 2", "dimension = 3", "7: body[0].center: has 2 components; expected 3"},
      {"dimension = 2", "dimension = 4", "2: dimension: is 4; expected 2 or 3"},
      {"0.5e-3", "-0.5e-3", "4: grid.cell_size: is -0.0005; expected a number above 0"},
      {"[20e-3, 40e-3]", "[20e-3, 0]", "8: body[0].size[1]: is 0; expected a number above 0"},
      {"width = 1.5e-3", "width = 7e-3",
       "13: flaw[0].length: is 0.006; expected at least the "
       "width, 0.007"},
      {"material = \"rock\"", "material = \"rock\"\nparticles_per_cell = 5",
       "10: body[0].particles_per_cell: is 5; expected 2 to 4"},
      {"side = \"bottom\"", "side = \"top\"",
       "29: platen[1].side: \"top\" is taken by platen[0]; expected a side of its own for each "
       "platen"},
      {"speed = 0.005", "speed = 0.005\nramp = -1",
       "28: platen[0].ramp: is -1; expected 0 or more"},
      {"speed = 0.005", "speed = 0.005\nhalf_width = 0",
       "28: platen[0].half_width: is 0; expected a number above 0"},
  });
}

TEST_CASE("time, forces and output out of range are refused") {
  const std::string last = "steps = 1000";
  check_rows({
      {last, "", "31: time: has neither steps nor duration; expected one of them"},
      {last, "steps = 1\nduration = 1.0",
       "33: time.duration: given besides steps; expected one of them"},
      {last, "steps = 0", "32: time.steps: is 0; expected 1 or more"},
      {last, "steps = 2147483648", "32: time.steps: is 2147483648; expected at most 2147483647"},
      {last, "duration = -1.0", "32: time.duration: is -1; expected a number above 0"},
      {last, "duration = 1000.0",
       "32: time.duration: takes 5.23478e+10 steps of 1.9103e-08 s; "
       "expected at most 2147483647"},
      {last, last + "\nstep_factor = 0", "33: time.step_factor: is 0; expected a number above 0"},
      {last, last + "\nstep_factor = 1", "33: time.step_factor: is 1; expected less than 1"},
      {last, last + "\nstep_factor = 0.999", "accepted"},
      {last, last + "\n[damping]\nlocal = 1.0",
       "34: damping.local: is 1; expected 0 or more and less than 1"},
      {last, last + "\n[viscosity]\nlinear = -1",
       "34: viscosity.linear: is -1; expected 0 or more"},
      {last, last + "\n[output]\nhistory_every = 0",
       "34: output.history_every: is 0; expected 1 or more"},
      {last, last + "\n[output]\nsnapshot_every = 0",
       "34: output.snapshot_every: is 0; expected 1 or more"},
      {last, last + "\n[output]\nsnapshot_steps = [0, -1]",
       "34: output.snapshot_steps[1]: is -1; expected 0 or more"},
      {last, last + "\n[output]\nsnapshot_steps = [1001]", "accepted"},
      {last, last + "\n[output]\ncheckpoint_every = -5",
       "34: output.checkpoint_every: is -5; expected 1 or more"},
      {last, last + "\n[tuning]\nthreads = -1",
       "34: tuning.threads: is -1; expected 0, for all, or up to 1024"},
      {last, last + "\n[tuning]\nthreads = 1025",
       "34: tuning.threads: is 1025; expected 0, for all, or up to 1024"},
      {last, last + "\n[tuning]\nthreads = 1024", "accepted"},
      {last, last + "\n[tuning]\nbands_per_task = 0",
       "34: tuning.bands_per_task: is 0; expected 1 to 64"},
      {last, last + "\n[tuning]\nbands_per_task = 64", "accepted"},
      {last, last + "\n[numerics]\nband_height = 1",
       "34: numerics.band_height: is 1; expected 2 to 64"},
      {last, last + "\n[numerics]\nband_height = 65",
       "34: numerics.band_height: is 65; expected 2 to 64"},
  });
}

TEST_CASE("bodies, flaws and platens that do not fit are refused") {
  const std::string body2 = "\nsize = 10e-3\nmaterial = \"rock\"\n[[flaw]]";
  check_rows({
      {"[[flaw]]", kDisk + "[13e-3, 0.0]" + body2,
       "10: body[1]: reaches 0.002 m into body[0]; expected bodies that touch at most"},
      {"[[flaw]]", kDisk + "[20e-3, 0.0]\nparticles_per_cell = 3" + body2,
       "13: body[1].particles_per_cell: is 3; expected 2, as in body[0]: all bodies share one"},
      {"[[flaw]]",
       "[[body]]\nshape = \"box\"\ncenter = [0, 30e-3]\nsize = [10e-3, 24e-3]"
       "\nmaterial = \"rock\"\n[[flaw]]",
       "10: body[1]: reaches 0.002 m into body[0]; expected bodies that touch at most"},
      {"width = 1.5e-3", "width = 0.9e-3",
       "14: flaw[0].width: is 0.0009 m, 1.8 cells across; expected at least two cells, 0.001 m: "
       "nearer faces share grid nodes and stay glued"},
      {"center = [0.0, 0.0]\nlength", "center = [1.0, 0.0]\nlength",
       "12: flaw[0].center: lies outside every body, so that no particle is left out; the bodies "
       "span (-0.01, -0.02) to (0.01, 0.02) m"},
      {"length = 6e-3\nwidth = 1.5e-3", "length = 1.0\nwidth = 1.0",
       "5: body[0]: no particle is left of it outside the flaws, at a spacing of 0.00025 m; "
       "expected a larger body, smaller cells or smaller flaws"},
      {"40e-3", "40.2e-3",
       "26: platen[0].side: the bodies' top end at y = 0.0201 m is not on a grid line; expected a "
       "height of 0.04 or 0.0405 m"},
      {"cell_size = 0.5e-3", "cell_size = 0.5e-3\nmin = [-11e-3, -25e-3]",
       "5: grid.min: leaves 2 cells left of the bodies; expected at least 3"},
      {"cell_size = 0.5e-3", "cell_size = 0.5e-3\nmax = [20e-3, 21e-3]",
       "5: grid.max: leaves 2 cells above the bodies; expected at least 3"},
      {"cell_size = 0.5e-3", "cell_size = 0.5e-3\nmin = [-15e-3, -25.2e-3]",
       "27: platen[0].side: the bodies' top end at y = 0.02 m is not on a grid line; expected a "
       "height of 0.0398 or 0.0403 m"},
      {"0.5e-3\n[[body]]", "1e-6\n[[body]]\nparticles_per_cell = 4",
       "4: grid.cell_size: makes 1.28e+10 particles; expected at most 4294967295"},
      {"0.5e-3", "1e-9", "4: grid.cell_size: makes 8e+14 nodes; expected at most 2147483648"},
      {"speed = 0.005",
       "speed = 0.005\nhalf_width = 0.1e-3\n[[platen]]\nside = \"left\"\nspeed = 0", "accepted"},
      {"[20e-3, 40e-3]\n", "[20.5e-3, 40e-3]\n", "accepted"},
  });
}

TEST_CASE("a case beyond the machine's memory is refused with its numbers") {
  rgimp::Case settings = read_text(kRightCase);
  settings.grid.cell_size = 1e-5;
  const double gibibyte = 1024.0 * 1024.0 * 1024.0;
  CHECK_NOTHROW(rgimp::check_amount(settings, 10.0 * gibibyte));
  CHECK_THROWS_WITH(rgimp::check_amount(settings, 4.0 * gibibyte),
                    Catch::EndsWith("4: grid.cell_size: makes 8.08e+06 nodes and 3.2e+07 "
                                    "particles, which take about 9.4 GiB of memory; expected no "
                                    "more than the 4.0 GiB that are free here"));
  CHECK_NOTHROW(rgimp::check_amount(settings, std::nullopt));
}

TEST_CASE("a contact between two nodes is refused") {
  std::string text = with("[20e-3, 40e-3]", "[20.5e-3, 40e-3]");
  text.replace(text.find("speed = 0.005"), 13, "speed = 0.005\nhalf_width = 0.1e-3");
  CHECK(message_of(text) ==
        "28: platen[0].half_width: is 0.0001, within which no grid node lies; expected at least "
        "0.00025");
}

TEST_CASE("syntax errors name file and line") {
  CHECK(message_of("title = \"x\"\n[grid\n") ==
        "2: Error while parsing table header: expected ']', saw '\\n'");
  CHECK(message_of("title = \"x\"\ntitle = \"y\"\n") ==
        "2: Error while parsing key-value pair: cannot redefine existing string 'title'");
  CHECK(message_of("") == "1: grid: missing; expected a table");
}

TEST_CASE("files that cannot be read are file errors with the system's reason") {
  const ScratchDirectory scratch;
  const std::string directory = scratch.path().string();
  CHECK_THROWS_MATCHES(rgimp::read_case(scratch.path()), rgimp::FileError,
                       Catch::Matchers::Message("cannot read " + directory + ": Is a directory"));
  CHECK_THROWS_MATCHES(rgimp::read_case(scratch.path() / "none.toml"), rgimp::FileError,
                       Catch::Matchers::Message("cannot read " + directory +
                                                "/none.toml: No such file or directory"));
}
