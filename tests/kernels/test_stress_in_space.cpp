#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>
#include <random>

#include "models.hpp"
#include "one_particle.hpp"

// Stress and failure of a particle in three dimensions, against Eigen's eigenvalues and products.
namespace rgimp::tests {
namespace {

using Eigen::Matrix3d;
using kernels::Isa;
using kernels::kFailedInShear;
using kernels::kFailedInTension;
using kernels::kIntact;
using Stress = OneParticle<3>::Stress;  // xx, yy, zz, xy, yz, xz

Stress columns_of(const Matrix3d& s) {
  return {s(0, 0), s(1, 1), s(2, 2), s(0, 1), s(1, 2), s(0, 2)};
}

Matrix3d matrix_of(const Stress& s) {
  Matrix3d m;
  m << s[0], s[3], s[5], s[3], s[1], s[4], s[5], s[4], s[2];
  return m;
}

std::mt19937_64& random_bits() {
  static std::mt19937_64 bits(5);
  return bits;
}

double uniform(double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random_bits());
}

/// Uniform over all rotations.
Matrix3d random_rotation() {
  std::normal_distribution<double> normal;
  Eigen::Quaterniond q(normal(random_bits()), normal(random_bits()), normal(random_bits()),
                       normal(random_bits()));
  return q.normalized().toRotationMatrix();
}

/// Rotations that leave axes in place or put the principal axes where symmetry makes ties.
std::vector<Matrix3d> rotations() {
  const auto about = [](double degrees, const Vector& axis) {
    return Eigen::AngleAxisd(degrees * std::numbers::pi / 180.0, axis.normalized())
        .toRotationMatrix();
  };
  std::vector<Matrix3d> all = {
      Matrix3d::Identity(),          about(45.0, Vector::UnitX()),
      about(45.0, Vector::UnitY()),  about(45.0, Vector::UnitZ()),
      about(90.0, Vector(1, 1, 1)),  about(120.0, Vector(1, 1, 1)),
      about(1e-9, Vector(1, -2, 3)), about(1e-5, Vector(3, 1, 2)),
      about(30.0, Vector(0, 1, 1)),  about(54.735610317245346, Vector(1, -1, 0))};
  for (int i = 0; i < 30; ++i) {
    all.push_back(random_rotation());
  }
  return all;
}

/// Principal stresses of any size, in any order.
std::vector<Vector> principal_states() {
  std::vector<Vector> states = {
      {1, 0, 0},           {-1, 0, 0},     {1, 1, 0},         {-1, -1, 0},     // uniaxial, biaxial
      {1, 1, 1},           {-1, -1, -1},                                       // hydrostatic
      {1, -1, 0},          {1, 0.14, 0},   {-1, -0.14, 0},                     // plane
      {2, 1, 1},           {2, 2, 1},      {-1, -1, -20},     {-1, -20, -20},  // equal
      {1, 1, -20},         {1, -20, -20},  {1, 1 - 1e-9, -5}, {1, -5, -5 - 1e-9},
      {1, 1 - 1e-15, 0.3},  // all but equal
      {1, 1e-8, -1e-8},    {1e-8, -1, -1}, {1e-6, 1e-7, -1},  {1, -1e6, -1e6},
      {1, 0, -1e8}};
  for (int i = 0; i < 20; ++i) {
    states.emplace_back(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1));
  }
  return states;
}

/// What a criterion compares with its limit, in units of stress, as a function of s1 and s3 and the
/// trace, all of the first degree.
struct Measure {
  std::string name;
  Failure failure;
  double limit;
  double mode;
  std::function<double(double, double, double)> value;
};

const double kModulus = rock().youngs_modulus;
const double kRatio = rock().poisson_ratio;

Failure failure_by(Criterion criterion) {
  Failure failure;
  failure.criterion = criterion;
  failure.tensile_strength = 2e6;
  failure.shear_strength = 4e6;
  failure.tensile_strain = 1e-4;
  failure.shear_strain = 3e-4;
  return failure;
}

/// Mohr-Coulomb is there twice, by its two limits; the one that is met first counts.
std::vector<Measure> measures() {
  const double angle = 40.0 * std::numbers::pi / 180.0;
  const Failure mohr_coulomb = rock_failure();
  const auto major = [](double s1, double, double) { return s1; };
  const auto radius = [](double s1, double s3, double) { return 0.5 * (s1 - s3); };
  return {
      {"Mohr-Coulomb, tension", mohr_coulomb, 2e6, kFailedInTension, major},
      {"Mohr-Coulomb, shear", mohr_coulomb, 5.95e6 * std::cos(angle), kFailedInShear,
       [=](double s1, double s3, double) {
         return 0.5 * (s1 - s3) + 0.5 * (s1 + s3) * std::sin(angle);
       }},
      {"mean stress", failure_by(Criterion::hydrostatic_tension), 2e6, kFailedInTension,
       [](double, double, double trace) { return trace / 3.0; }},
      {"principal stress", failure_by(Criterion::principal_stress), 2e6, kFailedInTension, major},
      {"shear stress", failure_by(Criterion::shear_stress), 4e6, kFailedInShear, radius},
      {"principal strain", failure_by(Criterion::principal_strain), 1e-4 * kModulus,
       kFailedInTension,
       [](double s1, double, double trace) { return (1.0 + kRatio) * s1 - kRatio * trace; }},
      {"shear strain", failure_by(Criterion::shear_strain), 3e-4 * kModulus, kFailedInShear,
       [](double s1, double s3, double) { return (1.0 + kRatio) * (s1 - s3); }},
  };
}

/// The factor on a stress at which a measure meets its limit; none where it never does.
std::optional<double> factor_at_limit(const Measure& measure, const Matrix3d& stress) {
  const Vector s = Eigen::SelfAdjointEigenSolver<Matrix3d>(stress).eigenvalues();  // ascending
  const double value = measure.value(s[2], s[0], stress.trace());
  // What is left of numbers of the stress's size is round-off.
  if (value <= 1e-12 * stress.norm()) {
    return std::nullopt;
  }
  return measure.limit / value;
}

/// Round-off of an eigenvalue is a few units in the last place of the largest one.
double round_off(const Measure& measure, const Matrix3d& at_limit) {
  return 1e-14 * std::max(at_limit.norm() / measure.limit, 1.0);
}

/// What the particle becomes under a stress; it is intact before.
double mode_under(OneParticle<3>& one, const Matrix3d& stress, Isa isa) {
  one.particles().failure_mode[one.lane()] = kIntact;
  one.set_stress_in_space(columns_of(stress));
  one.strain({}, 1e-8, isa);
  return one.mode();
}

}  // namespace

TEST_CASE("each criterion decides by Eigen's principal stresses to round-off") {
  const std::vector<Measure> all = measures();
  on_each_isa([&](Isa isa) {
    for (const Measure& measure : all) {
      Material material = rock();
      material.failure = measure.failure;
      OneParticle<3> one(material);
      for (const Vector& principal : principal_states()) {
        for (const Matrix3d& rotation : rotations()) {
          const Matrix3d turned = rotation * principal.asDiagonal() * rotation.transpose();
          const Matrix3d stress = 0.5 * (turned + turned.transpose());
          const std::optional<double> factor = factor_at_limit(measure, stress);
          if (!factor) {
            continue;
          }
          const Matrix3d at_limit = *factor * stress;
          // The other limit of the same criterion comes first.
          bool comes_first = true;
          for (const Measure& other : all) {
            if (&other != &measure && other.failure.criterion == measure.failure.criterion) {
              comes_first = factor_at_limit(other, stress).value_or(HUGE_VAL) > 1.001 * *factor;
            }
          }
          const double near = round_off(measure, at_limit);
          INFO(measure.name << ", stress at the limit\n" << at_limit << "\nwithin " << near);
          if (comes_first) {
            REQUIRE(mode_under(one, at_limit * (1.0 - near), isa) == kIntact);
            REQUIRE(mode_under(one, at_limit * (1.0 + near), isa) == measure.mode);
          }
        }
      }
    }
  });
}

TEST_CASE("elastic stress in space: Hooke's law and the Jaumann rotation") {
  const double lambda = kModulus * kRatio / ((1.0 + kRatio) * (1.0 - 2.0 * kRatio));
  const double shear = 0.5 * kModulus / (1.0 + kRatio);
  const double dt = 1e-8;
  on_each_isa([&](Isa isa) {
    for (int i = 0; i < 50; ++i) {
      OneParticle<3> one(rock());
      Stress start;
      std::generate(start.begin(), start.end(), [] { return uniform(-5e6, 5e6); });
      one.set_stress_in_space(start);
      const double volume = one.volume();
      const Matrix3d gradient = Matrix3d::NullaryExpr([] { return uniform(-1e4, 1e4); });
      one.strain_in_space(gradient, dt, isa);
      const Matrix3d strain = 0.5 * dt * (gradient + gradient.transpose());
      const Matrix3d turn = 0.5 * dt * (gradient - gradient.transpose());
      const Matrix3d s = matrix_of(start);
      const Matrix3d expected = s + lambda * strain.trace() * Matrix3d::Identity() +
                                2.0 * shear * strain + turn * s - s * turn;
      REQUIRE((matrix_of(one.stress()) - expected).norm() < 1e-12 * expected.norm());
      REQUIRE(one.volume() == Approx(volume * (1.0 + strain.trace())).epsilon(1e-13));
    }
  });
}

TEST_CASE("released energy in space is the strain energy before less that after") {
  Material material = rock();
  material.failure = rock_failure();
  material.failure->treatment = Treatment::stress_free;
  on_each_isa([&](Isa isa) {
    for (const Matrix3d& rotation : rotations()) {
      OneParticle<3> one(material);
      const Matrix3d turned =
          rotation * Vector(3e6, -1e6, 0.5e6).asDiagonal() * rotation.transpose();
      const Matrix3d s = 0.5 * (turned + turned.transpose());
      one.set_stress_in_space(columns_of(s));
      const double energy = 0.5 * one.volume() *
                            ((1.0 + kRatio) * s.squaredNorm() - kRatio * s.trace() * s.trace()) /
                            kModulus;
      REQUIRE(one.strain({}, 1e-8, isa).released_energy == Approx(energy).epsilon(1e-12));
      REQUIRE(one.stress() == Stress{});
    }
  });
}

TEST_CASE("in space a band across a direction n is |n_x| + |n_y| + |n_z| cells wide") {
  Material material = rock();
  material.failure = rock_failure();
  material.failure->fracture_energy = 1.0;
  const double oedometric = kModulus * (1.0 - kRatio) / ((1.0 + kRatio) * (1.0 - 2.0 * kRatio));
  const double kappa = 2.5;
  const double strength = 2e6;
  const auto expected_damage = [&](double width) {
    const double eta = 2.0 * oedometric / (strength * strength * OneParticle<3>::kCell * width);
    return (1.0 - 1.0 / kappa) / (1.0 - 1.0 / eta);
  };
  const auto damage_under = [&](const Matrix3d& s, Isa isa) {
    OneParticle<3> one(material);
    one.set_stress_in_space(columns_of(s));
    one.strain({}, 1e-8, isa);
    REQUIRE(one.mode() == kernels::kSofteningInTension);
    REQUIRE(one.stress()[5] == Approx((1.0 - one.damage()) * s(0, 2)).margin(1e-8 * strength));
    return one.damage();
  };
  // Equal lesser stresses leave the direction marked; equal greater ones do not.
  on_each_isa([&](Isa isa) {
    for (const Vector& lesser : {Vector(0.0, 0.4, -0.3), Vector(0.0, 0.2, 0.2)}) {
      for (const Matrix3d& rotation : rotations()) {
        const Vector principal = kappa * strength * Vector(1.0, lesser.y(), lesser.z());
        const Matrix3d turned = rotation * principal.asDiagonal() * rotation.transpose();
        const Matrix3d s = 0.5 * (turned + turned.transpose());
        INFO("direction " << rotation.col(0).transpose());
        REQUIRE(damage_under(s, isa) ==
                Approx(expected_damage(rotation.col(0).lpNorm<1>())).epsilon(1e-9));
      }
    }
    const double s = kappa * strength;
    REQUIRE(damage_under(Vector(s, s, 0.2 * s).asDiagonal(), isa) ==
            Approx(expected_damage(1.0)).epsilon(1e-12));
    REQUIRE(damage_under(Vector(s, s, s).asDiagonal(), isa) ==
            Approx(expected_damage(1.0)).epsilon(1e-12));
  });
}

}  // namespace rgimp::tests
