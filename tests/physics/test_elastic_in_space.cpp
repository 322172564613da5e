#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>

#include "geometry.hpp"
#include "models.hpp"
#include "rgimp/simulation.hpp"

// Elastic blocks in three dimensions against closed forms.
namespace rgimp::tests {
namespace {

constexpr double kModulus = 17e9;
constexpr double kRatio = 0.14;
constexpr double kHeight = 6e-3;

/// Compressed slowly enough to be at rest, with damping to get there.
Case slow_column() {
  Case settings = in_space(compressed_block(3.0, 1e3 * kHeight, 0.02), 3.0);
  settings.local_damping = 0.7;
  return settings;
}

/// Mean strain along an axis, from what the particles moved.
double mean_strain(const ModelIn<3>& model, Particles<3>& p, int axis) {
  const std::vector<ParticleSeed> seeds = seed_particles(model.settings);
  double product = 0.0;
  double square = 0.0;
  for (std::size_t i = 0; i < p.lanes(); ++i) {
    if (!p.is_padding(i)) {
      const double start = seeds[p.id[i]].position[axis];
      product += start * (p.position[axis][i] - start);
      square += start * start;
    }
  }
  return product / square;
}

}  // namespace

TEST_CASE("a free column in space has Young's modulus and Poisson's ratio within 0.2 %") {
  ModelIn<3> model(slow_column());
  model.steps(5000);
  const HistoryRow row = model.solver.history();
  Particles<3>& p = model.solver.particles();
  const double strain = row.closure / kHeight;
  INFO("modulus " << row.axial_stress / strain);
  REQUIRE(row.axial_stress / strain == Approx(kModulus).epsilon(2e-3));
  for (const int side : {0, 2}) {
    REQUIRE(mean_strain(model, p, side) / strain == Approx(kRatio).epsilon(4e-3));
    REQUIRE(std::abs(mean_stress(p, side)) < 1e-3 * row.axial_stress);
  }
}

TEST_CASE("a column held on four sides has the modulus of uniaxial strain within 0.2 %") {
  Case settings = slow_column();
  for (const Side side : {Side::left, Side::right, Side::front, Side::back}) {
    settings.platens.push_back(holding(side));
  }
  ModelIn<3> model(settings);
  model.steps(5000);
  const HistoryRow row = model.solver.history();
  const double expected = kModulus * (1.0 - kRatio) / ((1.0 + kRatio) * (1.0 - 2.0 * kRatio));
  const double natural_strain = -std::log1p(-row.closure / kHeight);
  INFO("modulus " << row.axial_stress / natural_strain);
  REQUIRE(row.axial_stress / natural_strain == Approx(expected).epsilon(2e-3));
  const Particles<3>& p = model.solver.particles();
  for (const int side : {0, 2}) {
    REQUIRE(mean_stress(p, side) / mean_stress(p, 1) ==
            Approx(kRatio / (1.0 - kRatio)).epsilon(2e-3));
  }
}

TEST_CASE("in space work in equals energy stored and lost within 2e-4, for every integrator") {
  for (const Integrator integrator : {Integrator::musl, Integrator::usl, Integrator::usf}) {
    Case settings = in_space(compressed_block(1.0, 4.0, 0.008), 1.5);
    settings.local_damping = 0.7;
    settings.time.integrator = integrator;
    settings.time.step_factor = 0.1;
    ModelIn<3> model(settings);
    model.steps(10000);
    const HistoryRow row = model.solver.history();
    const double error = (row.external_work - row.kinetic_energy - row.strain_energy -
                          row.damping_work - row.viscous_work) /
                         row.external_work;
    INFO("integrator " << static_cast<int>(integrator) << ": error " << error);
    REQUIRE(std::abs(error) <= 2e-4);
  }
}

TEST_CASE("the largest principal stress of a particle is that of its whole tensor") {
  Simulation simulation(cracking_block_in_space());
  simulation.run_until(100);
  const ParticleTable table = simulation.particles();
  std::array<double, 6> largest{};
  for (std::size_t i = 0; i < table.size(); ++i) {
    const std::array<double, 6>& s = table.stress[i];  // xx, yy, zz, xy, yz, xz
    Eigen::Matrix3d tensor;
    tensor << s[0], s[3], s[5], s[3], s[1], s[4], s[5], s[4], s[2];
    const double size = tensor.norm();
    // Below the largest eigenvalue some minor is negative; above it all are positive, the
    // determinant too.
    const Eigen::Matrix3d rest =
        table.max_principal_stress[i] * Eigen::Matrix3d::Identity() - tensor;
    REQUIRE(std::abs(rest.determinant()) <= 1e-13 * size * size * size);
    for (int a = 0; a < 3; ++a) {
      const int b = (a + 1) % 3;
      REQUIRE(rest(a, a) >= -1e-13 * size);
      REQUIRE(rest(a, a) * rest(b, b) - rest(a, b) * rest(a, b) >= -1e-13 * size * size);
    }
    for (std::size_t c = 0; c < 6; ++c) {
      largest[c] = std::max(largest[c], std::abs(s[c]));
    }
  }
  for (const double component : largest) {
    CHECK(component > 1e3);  // Pa: none is left out
  }
}

}  // namespace rgimp::tests
