#include <catch2/catch.hpp>
#include <cmath>

#include "models.hpp"

// Softening by fracture energy in whole runs.
namespace rgimp::tests {
namespace {

constexpr double kFractureEnergy = 1.0;  // J/m2

/// One cell between a fixed and a pulling platen, held sideways: strained along y alone.
Case one_element(double cell) {
  Case settings = free_block(1.0, 1.0);
  settings.grid.cell_size = cell;
  settings.bodies.front().size = Vector(cell, cell, 0.0);
  settings.materials["rock"].failure = rock_failure();
  settings.materials["rock"].failure->fracture_energy = kFractureEnergy;
  for (const Side side : {Side::top, Side::bottom}) {
    Platen platen;
    platen.side = side;
    platen.lateral = Lateral::stick;
    platen.speed = side == Side::top ? -0.02 : 0.0;
    platen.ramp = 1e-6;
    settings.platens.push_back(platen);
  }
  return settings;
}

}  // namespace

TEST_CASE("an element pulled apart takes the fracture energy, whatever its size") {
  for (const double cell : {1e-3, 0.5e-3, 0.25e-3}) {
    Model model(one_element(cell), 1);
    // 2 G_f / sigma_t = 1 um of opening ends it.
    model.steps(std::llround(1.1e-6 / 0.02 / model.solver.dt()));
    const HistoryRow row = model.solver.history();
    INFO("cells of " << cell << " m: released " << row.released_energy / cell << " J/m2, work "
                     << row.external_work / cell);
    REQUIRE(row.failed_tension == 4);
    REQUIRE(row.released_energy / cell == Approx(kFractureEnergy).epsilon(0.01));
    REQUIRE(std::abs(missing(row)) < 0.01);
  }
}

TEST_CASE("the energy of a softening run is accounted for within 1 %") {
  Model model(softening_block(), 2);
  for (const int steps : {800, 400, 400}) {  // while it softens, as it fails, after
    model.steps(steps);
    const HistoryRow row = model.solver.history();
    INFO("step " << row.step << ": missing " << missing(row) << ", W " << row.external_work
                 << ", released " << row.released_energy);
    REQUIRE(row.released_energy > 0.0);
    REQUIRE(std::abs(missing(row)) < 0.01);
  }
  REQUIRE(model.solver.history().failed_tension > 100);
}

TEST_CASE("a fracture energy delays the first failure to a higher load") {
  Model instant(cracking_block(), 2);
  Model softening(softening_block(), 2);
  instant.steps(1600);
  softening.steps(1600);
  const FirstFailure at_once = instant.solver.first_failure().value();
  const FirstFailure delayed = softening.solver.first_failure().value();
  REQUIRE(delayed.step > at_once.step);
  REQUIRE(delayed.axial_stress > at_once.axial_stress);
}

}  // namespace rgimp::tests
