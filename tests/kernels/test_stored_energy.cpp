#include <catch2/catch.hpp>

#include "energy.hpp"
#include "models.hpp"
#include "one_particle.hpp"

// Energies that one particle holds, against closed forms.
namespace rgimp::tests {
namespace {

using Stress = std::array<double, 4>;  // xx, yy, zz, xy

Material softening_rock() {
  Material material = rock();
  material.failure = rock_failure();
  material.failure->fracture_energy = 1.0;
  material.failure->shear_fracture_energy = 200.0;
  return material;
}

template <int Dim>
StoredEnergy energy_of(OneParticle<Dim>& one) {
  Workers workers(1);
  return stored_energy(one.particles(), one.grid().groups_in_row(), one.grid().rows(),
                       {one.material()}, workers);
}

/// a : C^-1 : b / 2 of an isotropic solid, J/m3.
double half_work(const Stress& a, const Stress& b) {
  const double product = a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + 2.0 * a[3] * b[3];
  const double traces = (a[0] + a[1] + a[2]) * (b[0] + b[1] + b[2]);
  return 0.5 * (1.14 * product - 0.14 * traces) / 17e9;
}

/// sigma with damage taken out again: its deviator, and its mean where that is tension.
Stress effective(const Stress& s, double damage) {
  const double mean = (s[0] + s[1] + s[2]) / 3.0;
  const double whole = mean > 0.0 ? mean / (1.0 - damage) : mean;
  Stress unharmed = {};
  for (int c = 0; c < 4; ++c) {
    const double part = c < 3 ? mean : 0.0;
    unharmed[c] = (s[c] - part) / (1.0 - damage) + (c < 3 ? whole : 0.0);
  }
  return unharmed;
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("a particle holds m v^2 / 2 and V sigma : C^-1 : sigma / 2", "",
                       ((int Dim), Dim), 2, 3) {
  OneParticle<Dim> one(rock());
  const Stress stress = {3e6, -1e6, 0.5e6, 0.7e6};
  one.set_stress(stress);
  one.particles().velocity[0][one.lane()] = 3.0;
  one.particles().velocity[1][one.lane()] = -4.0;
  const StoredEnergy energy = energy_of(one);
  REQUIRE(energy.kinetic == Approx(12.5 * one.mass()).epsilon(1e-14));
  REQUIRE(energy.strain == Approx(one.volume() * half_work(stress, stress)).epsilon(1e-13));
}

TEMPLATE_TEST_CASE_SIG("a softening particle holds V sigma : C^-1 : s / 2, open or closed", "",
                       ((int Dim), Dim), 2, 3) {
  for (const Stress& stress : {Stress{3e6, -1e6, 0.5e6, 0.7e6}, Stress{-3e6, 1e6, -2e6, 0.7e6}}) {
    for (const double mode : {kernels::kSofteningInTension, kernels::kSofteningInShear}) {
      for (const double damage : {0.1, 0.6}) {
        OneParticle<Dim> one(softening_rock());
        one.set_stress(stress);
        one.particles().failure_mode[one.lane()] = mode;
        one.particles().damage[one.lane()] = damage;
        INFO("damage " << damage << ", mode " << mode << ", xx " << stress[0]);
        const double density = half_work(stress, effective(stress, damage));
        REQUIRE(energy_of(one).strain == Approx(one.volume() * density).epsilon(1e-12));
      }
    }
  }
}

TEMPLATE_TEST_CASE_SIG("a failed particle of a material that softens holds its nominal energy", "",
                       ((int Dim), Dim), 2, 3) {
  OneParticle<Dim> one(softening_rock());
  const Stress pressed = {-3e6, -3e6, -3e6, 0.0};
  one.set_stress(pressed);
  one.particles().failure_mode[one.lane()] = kernels::kFailedInShear;
  one.particles().damage[one.lane()] = 1.0;
  REQUIRE(energy_of(one).strain ==
          Approx(one.volume() * half_work(pressed, pressed)).epsilon(1e-13));
}

}  // namespace rgimp::tests
