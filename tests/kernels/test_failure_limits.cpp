#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <vector>

#include "models.hpp"
#include "one_particle.hpp"

// Limits met to the last bit, ties, and what a criterion must not see. Stresses are xx, yy, zz, xy.
namespace rgimp::tests {
namespace {

using kernels::Isa;
using kernels::kFailedInShear;
using kernels::kFailedInTension;
using kernels::kIntact;
using Stress = std::array<double, 4>;

struct Strength {
  Criterion criterion;
  double Failure::*value;
  double limit;
};

constexpr Strength kHydrostatic = {Criterion::hydrostatic_tension, &Failure::tensile_strength, 2e6};
constexpr Strength kPrincipal = {Criterion::principal_stress, &Failure::tensile_strength, 2e6};
constexpr Strength kShear = {Criterion::shear_stress, &Failure::shear_strength, 4e6};
constexpr Strength kTensileStrain = {Criterion::principal_strain, &Failure::tensile_strain, 1e-4};
constexpr Strength kShearStrain = {Criterion::shear_strain, &Failure::shear_strain, 3e-4};

Material limited_by(const Strength& strength) {
  Failure failure;
  failure.criterion = strength.criterion;
  failure.*strength.value = strength.limit;
  Material material = rock();
  material.failure = failure;
  return material;
}

Material mohr_coulomb_rock() {
  Material material = rock();
  material.failure = rock_failure();
  return material;
}

template <int Dim>
void require_mode_in(const Material& material, const Stress& stress, double mode) {
  on_each_isa([&](Isa isa) {
    INFO(Dim << " dimensions: " << stress[0] << ", " << stress[1] << ", " << stress[2] << ", "
             << stress[3]);
    OneParticle<Dim> one(material);
    one.set_stress(stress);
    one.strain({}, 1e-8, isa);
    REQUIRE(one.mode() == mode);
  });
}

void require_mode(const Material& material, const Stress& stress, double mode) {
  require_mode_in<2>(material, stress, mode);
  require_mode_in<3>(material, stress, mode);
}

double before(double value) {
  return std::nextafter(value, 0.0);
}

}  // namespace

TEST_CASE("a stress on the limit fails, the number before it does not") {
  require_mode(limited_by(kPrincipal), {2e6, 0.0, 0.0, 0.0}, kFailedInTension);
  require_mode(limited_by(kPrincipal), {before(2e6), 0.0, 0.0, 0.0}, kIntact);
  require_mode(limited_by(kPrincipal), {-1e6, -1e6, 2e6, 0.0}, kFailedInTension);
  require_mode(limited_by(kPrincipal), {-1e6, -1e6, before(2e6), 0.0}, kIntact);
  require_mode(mohr_coulomb_rock(), {0.0, 2e6, 0.0, 0.0}, kFailedInTension);
  require_mode(mohr_coulomb_rock(), {0.0, before(2e6), 0.0, 0.0}, kIntact);
  require_mode(limited_by(kHydrostatic), {5e6, 0.0, 1e6, 5e6}, kFailedInTension);
  require_mode(limited_by(kHydrostatic), {before(5e6), 0.0, 1e6, 5e6}, kIntact);
  require_mode(limited_by(kShear), {4e6, -4e6, 0.0, 0.0}, kFailedInShear);
  require_mode(limited_by(kShear), {before(4e6), -before(4e6), 0.0, 0.0}, kIntact);
}

TEST_CASE("Mohr-Coulomb's corner, where tension and shear are met together, is tension") {
  const double angle = 40.0 * std::numbers::pi / 180.0;
  const double major = 2e6;
  const double minor =
      (major * (1.0 + std::sin(angle)) - 2.0 * 5.95e6 * std::cos(angle)) / (1.0 - std::sin(angle));
  const double over = 1.0 + 1e-12;
  const double under = 1.0 - 1e-12;
  const Material material = mohr_coulomb_rock();
  require_mode(material, {major * over, minor * over, 0.0, 0.0}, kFailedInTension);
  require_mode(material, {major * under, minor * over, 0.0, 0.0}, kFailedInShear);
  require_mode(material, {major * over, minor * under, 0.0, 0.0}, kFailedInTension);
  require_mode(material, {major * under, minor * under, 0.0, 0.0}, kIntact);
  // Out of the plane the major stress is not rounded: on the limit and just before it.
  require_mode(material, {minor * over, 0.0, major, 0.0}, kFailedInTension);
  require_mode(material, {minor * over, 0.0, before(major), 0.0}, kFailedInShear);
}

// A tensile strength near the apex of Mohr-Coulomb's cone, 7.09 MPa, lets shear come first.
TEST_CASE("Mohr-Coulomb fails in shear under mean tension too") {
  Material material = mohr_coulomb_rock();
  material.failure->tensile_strength = 7e6;
  const double angle = 40.0 * std::numbers::pi / 180.0;
  const double centre = 1e6;
  const double radius = 5.95e6 * std::cos(angle) - centre * std::sin(angle);
  for (const double factor : {1.0 - 1e-12, 1.0 + 1e-12}) {
    const double r = radius * factor;
    require_mode(material, {centre + r, centre - r, 0.0, 0.0},
                 factor > 1.0 ? kFailedInShear : kIntact);
  }
}

TEST_CASE("the stress out of the plane counts for the other criteria as well") {
  const double modulus = rock().youngs_modulus;
  const double ratio = rock().poisson_ratio;
  const double near = 1e-12;
  const std::vector<double> sides = {1.0 - near, 1.0 + near};
  for (const double factor : sides) {
    const bool over = factor > 1.0;
    const double in_tension = over ? kFailedInTension : kIntact;
    const double in_shear = over ? kFailedInShear : kIntact;
    // zz as the major one, then as the minor one.
    require_mode(limited_by(kShear), {-7e6, -1e6, -7e6 + 8e6 * factor, 0.0}, in_shear);
    require_mode(limited_by(kShear), {-1e6, 3e6, 3e6 - 8e6 * factor, 0.0}, in_shear);
    const double range = 3e-4 * modulus / (1.0 + ratio) * factor;
    require_mode(limited_by(kShearStrain), {-2e6, -1e6, -2e6 + range, 0.0}, in_shear);
    require_mode(limited_by(kShearStrain), {-1e6, 1e6, 1e6 - range, 0.0}, in_shear);
    // Pulled by 1e-4 out of the plane; zz = E eps + nu (xx + yy).
    const double zz = 1e-4 * modulus * factor + ratio * (-3e6 - 1e6);
    require_mode(limited_by(kTensileStrain), {-3e6, -1e6, zz, 0.0}, in_tension);
  }
}

TEST_CASE("a principal stress or strain is found at any angle in the plane") {
  const double shear_modulus = 17e9 / 2.28;
  for (const double degrees : {0.0, 20.0, 45.0, 70.0, 110.0}) {
    const double twice = 2.0 * degrees * std::numbers::pi / 180.0;
    for (const double factor : {1.0 - 1e-12, 1.0 + 1e-12}) {
      const bool over = factor > 1.0;
      const auto turned = [&](double centre, double radius) {
        return Stress{centre + radius * std::cos(twice), centre - radius * std::cos(twice), 0.0,
                      radius * std::sin(twice)};
      };
      const double radius = 5e6;
      require_mode(limited_by(kPrincipal), turned(2e6 * factor - radius, radius),
                   over ? kFailedInTension : kIntact);
      require_mode(limited_by(kShear), turned(1e6, 4e6 * factor), over ? kFailedInShear : kIntact);
      // No mean stress: eps1 = radius / 2 mu, eps1 - eps3 = radius / mu.
      require_mode(limited_by(kTensileStrain), turned(0.0, 2.0 * shear_modulus * 1e-4 * factor),
                   over ? kFailedInTension : kIntact);
      require_mode(limited_by(kShearStrain), turned(0.0, shear_modulus * 3e-4 * factor),
                   over ? kFailedInShear : kIntact);
    }
  }
}

TEST_CASE("a criterion sees its own quantity and no other") {
  const double huge = 1e12;
  require_mode(limited_by(kHydrostatic), {huge, -huge, 0.0, huge}, kIntact);
  require_mode(limited_by(kPrincipal), {-huge, 1e6, 0.0, 0.0}, kIntact);
  require_mode(limited_by(kShear), {huge, huge, huge, 0.0}, kIntact);
  require_mode(limited_by(kShear), {-huge, -huge, -huge, 0.0}, kIntact);
  require_mode(limited_by(kShearStrain), {huge, huge, huge, 0.0}, kIntact);
  require_mode(limited_by(kTensileStrain), {-huge, -huge, -huge, 0.0}, kIntact);
  // Squeezed along y only, the free sides strain by nu: half the limit in one, past it in the
  // other.
  const double modulus = rock().youngs_modulus;
  require_mode(limited_by(kTensileStrain), {0.0, -0.5e-4 * modulus / 0.14, 0.0, 0.0}, kIntact);
  require_mode(limited_by(kTensileStrain), {0.0, -1.1e-4 * modulus / 0.14, 0.0, 0.0},
               kFailedInTension);
  // Pressure does not help Mohr-Coulomb's point to fail, in shear or at all.
  require_mode(mohr_coulomb_rock(), {-huge, -huge, -huge, 0.0}, kIntact);
}

}  // namespace rgimp::tests
