#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "models.hpp"
#include "one_particle.hpp"

// Plane strain is what three dimensions make of a state without xz, yz and strain along z.
namespace rgimp::tests {
namespace {

using kernels::Isa;

Material material(double fracture_energy) {
  Material rock_that_fails = rock();
  rock_that_fails.failure = rock_failure();
  rock_that_fails.failure->fracture_energy = fracture_energy;
  rock_that_fails.failure->shear_fracture_energy = 40.0 * fracture_energy;
  return rock_that_fails;
}

/// Strained alike in both, step by step.
class Twins {
 public:
  Twins(double fracture_energy, Isa isa)
      : plane_(material(fracture_energy)), space_(material(fracture_energy)), isa_(isa) {}

  void set_stress(const std::array<double, 4>& stress) {
    plane_.set_stress(stress);
    space_.set_stress(stress);
  }

  void step(const PlaneGradient& gradient) {
    const double dt = 1e-8;
    const double released = plane_.strain(gradient, dt, isa_).released_energy / plane_.volume();
    const double in_space = space_.strain(gradient, dt, isa_).released_energy / space_.volume();
    // J/m3, of the energy that a stress of 1 MPa holds.
    REQUIRE(in_space == Approx(released).epsilon(1e-9).margin(1e-10 * 1e12 / 17e9));
    REQUIRE(space_.mode() == plane_.mode());
    for (int c = 0; c < 4; ++c) {
      REQUIRE(space_.stress()[c] == Approx(plane_.stress()[c]).epsilon(1e-11).margin(1e-4));
    }
    // Slopes along z are sums of weights that cancel to round-off.
    REQUIRE(std::abs(space_.stress()[4]) < 1e-6);
    REQUIRE(std::abs(space_.stress()[5]) < 1e-6);
    REQUIRE(space_.viscous_energy() / space_.volume() ==
            Approx(plane_.viscous_energy() / plane_.volume()).epsilon(1e-11).margin(1e-9));
    if (plane_.material().softens) {
      REQUIRE(space_.damage() == Approx(plane_.damage()).epsilon(1e-10).margin(1e-12));
    }
  }

  double mode() const { return plane_.mode(); }

 private:
  OneParticle<2> plane_;
  OneParticle<3> space_;
  Isa isa_;
};

}  // namespace

TEST_CASE("a path in the plane leaves the same stress, mode, damage and energy in both") {
  on_each_isa([](Isa isa) {
    std::mt19937_64 bits(3);
    const auto uniform = [&](double low, double high) {
      return std::uniform_real_distribution<double>(low, high)(bits);
    };
    int in_tension = 0;
    int in_shear = 0;
    for (int path = 0; path < 100; ++path) {
      INFO("path " << path);
      Twins twins(path % 2 == 0 ? 0.0 : 1.0, isa);
      const double xx = uniform(-20e6, 1e6);
      const double yy = uniform(-20e6, 1e6);
      twins.set_stress({xx, yy, 0.14 * (xx + yy), uniform(-1e6, 1e6)});
      const double rate = 2e4;
      const PlaneGradient gradient{.xx = uniform(-rate, rate),
                                   .xy = uniform(-rate, rate),
                                   .yx = uniform(-rate, rate),
                                   .yy = uniform(-rate, rate)};
      for (int i = 0; i < 20; ++i) {
        twins.step(gradient);
      }
      in_tension += twins.mode() == kernels::kFailedInTension ? 1 : 0;
      in_shear += twins.mode() == kernels::kFailedInShear ? 1 : 0;
    }
    // The paths were chosen to reach both.
    REQUIRE(in_tension > 10);
    REQUIRE(in_shear > 5);
  });
}

}  // namespace rgimp::tests
