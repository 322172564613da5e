#include <catch2/catch.hpp>

#include "floating_point_traps.hpp"
#include "wrong_case.hpp"

// What is refused need not fit a number: sizes and counts are found infinite on the way.

TEST_CASE("numbers at the edge: grid and bodies") {
  const rgimp::tests::WithoutTraps overflow;
  rgimp::testing::check_rows({
      {"0.5e-3", "0", "4: grid.cell_size: is 0; expected a number above 0"},
      {"0.5e-3", "-0.0", "4: grid.cell_size: is -0; expected a number above 0"},
      {"0.5e-3", "1e300",
       "31: time.step_factor: makes steps of 3.82e+295 s with this cell_size, density and "
       "youngs_modulus; expected 1e-30 to 1e+30 s"},
      {"0.5e-3", "1e-300",
       "31: time.step_factor: makes steps of 3.82e-305 s with this cell_size, density and "
       "youngs_modulus; expected 1e-30 to 1e+30 s"},
      {"0.5e-3", "1e-320",
       "31: time.step_factor: makes steps of 0 s with this cell_size, density and youngs_modulus; "
       "expected 1e-30 to 1e+30 s"},
      {"0.5e-3", "-inf", "4: grid.cell_size: is -inf; expected a finite number"},
      {"0.5e-3", "9223372036854775807",
       "14: flaw[0].width: is 0.0015 m, 1.626e-22 cells across; expected at least two cells, "
       "1.84467e+19 m: nearer faces share grid nodes and stay glued"},
      {"0.5e-3", "9223372036854775808",
       "4: Error while parsing decimal integer: '9223372036854775808' is not representable in 64 "
       "bits"},
      {"0.5e-3", "1e400",
       "4: Error while parsing floating-point: '1e400' could not be interpreted as a value"},
      {"[20e-3, 40e-3]", "[1e300, 40e-3]",
       "4: grid.cell_size: makes 1.82e+305 nodes; expected at most 2147483648"},
      {"[20e-3, 40e-3]", "[-0.0, 40e-3]", "8: body[0].size[0]: is -0; expected a number above 0"},
      {"[20e-3, 40e-3]", "[20e-3, 1e-320]",
       "12: flaw[0].center: lies outside every body, so that no particle is left out; the bodies "
       "span (-0.01, -4.99994e-321) to (0.01, 4.99994e-321) m"},
      {"[20e-3, 40e-3]", "[nan, 40e-3]", "8: body[0].size[0]: is nan; expected a finite number"},
      {"center = [0.0, 0.0]\nsize", "center = [1e300, 0.0]\nsize",
       "4: grid.cell_size: is 0.0005, and the bodies reach 1e+300 m from the origin, where "
       "positions are rounded too coarsely for such cells; expected 1e+08 cells at most"},
      {"center = [0.0, 0.0]\nsize", "center = [0.0, inf]\nsize",
       "7: body[0].center[1]: is inf; expected a finite number"},
      {"center = [0.0, 0.0]\nsize", "center = [1e16, 0.0]\nsize",
       "4: grid.cell_size: is 0.0005, and the bodies reach 1e+16 m from the origin, where "
       "positions are rounded too coarsely for such cells; expected 1e+08 cells at most"},
      {"center = [0.0, 0.0]\nsize", "center = [9223372036854775807, 0]\nsize",
       "4: grid.cell_size: is 0.0005, and the bodies reach 9.22337e+18 m from the origin, where "
       "positions are rounded too coarsely for such cells; expected 1e+08 cells at most"},
      {"center = [0.0, 0.0]\nlength", "center = [1e300, -1e300]\nlength",
       "12: flaw[0].center: lies outside every body, so that no particle is left out; the bodies "
       "span (-0.01, -0.02) to (0.01, 0.02) m"},
  });
}

TEST_CASE("numbers at the edge: flaws") {
  const rgimp::tests::WithoutTraps overflow;
  rgimp::testing::check_rows({
      {"length = 6e-3", "length = 0", "13: flaw[0].length: is 0; expected a number above 0"},
      {"length = 6e-3", "length = 1e300", "accepted"},
      {"width = 1.5e-3", "width = -1.5e-3",
       "14: flaw[0].width: is -0.0015; expected a number above 0"},
      {"width = 1.5e-3", "width = 1e-320",
       "14: flaw[0].width: is 1e-320 m, 2e-317 cells across; expected at least two cells, 0.001 m: "
       "nearer faces share grid nodes and stay glued"},
      {"angle = 45.0", "angle = inf", "15: flaw[0].angle: is inf; expected a finite number"},
      {"angle = 45.0", "angle = 1e300", "accepted"},
  });
}

TEST_CASE("numbers at the edge: materials") {
  const rgimp::tests::WithoutTraps overflow;
  rgimp::testing::check_rows({
      {"2600.0", "-0.0", "17: material.rock.density: is -0; expected a number above 0"},
      {"2600.0", "1e300",
       "31: time.step_factor: makes steps of 3.75e+140 s with this cell_size, density and "
       "youngs_modulus; expected 1e-30 to 1e+30 s"},
      {"2600.0", "1e-320",
       "31: time.step_factor: makes steps of 0 s with this cell_size, density and youngs_modulus; "
       "expected 1e-30 to 1e+30 s"},
      {"2600.0", "inf", "17: material.rock.density: is inf; expected a finite number"},
      {"17e9", "0", "18: material.rock.youngs_modulus: is 0; expected a number above 0"},
      {"17e9", "1e300",
       "31: time.step_factor: makes steps of 2.49e-153 s with this cell_size, density and "
       "youngs_modulus; expected 1e-30 to 1e+30 s"},
      {"17e9", "1e-320",
       "31: time.step_factor: makes steps of 2.25e+157 s with this cell_size, density and "
       "youngs_modulus; expected 1e-30 to 1e+30 s"},
      {"17e9", "nan", "18: material.rock.youngs_modulus: is nan; expected a finite number"},
      {"0.14", "0.49999999999999994", "accepted"},
      {"0.14", "1", "19: material.rock.poisson_ratio: is 1; expected 0 or more and less than 0.5"},
      {"0.14", "nan", "19: material.rock.poisson_ratio: is nan; expected a finite number"},
      {"5.95e6", "1e300", "accepted"},
      {"5.95e6", "1e-320",
       "24: material.rock.failure.tensile_strength: is 2000000; expected at most cohesion / "
       "tan(friction_angle) = 1.19169e-320"},
      {"40.0", "-0.0", "accepted"},
      {"40.0", "89.99999999999999",
       "24: material.rock.failure.tensile_strength: is 2000000; expected at most cohesion / "
       "tan(friction_angle) = 1.6855e-09"},
      {"40.0", "-1e-320",
       "23: material.rock.failure.friction_angle: is -1e-320; expected 0 or more and less than 90"},
      {"2e6", "1e300",
       "24: material.rock.failure.tensile_strength: is 1e+300; expected at most cohesion / "
       "tan(friction_angle) = 7.09093e+06"},
      {"2e6", "1e-320", "accepted"},
      {"2e6", "-0.0",
       "24: material.rock.failure.tensile_strength: is -0; expected a number above 0"},
      {"tensile_strength = 2e6", "tensile_strength = 2e6\nfracture_energy = 1e300", "accepted"},
      {"tensile_strength = 2e6", "tensile_strength = 2e6\nfracture_energy = 1e-320",
       "25: material.rock.failure.fracture_energy: needs cells smaller than sqrt(2) (lambda + 2 "
       "mu) fracture_energy / tensile_strength^2 = 6.42285e-323 m; grid.cell_size is 0.0005"},
  });
}

TEST_CASE("numbers at the edge: platens and time") {
  const rgimp::tests::WithoutTraps overflow;
  rgimp::testing::check_rows({
      {"speed = 0.005", "speed = 1e300", "accepted"},
      {"speed = 0.005", "speed = nan", "27: platen[0].speed: is nan; expected a finite number"},
      {"speed = 0.005", "speed = 0.005\nramp = 1e300", "accepted"},
      {"speed = 0.005", "speed = 0.005\nramp = -0.0", "accepted"},
      {"speed = 0.005", "speed = 0.005\nhalf_width = 1e-320", "accepted"},
      {"speed = 0.005", "speed = 0.005\nhalf_width = 1e300", "accepted"},
      {"steps = 1000", "steps = 9223372036854775807",
       "32: time.steps: is 9223372036854775807; expected at most 2147483647"},
      {"steps = 1000", "steps = 9223372036854775808",
       "32: Error while parsing decimal integer: '9223372036854775808' is not representable in 64 "
       "bits"},
      {"steps = 1000", "steps = -9223372036854775808",
       "32: time.steps: is -9223372036854775808; expected 1 or more"},
      {"steps = 1000", "steps = -1", "32: time.steps: is -1; expected 1 or more"},
      {"steps = 1000", "steps = 1e3", "32: time.steps: found a real number; expected an integer"},
      {"steps = 1000", "duration = 0", "32: time.duration: is 0; expected a number above 0"},
      {"steps = 1000", "duration = 1e300",
       "32: time.duration: takes 5.23478e+307 steps of 1.9103e-08 s; expected at most 2147483647"},
      {"steps = 1000", "duration = 1e-320", "accepted"},
      {"steps = 1000", "duration = nan", "32: time.duration: is nan; expected a finite number"},
      {"steps = 1000", "steps = 1000\nstep_factor = 1e-320",
       "33: time.step_factor: makes steps of 0 s with this cell_size, density and youngs_modulus; "
       "expected 1e-30 to 1e+30 s"},
      {"steps = 1000", "steps = 1000\nstep_factor = 1e-300",
       "33: time.step_factor: makes steps of 1.91e-307 s with this cell_size, density and "
       "youngs_modulus; expected 1e-30 to 1e+30 s"},
      {"steps = 1000", "steps = 1000\nstep_factor = -0.0",
       "33: time.step_factor: is -0; expected a number above 0"},
  });
}

TEST_CASE("numbers at the edge: forces, output and all else") {
  const rgimp::tests::WithoutTraps overflow;
  rgimp::testing::check_rows({
      {"steps = 1000", "steps = 1000\n[damping]\nlocal = -1e-320",
       "34: damping.local: is -1e-320; expected 0 or more and less than 1"},
      {"steps = 1000", "steps = 1000\n[damping]\nlocal = 0.9999999999999999", "accepted"},
      {"steps = 1000", "steps = 1000\n[viscosity]\nquadratic = 1e300", "accepted"},
      {"steps = 1000", "steps = 1000\n[viscosity]\nquadratic = -1e-320",
       "34: viscosity.quadratic: is -1e-320; expected 0 or more"},
      {"steps = 1000", "steps = 1000\n[body_force]\nacceleration = [1e300, 0]", "accepted"},
      {"steps = 1000", "steps = 1000\n[body_force]\nacceleration = [0, nan]",
       "34: body_force.acceleration[1]: is nan; expected a finite number"},
      {"steps = 1000", "steps = 1000\n[output]\nhistory_every = 9223372036854775807", "accepted"},
      {"steps = 1000", "steps = 1000\n[output]\nhistory_every = 9223372036854775808",
       "34: Error while parsing decimal integer: '9223372036854775808' is not representable in 64 "
       "bits"},
      {"steps = 1000", "steps = 1000\n[output]\nsnapshot_steps = [9223372036854775807]",
       "accepted"},
      {"steps = 1000", "steps = 1000\n[output]\nsnapshot_steps = [-9223372036854775808]",
       "34: output.snapshot_steps[0]: is -9223372036854775808; expected 0 or more"},
      {"steps = 1000", "steps = 1000\n[output]\nsnapshot_steps = []", "accepted"},
      {"steps = 1000", "steps = 1000\n[output]\nsnapshot_steps = [1.0]",
       "34: output.snapshot_steps[0]: found a real number; expected an integer"},
      {"steps = 1000", "steps = 1000\n[tuning]\nthreads = 2147483648",
       "34: tuning.threads: is 2147483648; expected an integer of 32 bits"},
      {"steps = 1000", "steps = 1000\n[numerics]\nband_height = -2147483649",
       "34: numerics.band_height: is -2147483649; expected an integer of 32 bits"},
      {"cell_size = 0.5e-3", "cell_size = 0.5e-3\nmin = [1e300, 0]",
       "4: grid.cell_size: makes 9.2e+304 nodes; expected at most 2147483648"},
      {"cell_size = 0.5e-3", "cell_size = 0.5e-3\nmax = [-1e300, 0]",
       "4: grid.cell_size: makes 9.2e+304 nodes; expected at most 2147483648"},
      {"cell_size = 0.5e-3", "cell_size = 0.5e-3\nmin = [0.1, 0.1]\nmax = [-0.1, -0.1]",
       "5: grid.min: leaves -220 cells left of the bodies; expected at least 3"},
      {"material = \"rock\"", "material = \"rock\"\nvelocity = [1e300, 0]", "accepted"},
      {"material = \"rock\"", "material = \"rock\"\nvelocity = [nan, 0]",
       "10: body[0].velocity[0]: is nan; expected a finite number"},
      {"material = \"rock\"", "material = \"rock\"\nparticles_per_cell = 9223372036854775807",
       "10: body[0].particles_per_cell: is 9223372036854775807; expected an integer of 32 bits"},
      {"material = \"rock\"", "material = \"rock\"\nparticles_per_cell = -2147483648",
       "10: body[0].particles_per_cell: is -2147483648; expected 2 to 4"},
      {"dimension = 2", "dimension = -9223372036854775808",
       "2: dimension: is -9223372036854775808; expected an integer of 32 bits"},
  });
}

TEST_CASE("numbers at the edge: solids") {
  const rgimp::tests::WithoutTraps overflow;
  const std::string box = "\"box\"\ncenter = [0.0, 0.0, 0.0]\nsize = [20e-3, 40e-3, 20e-3]";
  const std::string axes = "direction = [1.0, 1.0, 0.0]\nnormal = [-1.0, 1.0, 0.0]";
  rgimp::testing::check_rows(
      {
          {"40e-3, 20e-3]", "40e-3, 1e300]",
           "4: grid.cell_size: makes 1.73e+306 nodes; expected at most 2147483648"},
          {"40e-3, 20e-3]", "40e-3, -0.0]", "8: body[0].size[2]: is -0; expected a number above 0"},
          {box, "\"sphere\"\ncenter = [0, 0, 0]\nsize = 1e300",
           "4: grid.cell_size: makes inf nodes; expected at most 2147483648"},
          {box, "\"cylinder\"\ncenter = [0, 0, 0]\nsize = [20e-3, 40e-3]\naxis = [0, 1e99, 0]",
           "accepted"},
          {box, "\"cylinder\"\ncenter = [0, 0, 0]\nsize = [20e-3, 40e-3]\naxis = [0, 1e300, 0]",
           "9: body[0].axis: is of length 1e+300; expected a direction"},
          {box, "\"cylinder\"\ncenter = [0, 0, 0]\nsize = [20e-3, 40e-3]\naxis = [0, nan, 0]",
           "9: body[0].axis[1]: is nan; expected a finite number"},
          {box, "\"cylinder\"\ncenter = [0, 0, 0]\nsize = [20e-3, 1e-320]",
           "12: flaw[0].center: lies outside every body, so that no particle is left out; the "
           "bodies "
           "span (-0.01, -4.99994e-321, -0.01) to (0.01, 4.99994e-321, 0.01) m"},
          {axes, "direction = [1e-99, 0, 0]\nnormal = [0, 1e99, 0]", "accepted"},
          {axes, "direction = [1e-320, 0, 0]\nnormal = [0, 1, 0]",
           "16: flaw[0].direction: is of length 1e-320; expected a direction"},
          {"depth = 10e-3", "depth = 1e300", "accepted"},
          {"depth = 10e-3", "depth = inf", "15: flaw[0].depth: is inf; expected a finite number"},
          {"depth = 10e-3", "depth = 1e-320",
           "15: flaw[0].depth: is 1e-320 m, 1e-317 cells across; expected at least two cells, "
           "0.002 "
           "m: nearer faces share grid nodes and stay glued"},
          {"center = [0.0, 10e-3, 0.0]", "center = [0.0, 10e-3, 1e300]",
           "20: flaw[1].center: lies outside every body, so that no particle is left out; the "
           "bodies "
           "span (-0.01, -0.02, -0.01) to (0.01, 0.02, 0.01) m"},
          {"steps = 100", "steps = 100\n[body_force]\nacceleration = [0, 0, inf]",
           "38: body_force.acceleration[2]: is inf; expected a finite number"},
          {"cell_size = 1e-3", "cell_size = 1e-3\nmin = [0, 0, -1e300]",
           "4: grid.cell_size: makes 4.16e+305 nodes; expected at most 2147483648"},
          {"half_width = 5e-3", "half_width = 1e300", "accepted"},
      },
      rgimp::testing::kRightSolid);
}
