#include <catch2/catch.hpp>
#include <cmath>

#include "models.hpp"

// Which time each phase of a step works at, seen at the nodes on a platen whose speed is rising.
namespace rgimp::tests {
namespace {

constexpr int kSteps = 7;

/// The upper platen is still speeding up, the lower one is held.
Case ramped(Integrator integrator) {
  Case settings = compressed_block(5.0, 5.0, 0.0);
  settings.platens[0].speed = 0.5;
  settings.platens[0].ramp = 1e-5;
  settings.time.integrator = integrator;
  return settings;
}

/// A node on the upper platen, in the middle of its row.
std::ptrdiff_t end_node(Model& model) {
  const GridExtent& extent = model.solver.grid().extent();
  const auto row = std::lround((2.5e-3 - extent.origin.y()) / extent.spacing.y());
  const auto column = std::lround(-extent.origin.x() / extent.spacing.x());
  return row * model.solver.grid().row_stride() + column;
}

double speed_at(const Model& model, double steps) {
  return -platen_speed(model.settings.platens[0], steps * model.solver.dt());
}

/// The layer of the grid that the last step started from.
kernels::GridView<2> layer_before(Model& model) {
  const kernels::GridView<2> first = model.solver.grid().view(0);
  const bool now_is_first = model.solver.now().momentum[0] == first.momentum[0];
  return now_is_first ? model.solver.grid().view(1) : first;
}

}  // namespace

TEST_CASE("MUSL and USL move a platen's nodes with its speed at the end of each step") {
  for (const Integrator integrator : {Integrator::musl, Integrator::usl}) {
    Model model(ramped(integrator));
    const std::ptrdiff_t node = end_node(model);
    model.solver.prepare();
    CHECK(model.solver.now().momentum[1][node] == Approx(speed_at(model, 1)).epsilon(1e-12));
    model.steps(kSteps);
    CHECK(model.solver.rebins() == 0);
    CHECK(layer_before(model).momentum[1][node] == Approx(speed_at(model, kSteps)).epsilon(1e-12));
    CHECK(model.solver.now().momentum[1][node] ==
          Approx(speed_at(model, kSteps + 1)).epsilon(1e-12));
    if (integrator == Integrator::musl) {
      CHECK(model.solver.now().second_field[1][node] ==
            Approx(speed_at(model, kSteps)).epsilon(1e-12));
    }
  }
}

TEST_CASE(
    "USF strains with a platen's speed at the start of a step and moves with that at its end") {
  Model model(ramped(Integrator::usf));
  const std::ptrdiff_t node = end_node(model);
  model.steps(kSteps);
  CHECK(layer_before(model).momentum[1][node] == Approx(speed_at(model, kSteps)).epsilon(1e-12));
  CHECK(model.solver.now().second_field[1][node] == Approx(speed_at(model, kSteps)).epsilon(1e-12));
  // Prepared anew, the step starts from the same.
  model.solver.rebin();
  model.solver.prepare();
  CHECK(model.solver.now().second_field[1][node] == Approx(speed_at(model, kSteps)).epsilon(1e-12));
}

TEST_CASE("the grid lies where the platens are, after every step") {
  for (const Integrator integrator : {Integrator::musl, Integrator::usl, Integrator::usf}) {
    Model model(ramped(integrator));
    const double start = model.solver.now().spacing[1];
    for (int step = 1; step <= kSteps; ++step) {
      model.steps(1);
      const double travel = platen_travel(model.settings.platens[0], model.solver.time());
      REQUIRE(travel > 0.0);
      // Ten cells between the platens; a travel of 1e-14 m would be round-off of the spacing.
      CHECK(start - model.solver.now().spacing[1] ==
            Approx(travel / 10.0).epsilon(1e-6).margin(1e-18));
    }
  }
}

TEST_CASE("a particle's failure step is the step at whose end it had failed") {
  Case settings = cracking_block();
  Model model(settings, 2);
  while (!model.solver.first_failure() && model.solver.steps_done() < 2000) {
    model.steps(1);
  }
  REQUIRE(model.solver.first_failure());
  const Particles<2>& p = model.solver.particles();
  int failed = 0;
  std::uint32_t lowest = Particles<2>::kNoId;
  Vector position = Vector::Zero();
  for (std::size_t i = 0; i < p.lanes(); ++i) {
    if (p.failure_mode[i] >= kernels::kFailedInTension) {
      ++failed;
      CHECK(p.failure_step[i] == model.solver.steps_done());
      if (p.id[i] < lowest) {
        lowest = p.id[i];
        position = Vector(p.position[0][i], p.position[1][i], 0.0);
      }
    }
  }
  CHECK(failed > 1);  // both tips at once: the first failure is that of the lowest id
  CHECK(model.solver.first_failure()->position == position);
  CHECK(model.solver.first_failure()->step == model.solver.steps_done());
}

}  // namespace rgimp::tests
