#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "models.hpp"
#include "one_particle.hpp"

// What a failed particle carries on the way on, by treatment (the paper's section 3.2).
namespace rgimp::tests {
namespace {

using kernels::Isa;
using kernels::kFailedInShear;
using kernels::kFailedInTension;

constexpr double kLambda = 17e9 * 0.14 / (1.14 * 0.72);
constexpr double kShearModulus = 17e9 / 2.28;
constexpr double kBulkModulus = kLambda + 2.0 / 3.0 * kShearModulus;

/// What a failed point goes through: volumetric strain, and the pressure it must end with.
struct Leg {
  std::string name;
  double strain;
  double pressure;
};

struct Journey {
  std::string name;
  Treatment treatment;
  double pressure_at_failure;  // of the trial stress
  double pressure_left;
  std::vector<Leg> legs;
};

constexpr double kWindowMin = -0.5e6;
constexpr double kWindowMax = 1.5e6;

/// Pressed by 1e-4 (0.79 MPa), let go by as much, pulled open by 3e-4, pressed again by 1e-4.
std::vector<Journey> journeys() {
  const double dp = kBulkModulus * 1e-4;
  const auto legs = [](double pressed, double unloaded, double opened, double closed) {
    return std::vector<Leg>{{"pressed", -1e-4, pressed},
                            {"unloaded", 1e-4, unloaded},
                            {"opened", 3e-4, opened},
                            {"closed", -1e-4, closed}};
  };
  return {
      {"no tension", Treatment::no_tension, 1e6, 1e6, legs(1e6 + dp, 1e6, 0.0, dp)},
      {"no tension, failed open", Treatment::no_tension, -0.3e6, 0.0, legs(dp, 0.0, 0.0, dp)},
      {"stress free", Treatment::stress_free, 1e6, 0.0, legs(0.0, 0.0, 0.0, 0.0)},
      {"window", Treatment::pressure_window, 1e6, 1e6,
       legs(kWindowMax, kWindowMax - dp, kWindowMin, kWindowMin + dp)},
      {"window, failed above it", Treatment::pressure_window, 5e6, kWindowMax,
       legs(kWindowMax, kWindowMax - dp, kWindowMin, kWindowMin + dp)},
      {"window, failed below it", Treatment::pressure_window, -0.6e6, kWindowMin,
       legs(kWindowMin + dp, kWindowMin, kWindowMin, kWindowMin + dp)},
  };
}

Material treated_by(Treatment treatment) {
  Material material = rock();
  material.failure = rock_failure();
  material.failure->treatment = treatment;
  if (treatment == Treatment::pressure_window) {
    material.failure->pressure_min = kWindowMin;
    material.failure->pressure_max = kWindowMax;
  }
  return material;
}

/// Past the tensile strength along y, whatever the pressure.
std::array<double, 4> failing_at(double pressure) {
  return {-3.0 * pressure - 2.5e6, 2.5e6, 0.0, 0.0};
}

template <int Dim>
void require_pressure(const OneParticle<Dim>& one, double pressure) {
  for (int c = 0; c < 3; ++c) {
    REQUIRE(one.stress()[c] == Approx(-pressure).epsilon(1e-11).margin(1e-5));
  }
  for (std::size_t c = 3; c < one.stress().size(); ++c) {
    REQUIRE(one.stress()[c] == 0.0);
  }
}

/// A leg in ten steps, sheared and turned on the way.
template <int Dim>
void travel(OneParticle<Dim>& one, const Leg& leg, Isa isa) {
  constexpr double kStep = 1e-8;
  const double rate = leg.strain / (10.0 * kStep);
  const PlaneGradient gradient{.xx = 3.0 * rate, .xy = 4e3, .yx = -1e3, .yy = -2.0 * rate};
  for (int i = 0; i < 10; ++i) {
    const kernels::ParticleSums sums = one.strain(gradient, kStep, isa);
    REQUIRE(sums.failed_tension + sums.failed_shear == 0);
    // q V = m (c0 L^2 d^2 + c1 L c |d|) while it closes, as if it were whole.
    const double closing = std::max(-rate, 0.0);
    const double speed = std::sqrt((kLambda + 2.0 * kShearModulus) / 2600.0);
    const double cell = OneParticle<Dim>::kCell;
    REQUIRE(one.viscous_energy() == Approx(one.mass() * (1.5 * cell * cell * closing * closing +
                                                         0.06 * cell * speed * closing))
                                        .epsilon(1e-11));
  }
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("a failed point pressed, unloaded, opened and closed follows its treatment",
                       "", ((int Dim), Dim), 2, 3) {
  for (const Isa isa : kernels::kAllIsas) {
    if (!kernels::available(isa)) {
      continue;
    }
    for (const Journey& journey : journeys()) {
      OneParticle<Dim> one(treated_by(journey.treatment));
      one.set_stress(failing_at(journey.pressure_at_failure));
      one.strain({}, 1e-8, isa);
      INFO(kernels::name(isa) << ", " << journey.name);
      REQUIRE(one.mode() == kFailedInTension);
      require_pressure(one, journey.pressure_left);
      for (const Leg& leg : journey.legs) {
        INFO(leg.name);
        travel(one, leg, isa);
        require_pressure(one, leg.pressure);
        REQUIRE(one.mode() == kFailedInTension);
      }
    }
  }
}

TEMPLATE_TEST_CASE_SIG(
    "a point failed in shear is treated like one failed in tension and keeps its mode", "",
    ((int Dim), Dim), 2, 3) {
  for (const Isa isa : kernels::kAllIsas) {
    if (!kernels::available(isa)) {
      continue;
    }
    OneParticle<Dim> one(treated_by(Treatment::no_tension));
    one.set_stress({0.0, -30e6, -3e6, 0.0});
    REQUIRE(one.strain({}, 1e-8, isa).failed_shear == 1);
    require_pressure(one, 11e6);
    // Opened far enough to have failed in tension, were it whole.
    const kernels::ParticleSums sums = one.strain({.xx = 1e6, .yy = 1e6}, 1e-8, isa);
    REQUIRE(sums.failed_tension == 0);
    REQUIRE(one.mode() == kFailedInShear);
    require_pressure(one, 0.0);
  }
}

}  // namespace rgimp::tests
