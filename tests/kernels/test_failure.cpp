#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <vector>

#include "models.hpp"
#include "one_particle.hpp"

// Every branch of every criterion and treatment, on one particle and on each ISA.
namespace rgimp::tests {
namespace {

using kernels::Isa;
using kernels::kFailedInShear;
using kernels::kFailedInTension;
using kernels::kIntact;
using Stress = std::array<double, 4>;  // xx, yy, zz, xy

Material with(const Failure& failure) {
  Material material = rock();
  material.failure = failure;
  return material;
}

template <int Dim>
double mode_of(const Material& material, const Stress& stress, Isa isa) {
  OneParticle<Dim> one(material);
  one.set_stress(stress);
  one.strain({}, 1e-8, isa);
  return one.mode();
}

// Just under the limit it holds, just over it fails in `mode`; `at_limit` is the stress there. A
// part in 1e12 is far inside the 1e-9 within which the root-free bound hands over to the exact
// test.
void require_limit(const Material& material, const Stress& at_limit, double mode) {
  on_each_isa([&](Isa isa) {
    Stress under = at_limit;
    Stress over = at_limit;
    for (int c = 0; c < 4; ++c) {
      under[c] *= 1.0 - 1e-12;
      over[c] *= 1.0 + 1e-12;
    }
    INFO(at_limit[0] << ", " << at_limit[1] << ", " << at_limit[2] << ", " << at_limit[3]);
    REQUIRE(mode_of<2>(material, under, isa) == kIntact);
    REQUIRE(mode_of<3>(material, under, isa) == kIntact);
    REQUIRE(mode_of<2>(material, over, isa) == mode);
    REQUIRE(mode_of<3>(material, over, isa) == mode);
  });
}

const double kSin = std::sin(40.0 * std::numbers::pi / 180.0);
const double kCos = std::cos(40.0 * std::numbers::pi / 180.0);
const double kStrength = 2.0 * 5.95e6 * kCos / (1.0 - kSin);  // uniaxial, 25.52 MPa

// s3 at the limit for a given s1.
double minor_at_limit(double major) {
  return (major * (1.0 + kSin) - 2.0 * 5.95e6 * kCos) / (1.0 - kSin);
}

}  // namespace

TEST_CASE("Mohr-Coulomb: tension in the plane, along x, y, by shear, and out of it") {
  const Material material = with(rock_failure());
  require_limit(material, {2e6, 0.0, 0.0, 0.0}, kFailedInTension);
  require_limit(material, {-3e6, 2e6, -1e6, 0.0}, kFailedInTension);
  require_limit(material, {0.0, 0.0, 0.0, 2e6}, kFailedInTension);
  require_limit(material, {0.0, 0.0, 2e6, 0.0}, kFailedInTension);
}

TEST_CASE("Mohr-Coulomb: shear with each pair of principal stresses") {
  const Material material = with(rock_failure());
  REQUIRE(kStrength == Approx(25.52e6).epsilon(1e-3));
  require_limit(material, {0.0, -kStrength, -1e6, 0.0}, kFailedInShear);
  require_limit(material, {-1e6, minor_at_limit(-1e6), -5e6, 0.0}, kFailedInShear);
  // zz is the major one, then the minor one.
  require_limit(material, {-2e6, minor_at_limit(1e6), 1e6, 0.0}, kFailedInShear);
  require_limit(material, {-1e6, -2e6, minor_at_limit(-1e6), 0.0}, kFailedInShear);
}

TEST_CASE("Mohr-Coulomb: where both are met, tension comes first") {
  for (const Isa isa : kernels::kAllIsas) {
    if (kernels::available(isa)) {
      REQUIRE(mode_of<2>(with(rock_failure()), {3e6, -40e6, 0.0, 0.0}, isa) == kFailedInTension);
      REQUIRE(mode_of<3>(with(rock_failure()), {3e6, -40e6, 0.0, 0.0}, isa) == kFailedInTension);
    }
  }
}

TEST_CASE("the other criteria of section 3.1") {
  Failure failure;
  failure.tensile_strength = 2e6;
  failure.shear_strength = 4e6;
  failure.tensile_strain = 1e-4;
  failure.shear_strain = 3e-4;
  const double modulus = rock().youngs_modulus;
  const double ratio = rock().poisson_ratio;
  SECTION("hydrostatic tension") {
    failure.criterion = Criterion::hydrostatic_tension;
    require_limit(with(failure), {9e6, -4e6, 1e6, 2e6}, kFailedInTension);
  }
  SECTION("principal stress") {
    failure.criterion = Criterion::principal_stress;
    require_limit(with(failure), {-30e6, 2e6, -1e6, 0.0}, kFailedInTension);
  }
  SECTION("shear stress") {
    failure.criterion = Criterion::shear_stress;
    require_limit(with(failure), {5e6, -3e6, 0.0, 0.0}, kFailedInShear);
    require_limit(with(failure), {0.0, 0.0, 0.0, 4e6}, kFailedInShear);
  }
  SECTION("principal strain") {
    failure.criterion = Criterion::principal_strain;
    // eps_x = (sx - nu (sy + sz)) / E
    const double sy = -3e6;
    const double sz = -1e6;
    require_limit(with(failure), {modulus * 1e-4 + ratio * (sy + sz), sy, sz, 0.0},
                  kFailedInTension);
  }
  SECTION("shear strain") {
    failure.criterion = Criterion::shear_strain;
    // eps1 - eps3 = (s1 - s3) (1 + nu) / E
    const double range = 3e-4 * modulus / (1.0 + ratio);
    require_limit(with(failure), {0.4 * range, -0.6 * range, 0.0, 0.0}, kFailedInShear);
  }
}

TEST_CASE("a material without failure never fails") {
  for (const Isa isa : kernels::kAllIsas) {
    if (kernels::available(isa)) {
      REQUIRE(mode_of<2>(rock(), {1e12, -1e12, 0.0, 1e11}, isa) == kIntact);
      REQUIRE(mode_of<3>(rock(), {1e12, -1e12, 0.0, 1e11}, isa) == kIntact);
    }
  }
}

namespace {

struct Treated {
  Treatment treatment;
  double mean_stress;  // when it fails
  double expected;     // mean stress left
};

Failure treated_by(Treatment treatment) {
  Failure failure = rock_failure();
  failure.treatment = treatment;
  if (treatment == Treatment::pressure_window) {
    failure.pressure_min = -0.5e6;
    failure.pressure_max = 3e6;
  }
  return failure;
}

// Fails in tension along y, whatever the mean.
Stress failing_with_mean(double mean) {
  return {3.0 * mean - 2.5e6, 2.5e6, 0.0, 0.0};
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("a failed point keeps no deviator, and the pressure its treatment leaves",
                       "", ((int Dim), Dim), 2, 3) {
  const std::vector<Treated> rows = {
      {Treatment::no_tension, -5e6, -5e6},      {Treatment::no_tension, 0.6e6, 0.0},
      {Treatment::stress_free, -5e6, 0.0},      {Treatment::stress_free, 0.6e6, 0.0},
      {Treatment::pressure_window, -5e6, -3e6}, {Treatment::pressure_window, 0.6e6, 0.5e6},
      {Treatment::pressure_window, -2e6, -2e6},
  };
  for (const Isa isa : kernels::kAllIsas) {
    if (!kernels::available(isa)) {
      continue;
    }
    for (const Treated& row : rows) {
      INFO(kernels::name(isa) << ", treatment " << static_cast<int>(row.treatment) << ", mean "
                              << row.mean_stress);
      OneParticle<Dim> one(with(treated_by(row.treatment)));
      one.set_stress(failing_with_mean(row.mean_stress));
      const kernels::ParticleSums sums = one.strain({}, 1e-8, isa);
      REQUIRE(one.mode() == kFailedInTension);
      REQUIRE(sums.failed_tension == 1);
      for (int c = 0; c < 3; ++c) {
        REQUIRE(one.stress()[c] == Approx(row.expected).margin(1e-6));
      }
      REQUIRE(one.stress()[3] == 0.0);
      REQUIRE(sums.released_energy > 0.0);
    }
  }
}

TEMPLATE_TEST_CASE_SIG(
    "the pressure of a failed point goes on with K tr D, the deviator stays zero", "",
    ((int Dim), Dim), 2, 3) {
  const double bulk = 17e9 / (3.0 * (1.0 - 2.0 * 0.14));
  for (const Isa isa : kernels::kAllIsas) {
    if (!kernels::available(isa)) {
      continue;
    }
    OneParticle<Dim> one(with(treated_by(Treatment::no_tension)));
    one.set_stress(failing_with_mean(-5e6));
    one.strain({}, 1e-8, isa);
    one.strain({.xx = -3e3, .xy = 5e3, .yx = 0.0, .yy = -1e3}, 1e-8, isa);
    const double expected = -5e6 - bulk * 4e3 * 1e-8;
    REQUIRE(one.stress()[0] == Approx(expected).epsilon(1e-12));
    REQUIRE(one.stress()[1] == Approx(expected).epsilon(1e-12));
    REQUIRE(one.stress()[2] == Approx(expected).epsilon(1e-12));
    REQUIRE(one.stress()[3] == 0.0);
    one.strain({.xx = 0.0, .xy = 0.0, .yx = 0.0, .yy = 1e6}, 1e-7, isa);
    REQUIRE(one.stress()[0] == 0.0);  // opened: no tension
  }
}

TEMPLATE_TEST_CASE_SIG("released energy is the strain energy before less that after", "",
                       ((int Dim), Dim), 2, 3) {
  OneParticle<Dim> one(with(treated_by(Treatment::stress_free)));
  const Stress s = {3e6, -1e6, 0.5e6, 0.7e6};
  one.set_stress(s);
  const double volume = one.volume();
  const double trace = s[0] + s[1] + s[2];
  const double square = s[0] * s[0] + s[1] * s[1] + s[2] * s[2] + 2.0 * s[3] * s[3];
  const double energy = 0.5 * volume * (1.14 * square - 0.14 * trace * trace) / 17e9;
  REQUIRE(one.strain({}, 1e-8, kernels::best_isa()).released_energy ==
          Approx(energy).epsilon(1e-12));
}

TEMPLATE_TEST_CASE_SIG("bulk viscosity acts in compression only, q V = m (c0 L^2 d^2 + c1 L c |d|)",
                       "", ((int Dim), Dim), 2, 3) {
  const double speed = std::sqrt(17e9 * 0.86 / (1.14 * 0.72 * 2600.0));
  const double cell = OneParticle<Dim>::kCell;
  for (const Isa isa : kernels::kAllIsas) {
    if (!kernels::available(isa)) {
      continue;
    }
    OneParticle<Dim> one(rock());
    one.strain({.xx = -200.0, .xy = 0.0, .yx = 0.0, .yy = 50.0}, 1e-8, isa);
    const double d = 150.0;
    REQUIRE(
        one.viscous_energy() ==
        Approx(one.mass() * (1.5 * cell * cell * d * d + 0.06 * cell * speed * d)).epsilon(1e-12));
    // The work of the pressure that acted during a step, q V of the step before.
    const double before = one.viscous_energy();
    const kernels::ParticleSums sums = one.strain({.xx = 100.0}, 1e-8, isa);
    REQUIRE(sums.viscous_work == Approx(-before * 100.0 * 1e-8).epsilon(1e-12));
    REQUIRE(one.viscous_energy() == 0.0);
  }
}

TEMPLATE_TEST_CASE_SIG("elastic stress: Hooke's law in plane strain and the Jaumann rotation", "",
                       ((int Dim), Dim), 2, 3) {
  const double lambda = 17e9 * 0.14 / (1.14 * 0.72);
  const double shear = 17e9 / 2.28;
  for (const Isa isa : kernels::kAllIsas) {
    if (!kernels::available(isa)) {
      continue;
    }
    OneParticle<Dim> one(rock());
    const Stress s = {1e6, -2e6, 0.3e6, 0.4e6};
    one.set_stress(s);
    const double volume = one.volume();
    const double dt = 1e-8;
    one.strain({.xx = 100.0, .xy = 40.0, .yx = -20.0, .yy = -30.0}, dt, isa);
    const double turn = 0.5 * dt * 60.0;
    const Stress expected = {s[0] + dt * (lambda * 70.0 + 2.0 * shear * 100.0) + 2.0 * turn * s[3],
                             s[1] + dt * (lambda * 70.0 - 2.0 * shear * 30.0) - 2.0 * turn * s[3],
                             s[2] + dt * lambda * 70.0,
                             s[3] + dt * shear * 20.0 + turn * (s[1] - s[0])};
    for (int c = 0; c < 4; ++c) {
      REQUIRE(one.stress()[c] == Approx(expected[c]).epsilon(1e-12));
    }
    REQUIRE(one.volume() == Approx(volume * (1.0 + 70.0 * dt)).epsilon(1e-14));
  }
}

}  // namespace rgimp::tests
