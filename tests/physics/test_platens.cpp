#include <catch2/catch.hpp>
#include <cmath>

#include "models.hpp"
#include "platen_geometry.hpp"
#include "state_hash.hpp"

namespace rgimp::tests {
namespace {

/// A narrow column, damped, between two platens, the lower one held.
Case column(double height_mm, double speed) {
  Case settings = compressed_block(2.0, height_mm, 0.0);
  settings.platens[0].speed = speed;
  settings.platens[0].ramp = 1e-4;
  settings.local_damping = 0.7;
  return settings;
}

Case breakable(Case settings) {
  settings.materials["rock"].failure = rock_failure();
  return settings;
}

HistoryRow run_to_first_failure(Model& model) {
  while (!model.solver.first_failure() && model.solver.steps_done() < 30000) {
    model.steps(20);
  }
  REQUIRE(model.solver.first_failure());
  return model.solver.history();
}

/// Largest distance of a failed particle from the nearer end, as a share of the height.
double deepest_failure(const Particles<2>& p, double height) {
  double deepest = 0.0;
  for (std::size_t i = 0; i < p.lanes(); ++i) {
    if (p.failure_mode[i] > kernels::kIntact) {
      deepest = std::max(deepest, 0.5 - std::abs(p.position[1][i]) / height);
    }
  }
  return deepest;
}

/// Mean of a stress component over particles whose |y| lies between two bounds.
double mean_stress(const Particles<2>& p, int component, double low, double high) {
  double sum = 0.0;
  int count = 0;
  for (std::size_t i = 0; i < p.lanes(); ++i) {
    const double y = std::abs(p.position[1][i]);
    if (!p.is_padding(i) && y >= low && y <= high) {
      sum += p.stress[component][i];
      ++count;
    }
  }
  return sum / count;
}

}  // namespace

TEST_CASE("an intact column breaks at 2c cos(phi) / (1 - sin(phi)), away from its ends too") {
  Model model(breakable(column(18.0, 0.05)));
  run_to_first_failure(model);
  const FirstFailure first = *model.solver.first_failure();
  const double peak = model.solver.peak_axial_stress();
  INFO("peak " << peak << " Pa at a travel of " << first.closure / 0.5e-3 << " L");
  REQUIRE(first.closure >= 0.05 * 0.5e-3);
  REQUIRE(first.mode == FailureMode::shear);
  REQUIRE(peak == Approx(25.52e6).epsilon(0.015));
  REQUIRE(deepest_failure(model.solver.particles(), 18e-3) > 2.0 * 0.5 / 18.0);
}

TEST_CASE("a pulled column breaks at the tensile strength") {
  Model model(breakable(column(18.0, -0.004)));
  run_to_first_failure(model);
  const FirstFailure first = *model.solver.first_failure();
  INFO("axial stress " << first.axial_stress);
  REQUIRE(first.mode == FailureMode::tension);
  REQUIRE(-first.axial_stress == Approx(2e6).epsilon(0.015));
}

TEST_CASE("stress next to platens that have travelled 0.2 L is that of the middle") {
  for (const Integrator integrator : {Integrator::musl, Integrator::usl, Integrator::usf}) {
    Case settings = column(10.0, 0.1);
    settings.time.integrator = integrator;
    Model model(settings);
    model.steps(14000);
    const HistoryRow row = model.solver.history();
    const double end = mean_stress(model.solver.particles(), 1, 4.4e-3, 6e-3);
    const double middle = mean_stress(model.solver.particles(), 1, 0.0, 1e-3);
    INFO("closure " << row.closure << ", end " << end << ", middle " << middle);
    REQUIRE(row.closure > 0.2 * 0.5e-3);
    REQUIRE(end == Approx(middle).epsilon(2e-3));
  }
}

TEST_CASE("platens that carry a block along, both or one alone, do not load it") {
  for (const Side along : {Side::top, Side::right}) {
    for (const bool has_opposite : {true, false}) {
      Case settings = free_block(5.0, 5.0);
      settings.bodies[0].velocity =
          along == Side::top ? Vector(0.0, -20.0, 0.0) : Vector(-20.0, 0.0, 0.0);
      Platen platen;
      platen.side = along;
      platen.speed = 20.0;
      settings.platens = {platen};
      if (has_opposite) {
        platen.side = along == Side::top ? Side::bottom : Side::left;
        platen.speed = -20.0;
        settings.platens.push_back(platen);
      }
      Model model(settings);
      model.steps(2000);  // over 6 cells
      const Particles<2>& p = model.solver.particles();
      REQUIRE(model.solver.history().reaction == Approx(0.0).margin(1e-3));
      for (std::size_t i = 0; i < p.lanes(); ++i) {
        for (const auto& stress : p.stress) {
          REQUIRE(std::abs(stress[i]) < 1.0);  // Pa
        }
      }
      REQUIRE(model.solver.rebins() == 0);
    }
  }
}

TEST_CASE("the weight of a block that comes to rest on a platen does no work there") {
  for (const Integrator integrator : {Integrator::musl, Integrator::usl, Integrator::usf}) {
    Case settings = free_block(10.0, 20.0);
    settings.time.integrator = integrator;
    settings.platens = {holding(Side::bottom), holding(Side::left), holding(Side::right)};
    settings.body_acceleration = Vector(0.0, -2e4, 0.0);
    settings.local_damping = 0.7;
    Model model(settings);
    model.steps(4000);
    const HistoryRow row = model.solver.history();
    const double held =
        row.strain_energy + row.kinetic_energy + row.damping_work + row.viscous_work;
    INFO("work " << row.external_work << ", held " << held);
    REQUIRE(row.kinetic_energy < 1e-6 * row.strain_energy);
    REQUIRE(row.external_work == Approx(held).epsilon(5e-3));
  }
}

TEST_CASE("two axes loaded at once give the stress of Hooke's law") {
  Case settings = column(5.0, 0.05);
  settings.bodies[0].size.x() = 5e-3;
  Platen side = settings.platens[0];
  side.side = Side::right;
  settings.platens.push_back(side);
  side.side = Side::left;
  side.speed = 0.0;
  settings.platens.push_back(side);
  Model model(settings);
  model.steps(12000);
  const double strain = -model.solver.history().closure / 5e-3;
  const double lame = 17e9 * 0.14 / (1.14 * 0.72);
  const double expected = (2.0 * lame + 17e9 / 1.14) * std::log1p(strain);
  REQUIRE(mean_stress(model.solver.particles(), 0, 0.0, 1.0) == Approx(expected).epsilon(2e-3));
  REQUIRE(mean_stress(model.solver.particles(), 1, 0.0, 1.0) == Approx(expected).epsilon(2e-3));
}

TEST_CASE("a grid that moves gives the same bits on any number of threads, AVX2 and AVX-512") {
  Case settings = breakable(column(10.0, 1.0));
  settings.bodies[0].velocity = Vector(3.0, 0.0, 0.0);
  const auto hash = [&](int threads, kernels::Isa isa) {
    Model model(settings, threads, isa);
    model.steps(1500);
    return state_hash(model.solver.particles());
  };
  const std::uint64_t expected = hash(1, kernels::best_isa());
  REQUIRE(hash(3, kernels::best_isa()) == expected);
  if (kernels::available(kernels::Isa::avx512)) {
    REQUIRE(hash(2, kernels::Isa::avx2) == expected);
  }
}

TEST_CASE("the load's axis is that of the first platen that moves, else of the first one") {
  Case settings = free_block(5.0, 5.0);
  REQUIRE_FALSE(load_axis(settings).has_value());
  Platen held;
  held.side = Side::left;
  settings.platens = {held};
  REQUIRE(load_axis(settings) == 0);
  Platen moving;
  moving.side = Side::top;
  moving.speed = 0.1;
  settings.platens.push_back(moving);
  REQUIRE(load_axis(settings) == 1);
}

}  // namespace rgimp::tests
