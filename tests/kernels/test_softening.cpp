#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "models.hpp"
#include "one_particle.hpp"

// Softening by fracture energy on one particle and on each ISA, against the law written out for
// each path.
namespace rgimp::tests {
namespace {

using kernels::Isa;
using Stress = std::array<double, 4>;  // xx, yy, zz, xy

constexpr double kModulus = 17e9 * 0.86 / (1.14 * 0.72);  // lambda + 2 mu
constexpr double kShearModulus = 17e9 / 2.28;
constexpr double kLambda = kModulus - 2.0 * kShearModulus;
constexpr double kStrength = 2e6;
constexpr double kDt = 1e-8;

Material softening_rock() {
  Material material = rock();
  material.failure = rock_failure();
  material.failure->fracture_energy = 1.0;
  material.failure->shear_fracture_energy = 200.0;
  return material;
}

/// eta of a band that is `width` cells wide.
double ductility(double width) {
  return 2.0 * kModulus * 1.0 / (kStrength * kStrength * OneParticle<2>::kCell * width);
}

double damage_at(double kappa, double eta) {
  return std::clamp((1.0 - 1.0 / kappa) / (1.0 - 1.0 / eta), 0.0, 1.0);
}

/// A particle strained along x in small steps, kappa counting strains of the limit.
template <int Dim>
class Pulled {
 public:
  Pulled(const Material& material, Isa isa) : one_(material), isa_(isa) {}

  void pull_to(double kappa) {
    const int steps = 1 + static_cast<int>(std::abs(kappa - kappa_) * 50.0);
    const double rate = (kappa - kappa_) * kStrength / kModulus / (steps * kDt);
    for (int i = 0; i < steps; ++i) {
      released_ += one_.strain({.xx = rate}, kDt, isa_).released_energy;
    }
    kappa_ = kappa;
  }

  /// Damage D, effective stress kappa times the strength along x.
  void require_stress(double damage) {
    const double side = kLambda / kModulus;
    const double mean = kappa_ * kStrength * (1.0 + 2.0 * side) / 3.0;
    const double spared = mean < 0.0 ? damage * mean : 0.0;
    INFO(kernels::name(isa_) << ", kappa " << kappa_ << ", damage " << damage);
    REQUIRE(one_.damage() == Approx(damage).epsilon(1e-9));
    REQUIRE(one_.stress()[0] ==
            Approx((1.0 - damage) * kappa_ * kStrength + spared).margin(1e-8 * kStrength));
    REQUIRE(one_.stress()[1] ==
            Approx((1.0 - damage) * kappa_ * kStrength * side + spared).margin(1e-8 * kStrength));
  }

  OneParticle<Dim>& one() { return one_; }
  double released() const { return released_; }

 private:
  OneParticle<Dim> one_;
  Isa isa_;
  double kappa_ = 0.0;
  double released_ = 0.0;
};

}  // namespace

TEMPLATE_TEST_CASE_SIG("tension softens along a line through onset to failure, and dissipates G_f",
                       "", ((int Dim), Dim), 2, 3) {
  on_each_isa([](Isa isa) {
    const double eta = ductility(1.0);
    Pulled<Dim> pulled(softening_rock(), isa);
    const double area = pulled.one().volume() / OneParticle<2>::kCell;
    pulled.pull_to(0.99);
    REQUIRE(pulled.one().mode() == kernels::kIntact);
    pulled.require_stress(0.0);
    for (const double kappa : {1.5, 3.0, 0.9 * eta}) {
      pulled.pull_to(kappa);
      REQUIRE(pulled.one().mode() == kernels::kSofteningInTension);
      pulled.require_stress(damage_at(kappa, eta));
    }
    pulled.pull_to(1.001 * eta);
    REQUIRE(pulled.one().mode() == kernels::kFailedInTension);
    REQUIRE(pulled.one().damage() == 1.0);
    REQUIRE(pulled.one().stress() == typename OneParticle<Dim>::Stress{});
    // The volume grows by the strain, 2e-3 at failure.
    REQUIRE(pulled.released() / area == Approx(1.0).epsilon(2e-3));
  });
}

TEMPLATE_TEST_CASE_SIG("unloading and reloading follow the secant and release nothing", "",
                       ((int Dim), Dim), 2, 3) {
  on_each_isa([](Isa isa) {
    Pulled<Dim> pulled(softening_rock(), isa);
    pulled.pull_to(4.0);
    const double damage = damage_at(4.0, ductility(1.0));
    const double released = pulled.released();
    for (const double kappa : {2.0, 0.5, 3.9}) {
      pulled.pull_to(kappa);
      pulled.require_stress(damage);
    }
    REQUIRE(pulled.released() == Approx(released).epsilon(1e-9));
    pulled.pull_to(5.0);
    pulled.require_stress(damage_at(5.0, ductility(1.0)));
  });
}

TEMPLATE_TEST_CASE_SIG("a damaged point that closes carries its full pressure", "",
                       ((int Dim), Dim), 2, 3) {
  on_each_isa([](Isa isa) {
    Pulled<Dim> pulled(softening_rock(), isa);
    pulled.pull_to(4.0);
    const double released = pulled.released();
    pulled.pull_to(-3.0);
    pulled.require_stress(damage_at(4.0, ductility(1.0)));
    REQUIRE(pulled.released() == Approx(released).epsilon(1e-6));
  });
}

// Pure shear in the plane pulls along a diagonal: the band is sqrt(2) cells wide.
TEMPLATE_TEST_CASE_SIG("a band along a cell's diagonal softens sooner", "", ((int Dim), Dim), 2,
                       3) {
  on_each_isa([](Isa isa) {
    OneParticle<Dim> one(softening_rock());
    const double kappa = 3.0;
    one.set_stress({0.0, 0.0, 0.0, kappa * kStrength});
    one.strain({}, kDt, isa);
    const double damage = damage_at(kappa, ductility(std::numbers::sqrt2));
    REQUIRE(one.mode() == kernels::kSofteningInTension);
    REQUIRE(one.damage() == Approx(damage).epsilon(1e-12));
    REQUIRE(one.stress()[3] == Approx((1.0 - damage) * kappa * kStrength).epsilon(1e-12));
  });
}

// Mohr's circle is a point: no direction in the plane is the band's.
TEMPLATE_TEST_CASE_SIG("a band under equal tension on all sides is one cell wide", "",
                       ((int Dim), Dim), 2, 3) {
  on_each_isa([](Isa isa) {
    OneParticle<Dim> one(softening_rock());
    const double kappa = 1.5;
    one.set_stress({kappa * kStrength, kappa * kStrength, 0.0, 0.0});
    one.strain({}, kDt, isa);
    const double damage = damage_at(kappa, ductility(1.0));
    REQUIRE(one.mode() == kernels::kSofteningInTension);
    REQUIRE(one.damage() == Approx(damage).epsilon(1e-12));
    REQUIRE(one.stress()[0] == Approx((1.0 - damage) * kappa * kStrength).epsilon(1e-12));
  });
}

TEMPLATE_TEST_CASE_SIG(
    "shear under pressure softens from Mohr-Coulomb's line and keeps the pressure", "",
    ((int Dim), Dim), 2, 3) {
  const double angle = 40.0 * std::numbers::pi / 180.0;
  const double limit = 5.95e6 * std::cos(angle);
  const double eta = 2.0 * kShearModulus * 200.0 / (5.95e6 * 5.95e6 * OneParticle<2>::kCell);
  on_each_isa([&](Isa isa) {
    OneParticle<Dim> one(softening_rock());
    const double shear = 20e6;
    one.set_stress({-20e6, -20e6, -20e6, shear});
    one.strain({}, kDt, isa);
    const double kappa = (shear - 20e6 * std::sin(angle)) / limit;
    REQUIRE(kappa > 1.0);
    const double damage = damage_at(kappa, eta);
    REQUIRE(one.mode() == kernels::kSofteningInShear);
    REQUIRE(one.damage() == Approx(damage).epsilon(1e-12));
    REQUIRE(one.stress()[0] == Approx(-20e6).epsilon(1e-12));
    REQUIRE(one.stress()[3] == Approx((1.0 - damage) * shear).epsilon(1e-12));
  });
}

TEMPLATE_TEST_CASE_SIG("shear stress softens to failure and dissipates G_II", "", ((int Dim), Dim),
                       2, 3) {
  Material material = rock();
  material.failure = Failure{};
  material.failure->criterion = Criterion::shear_stress;
  material.failure->shear_strength = 4e6;
  material.failure->shear_fracture_energy = 5.0;
  const double eta = 2.0 * kShearModulus * 5.0 / (4e6 * 4e6 * OneParticle<2>::kCell);
  on_each_isa([&](Isa isa) {
    OneParticle<Dim> one(material);
    const double area = one.volume() / OneParticle<2>::kCell;
    const int steps = 2000;
    const double rate = 1.001 * eta * 4e6 / kShearModulus / (steps * kDt);
    double released = 0.0;
    for (int i = 0; i < steps; ++i) {
      released += one.strain({.xy = 0.5 * rate, .yx = 0.5 * rate}, kDt, isa).released_energy;
    }
    REQUIRE(one.mode() == kernels::kFailedInShear);
    REQUIRE(released / area == Approx(5.0).epsilon(1e-3));
  });
}

TEMPLATE_TEST_CASE_SIG("without an energy of its own the other mode fails at once", "",
                       ((int Dim), Dim), 2, 3) {
  Material material = softening_rock();
  material.failure->shear_fracture_energy = 0.0;
  on_each_isa([&](Isa isa) {
    OneParticle<Dim> one(material);
    one.set_stress({-20e6, -20e6, -20e6, 20e6});
    one.strain({}, kDt, isa);
    REQUIRE(one.mode() == kernels::kFailedInShear);
    REQUIRE(one.stress()[0] == Approx(-20e6).epsilon(1e-12));
    REQUIRE(one.stress()[3] == 0.0);
  });
}

// Pure shear pulls along a diagonal, where the band is wider than a cell.
TEMPLATE_TEST_CASE_SIG("tension without an energy of its own fails at once, along a diagonal too",
                       "", ((int Dim), Dim), 2, 3) {
  Material material = softening_rock();
  material.failure->fracture_energy = 0.0;
  on_each_isa([&](Isa isa) {
    for (const Stress& stress : {Stress{2.5e6, 0.0, 0.0, 0.0}, Stress{0.0, 0.0, 0.0, 2.5e6}}) {
      OneParticle<Dim> one(material);
      one.set_stress(stress);
      one.strain({}, kDt, isa);
      REQUIRE(one.mode() == kernels::kFailedInTension);
      REQUIRE(one.damage() == 1.0);
      REQUIRE(one.stress() == typename OneParticle<Dim>::Stress{});
    }
  });
}

TEMPLATE_TEST_CASE_SIG("the widest band of the largest cell fails at once", "", ((int Dim), Dim), 2,
                       3) {
  Case settings;
  settings.dimension = Dim;
  settings.grid.cell_size = largest_cell(softening_rock(), Dim).tension;
  const double widest = std::sqrt(static_cast<double>(Dim));
  const kernels::MaterialConstants constants = material_constants(softening_rock(), settings);
  REQUIRE(widest * constants.softening.tension == Approx(1.0).epsilon(1e-14));
  const double expected = 2.0 * kModulus / (kStrength * kStrength * settings.grid.cell_size);
  REQUIRE(widest == Approx(expected).epsilon(1e-14));
}

TEMPLATE_TEST_CASE_SIG("a softening point keeps the mode of its onset", "", ((int Dim), Dim), 2,
                       3) {
  on_each_isa([](Isa isa) {
    OneParticle<Dim> one(softening_rock());
    one.set_stress({2.5e6, 0.0, 0.0, 0.0});
    one.strain({}, kDt, isa);
    REQUIRE(one.mode() == kernels::kSofteningInTension);
    const double damage = one.damage();
    one.set_stress({-100e6, -10e6, -10e6, 0.0});  // beyond the limit in shear
    one.strain({}, kDt, isa);
    REQUIRE(one.mode() == kernels::kSofteningInTension);
    REQUIRE(one.damage() == damage);
  });
}

}  // namespace rgimp::tests
