#include <catch2/catch.hpp>

#include "wrong_case.hpp"

namespace {

using rgimp::testing::check_rows;

const std::string kFailure = R"(criterion = "mohr-coulomb"
cohesion = 5.95e6
friction_angle = 40.0
tensile_strength = 2e6
)";

}  // namespace

TEST_CASE("a criterion or treatment reads its own keys and no others") {
  check_rows({
      {"\"mohr-coulomb\"", "\"principal-stress\"",
       "22: material.rock.failure.cohesion: not read by criterion \"principal-stress\", which "
       "reads tensile_strength"},
      {"cohesion = 5.95e6\n", "",
       "20: material.rock.failure.cohesion: missing; criterion \"mohr-coulomb\" reads cohesion, "
       "friction_angle, tensile_strength"},
      {kFailure, "criterion = \"shear-strain\"\n",
       "20: material.rock.failure.shear_strain: missing; criterion \"shear-strain\" reads "
       "shear_strain"},
      {kFailure, "criterion = \"principal-strain\"\ntensile_strain = 0.0\n",
       "22: material.rock.failure.tensile_strain: is 0; expected a number above 0"},
      {kFailure, "criterion = \"hydrostatic-tension\"\nshear_strength = 1e6\n",
       "22: material.rock.failure.shear_strength: not read by criterion \"hydrostatic-tension\", "
       "which reads tensile_strength"},
      {kFailure, "criterion = \"hydrostatic-tension\"\n",
       "20: material.rock.failure.tensile_strength: missing; criterion \"hydrostatic-tension\" "
       "reads tensile_strength"},
      {kFailure, "criterion = \"principal-stress\"\n",
       "20: material.rock.failure.tensile_strength: missing; criterion \"principal-stress\" reads "
       "tensile_strength"},
      {kFailure, "criterion = \"shear-stress\"\n",
       "20: material.rock.failure.shear_strength: missing; criterion \"shear-stress\" reads "
       "shear_strength"},
      {kFailure, "criterion = \"principal-strain\"\n",
       "20: material.rock.failure.tensile_strain: missing; criterion \"principal-strain\" reads "
       "tensile_strain"},
      {kFailure, "criterion = \"hydrostatic-tension\"\ntensile_strength = 0.0\n",
       "22: material.rock.failure.tensile_strength: is 0; expected a number above 0"},
      {kFailure, "criterion = \"principal-stress\"\ntensile_strength = -2e6\n",
       "22: material.rock.failure.tensile_strength: is -2000000; expected a number above 0"},
      {kFailure, "criterion = \"shear-stress\"\nshear_strength = -1.0\n",
       "22: material.rock.failure.shear_strength: is -1; expected a number above 0"},
      {kFailure, "criterion = \"shear-strain\"\nshear_strain = \"1e-4\"\n",
       "22: material.rock.failure.shear_strain: found a string; expected a real number"},
      {kFailure, "criterion = \"shear-strain\"\nshear_strain = 0.0\n",
       "22: material.rock.failure.shear_strain: is 0; expected a number above 0"},
      {kFailure, kFailure + "pressure_max = 1.0\n",
       "25: material.rock.failure.pressure_max: not read by treatment \"no-tension\""},
      {kFailure, kFailure + "treatment = \"stress-free\"\npressure_min = 0.0\n",
       "26: material.rock.failure.pressure_min: not read by treatment \"stress-free\""},
      {kFailure, kFailure + "treatment = \"pressure-window\"\npressure_max = 1.0\n",
       "20: material.rock.failure.pressure_min: missing; treatment \"pressure-window\" reads "
       "pressure_min, pressure_max"},
      {kFailure, kFailure + "treatment = \"pressure-window\"\npressure_min = -1.0\n",
       "20: material.rock.failure.pressure_max: missing; treatment \"pressure-window\" reads "
       "pressure_min, pressure_max"},
  });
}

TEST_CASE("fracture energies that do not apply, or not to cells of this size, are refused") {
  check_rows({
      {kFailure, kFailure + "fracture_energy = 1.0\nshear_fracture_energy = 10.0\n", "accepted"},
      {kFailure, kFailure + "fracture_energy = 0\nshear_fracture_energy = 0.0\n", "accepted"},
      {kFailure, kFailure + "fracture_energy = -1.0\n",
       "25: material.rock.failure.fracture_energy: is -1; expected 0 or more"},
      {kFailure, kFailure + "shear_fracture_energy = nan\n",
       "25: material.rock.failure.shear_fracture_energy: is nan; expected a finite number"},
      {kFailure,
       "criterion = \"principal-stress\"\ntensile_strength = 2e6\nshear_fracture_energy = 1.0\n",
       "23: material.rock.failure.shear_fracture_energy: not read by criterion "
       "\"principal-stress\", which reads fracture_energy"},
      {kFailure,
       "criterion = \"hydrostatic-tension\"\ntensile_strength = 2e6\nfracture_energy = 1.0\n",
       "23: material.rock.failure.fracture_energy: not read by criterion "
       "\"hydrostatic-tension\""},
      {kFailure, kFailure + "fracture_energy = 0.07\n",
       "25: material.rock.failure.fracture_energy: needs cells smaller than sqrt(2) (lambda + 2 "
       "mu) "
       "fracture_energy / tensile_strength^2 = 0.000440822 m; grid.cell_size is 0.0005"},
      {kFailure, kFailure + "shear_fracture_energy = 1.0\n",
       "25: material.rock.failure.shear_fracture_energy: needs cells smaller than 2 mu "
       "shear_fracture_energy / shear strength^2 = 0.000421221 m; grid.cell_size is 0.0005"},
  });
}

TEST_CASE("a fracture energy of a case built in code is refused where the criterion has none") {
  rgimp::Case settings = rgimp::testing::read_text(rgimp::testing::kRightCase);
  rgimp::Failure& failure = *settings.materials.at("rock").failure;
  failure.criterion = rgimp::Criterion::hydrostatic_tension;
  failure.fracture_energy = 1.0;
  CHECK_THROWS_WITH(rgimp::check_case(settings),
                    Catch::EndsWith("fracture_energy: not read by criterion "
                                    "\"hydrostatic-tension\""));
}

TEST_CASE("material values out of range are refused") {
  check_rows({
      {"2600.0", "0", "17: material.rock.density: is 0; expected a number above 0"},
      {"17e9", "-1", "18: material.rock.youngs_modulus: is -1; expected a number above 0"},
      {"0.14", "0.5",
       "19: material.rock.poisson_ratio: is 0.5; expected 0 or more and less than 0.5"},
      {"0.14", "-0.1",
       "19: material.rock.poisson_ratio: is -0.1; expected 0 or more and less than 0.5"},
      {"5.95e6", "0", "22: material.rock.failure.cohesion: is 0; expected a number above 0"},
      {"40.0", "90",
       "23: material.rock.failure.friction_angle: is 90; expected 0 or more and less "
       "than 90"},
      {"2e6", "7.1e6",
       "24: material.rock.failure.tensile_strength: is 7100000; expected at most "
       "cohesion / tan(friction_angle) = 7.09093e+06"},
      {kFailure, kFailure + "treatment = \"pressure-window\"\npressure_min = 1\npressure_max = 2\n",
       "26: material.rock.failure.pressure_min: is 1; expected 0 or less"},
      {kFailure,
       kFailure + "treatment = \"pressure-window\"\npressure_min = -1\npressure_max = -2\n",
       "27: material.rock.failure.pressure_max: is -2; expected 0 or more"},
  });
}
