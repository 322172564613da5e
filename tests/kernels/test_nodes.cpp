#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "grid.hpp"
#include "rgimp/kernels/table.hpp"

// The update of one node, against Eq. 7 and 11 written out, on each ISA.
namespace rgimp::tests {
namespace {

using kernels::Isa;

constexpr double kMass = 2.0;
constexpr double kBeta = 0.7;
constexpr double kDt = 0.25;
constexpr double kGravity[2] = {0.5, -1.5};

/// A component of the node before and after.
struct Motion {
  double velocity;
  double force;  // without the body's
  double acceleration;
  double new_velocity;
};

Motion expected(int axis, double velocity, double force) {
  const double total = force + kMass * kGravity[axis];
  const double sign = velocity > 0.0 ? 1.0 : (velocity < 0.0 ? -1.0 : 0.0);
  const double acceleration = (total - sign * kBeta * std::abs(total)) / kMass;
  return {velocity, force, acceleration, velocity + kDt * acceleration};
}

struct OneNode {
  OneNode() : grid({Vector::Zero(), Vector::Constant(1.0), {20, 5, 1}}, 2, kBeta) {}

  kernels::NodeSums update(Isa isa, const Motion (&motion)[2]) {
    const kernels::GridView<2> view = grid.view();
    view.mass[node] = kMass;
    for (int a = 0; a < 2; ++a) {
      view.momentum[a][node] = kMass * motion[a].velocity;
      view.force[a][node] = motion[a].force;
    }
    std::vector<kernels::NodeSums> sums(static_cast<std::size_t>(grid.rows()));
    const kernels::NodeUpdate<2> what{
        .dt = kDt, .least_mass = 1e-9, .body_acceleration = {kGravity[0], kGravity[1]}};
    kernels::kernels_for<2>(isa).update_nodes(view, what, {0, grid.rows()}, sums.data());
    return sums[2];
  }

  Grid<2> grid;
  std::ptrdiff_t node = 2 * 24 + 19;  // the last one of a row
};

}  // namespace

TEST_CASE("local damping opposes a node's velocity, component by component, and spares rest") {
  for (const Isa isa : kernels::kAllIsas) {
    for (const double vx : {-1.0, 0.0, 2.0}) {
      for (const double fy : {-4.0, 5.0}) {
        if (!kernels::available(isa)) {
          continue;
        }
        const Motion motion[2] = {expected(0, vx, 3.0), expected(1, -0.5, fy)};
        OneNode one;
        const kernels::NodeSums sums = one.update(isa, motion);
        const kernels::GridView<2> view = one.grid.view();
        double damping_work = 0.0;
        double body_work = 0.0;
        INFO(kernels::name(isa) << ", vx " << vx << ", fy " << fy);
        for (int a = 0; a < 2; ++a) {
          const Motion& m = motion[a];
          CHECK(view.force[a][one.node] == Approx(m.acceleration).epsilon(1e-14));
          CHECK(view.momentum[a][one.node] == Approx(m.new_velocity).epsilon(1e-14));
          const double total = m.force + kMass * kGravity[a];
          damping_work += kBeta * std::abs(total * m.velocity) * kDt;
          body_work += 0.5 * kDt * kMass * kGravity[a] * (m.velocity + m.new_velocity);
        }
        CHECK(sums.damping_work == Approx(damping_work).epsilon(1e-14));
        CHECK(sums.body_force_work == Approx(body_work).epsilon(1e-14));
      }
    }
  }
}

}  // namespace rgimp::tests
