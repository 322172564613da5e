#include <catch2/catch.hpp>
#include <cmath>

#include "models.hpp"

namespace rgimp::tests {
namespace {

/// Compressed slowly enough to be at rest, with damping to get there.
Case slow_compression() {
  Case settings = compressed_block(5.0, 10.0, 0.02);
  settings.local_damping = 0.7;
  return settings;
}

}  // namespace

TEST_CASE("a slipping block has the plane-strain modulus and out-of-plane stress within 0.2 %") {
  Model model(slow_compression());
  model.steps(6000);
  const HistoryRow row = model.solver.history();
  const double modulus = row.axial_stress / (row.closure / 10e-3);
  INFO("modulus " << modulus << ", closure " << row.closure);
  REQUIRE(modulus == Approx(17e9 / (1.0 - 0.14 * 0.14)).epsilon(2e-3));
  const double yy = mean_stress(model.solver.particles(), 1);
  const double zz = mean_stress(model.solver.particles(), 2);
  REQUIRE(zz / yy == Approx(0.14).epsilon(2e-3));
}

TEST_CASE("platens that stick hold the ends' width, platens that slip do not") {
  Case settings = slow_compression();
  const auto widening = [](Case given) {
    Model model(std::move(given));
    model.steps(4000);
    double widest = 0.0;
    const Particles<2>& p = model.solver.particles();
    for (std::size_t i = 0; i < p.lanes(); ++i) {
      if (!p.is_padding(i) && p.position[1][i] > 4.7e-3) {
        widest = std::max(widest, p.position[0][i]);
      }
    }
    return widest - 2.375e-3;
  };
  const double slip = widening(settings);
  for (Platen& platen : settings.platens) {
    platen.lateral = Lateral::stick;
  }
  const double stick = widening(settings);
  REQUIRE(slip > 0.0);
  REQUIRE(stick < 0.2 * slip);
}

TEST_CASE("a platen with a half width loads only the middle") {
  Case settings = slow_compression();
  Model whole(settings);
  for (Platen& platen : settings.platens) {
    platen.half_width = 1e-3;
  }
  Model strip(settings);
  whole.steps(3000);
  strip.steps(3000);
  // Same closure, a softer answer: the ends' corners stay unloaded.
  REQUIRE(strip.solver.history().closure == whole.solver.history().closure);
  REQUIRE(strip.solver.history().reaction < 0.9 * whole.solver.history().reaction);
  const Particles<2>& p = strip.solver.particles();
  double corner = 0.0;
  double middle = 0.0;
  for (std::size_t i = 0; i < p.lanes(); ++i) {
    if (!p.is_padding(i) && p.position[1][i] > 4.5e-3) {
      const double x = std::abs(p.position[0][i]);
      corner = x > 2.2e-3 ? std::min(corner, p.stress[1][i]) : corner;
      middle = x < 0.3e-3 ? std::min(middle, p.stress[1][i]) : middle;
    }
  }
  REQUIRE(std::abs(corner) < 0.2 * std::abs(middle));
}

// At the strain that example 1 ends with, 4e-4: the strain energy sum of V sigma : C^-1 : sigma / 2
// is that of small strains and misses tr eps / 3 of the work of a hypoelastic law.
TEST_CASE("work in equals energy stored and lost within 2e-4, elastic, for every integrator") {
  for (const Integrator integrator : {Integrator::musl, Integrator::usl, Integrator::usf}) {
    Case settings = slow_compression();
    settings.platens[0].speed = settings.platens[1].speed = 0.005;
    settings.time.integrator = integrator;
    settings.time.step_factor = 0.1;
    Model model(settings);
    model.steps(20000);
    const HistoryRow row = model.solver.history();
    const double error = (row.external_work - row.kinetic_energy - row.strain_energy -
                          row.damping_work - row.viscous_work) /
                         row.external_work;
    INFO("integrator " << static_cast<int>(integrator) << ": error " << error << ", W "
                       << row.external_work << ", damping " << row.damping_work << ", viscous "
                       << row.viscous_work);
    REQUIRE(std::abs(error) <= 2e-4);
  }
}

// Booked on the mean velocity of a step, the damping of this disk gave energy back: -4e-4 of the
// work, and in larger ones with flaws a tenth.
TEST_CASE("local damping only takes energy, and a slowly loaded disk's budget closes") {
  Case settings = compressed_block(10.0, 10.0, 0.004);
  settings.bodies[0].shape = BodyShape::disk;
  settings.local_damping = 0.7;
  for (Platen& platen : settings.platens) {
    platen.half_width = 1e-3;
  }
  Model model(std::move(settings));
  double taken = 0.0;
  for (int part = 0; part < 10; ++part) {
    model.steps(500);
    const HistoryRow row = model.solver.history();
    REQUIRE(row.damping_work >= taken);
    taken = row.damping_work;
  }
  const HistoryRow row = model.solver.history();
  const double error = (row.external_work - row.kinetic_energy - row.strain_energy -
                        row.damping_work - row.viscous_work) /
                       row.external_work;
  INFO("error " << error << ", damping " << row.damping_work << " of " << row.external_work);
  REQUIRE(std::abs(error) <= 2e-4);
}

TEST_CASE("integrators agree on the reaction within 0.1 %") {
  const auto reaction = [](Integrator integrator) {
    Case settings = slow_compression();
    settings.time.integrator = integrator;
    Model model(settings);
    model.steps(4000);
    return model.solver.history().reaction;
  };
  const double musl = reaction(Integrator::musl);
  REQUIRE(reaction(Integrator::usl) == Approx(musl).epsilon(1e-3));
  REQUIRE(reaction(Integrator::usf) == Approx(musl).epsilon(1e-3));
}

TEST_CASE("left and right platens do what bottom and top ones do to a block turned by 90 degrees") {
  Case standing = slow_compression();
  standing.local_damping = 0.0;  // it turns on the signs of round-off
  Case lying = standing;
  lying.bodies[0].size = Vector(10e-3, 5e-3, 0.0);
  lying.platens[0].side = Side::right;
  lying.platens[1].side = Side::left;
  Model upright(standing);
  Model turned(lying);
  upright.steps(2000);
  turned.steps(2000);
  const HistoryRow expected = upright.solver.history();
  const HistoryRow row = turned.solver.history();
  REQUIRE(row.closure == expected.closure);
  REQUIRE(row.reaction == Approx(expected.reaction).epsilon(1e-9));
  REQUIRE(row.axial_stress == Approx(expected.axial_stress).epsilon(1e-9));
  REQUIRE(row.strain_energy == Approx(expected.strain_energy).epsilon(1e-9));
}

TEST_CASE("the particles per cell change the reaction by less than 0.1 %") {
  const auto reaction = [](int particles_per_cell) {
    Case settings = slow_compression();
    settings.bodies[0].particles_per_cell = particles_per_cell;
    Model model(settings);
    model.steps(3000);
    return model.solver.history().reaction;
  };
  const double two = reaction(2);
  REQUIRE(reaction(3) == Approx(two).epsilon(1e-3));
  REQUIRE(reaction(4) == Approx(two).epsilon(1e-3));
}

TEST_CASE("two materials in series are as stiff as theory says within 0.5 %") {
  Case settings = slow_compression();
  settings.bodies[0].size.y() = 5e-3;
  settings.bodies[0].center.y() = -2.5e-3;
  settings.bodies.push_back(settings.bodies[0]);
  settings.bodies[1].center.y() = 2.5e-3;
  settings.bodies[1].material = "soft";
  settings.materials["rock"].poisson_ratio = 0.0;  // or the contact would not be uniaxial
  settings.materials["soft"] = settings.materials["rock"];
  settings.materials["soft"].youngs_modulus = 8.5e9;
  Model model(settings);
  model.steps(8000);
  const HistoryRow row = model.solver.history();
  const double modulus = row.axial_stress / (row.closure / 10e-3);
  REQUIRE(modulus == Approx(2.0 / (1.0 / 17e9 + 1.0 / 8.5e9)).epsilon(5e-3));
}

TEST_CASE("a grid shifted by whole cells changes nothing but round-off") {
  Case shifted = slow_compression();
  shifted.grid.min = Vector(-8e-3, -9e-3, 0.0);
  shifted.grid.max = Vector(9e-3, 10e-3, 0.0);
  shifted.local_damping = 0.0;
  Case usual = slow_compression();
  usual.local_damping = 0.0;
  Model model(shifted);
  Model expected(usual);
  model.steps(1000);
  expected.steps(1000);
  REQUIRE(model.solver.history().reaction ==
          Approx(expected.solver.history().reaction).epsilon(1e-10));
}

}  // namespace rgimp::tests
