#include <algorithm>
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
constexpr double kGravity[3] = {0.5, -1.5, 0.25};

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

template <int Dim>
struct OneNode {
  OneNode()
      : grid({Vector::Zero(), Vector::Constant(1.0), {20, 5, Dim == 2 ? 1 : 4}}, 2, kBeta),
        row(Dim == 2 ? 2 : 12),
        node(24 * row + 19) {}  // the last one of a row

  kernels::NodeSums update(Isa isa, const Motion (&motion)[3]) {
    const kernels::GridView<Dim> view = grid.view();
    view.mass[node] = kMass;
    for (int a = 0; a < Dim; ++a) {
      view.momentum[a][node] = kMass * motion[a].velocity;
      view.force[a][node] = motion[a].force;
    }
    std::vector<kernels::NodeSums> sums(static_cast<std::size_t>(grid.rows()));
    kernels::NodeUpdate<Dim> what{.dt = kDt, .least_mass = 1e-9, .body_acceleration = {}};
    std::copy_n(kGravity, Dim, what.body_acceleration);
    kernels::kernels_for<Dim>(isa).update_nodes(view, what, {0, grid.rows()}, sums.data());
    return sums[row];
  }

  Grid<Dim> grid;
  std::ptrdiff_t row;
  std::ptrdiff_t node;
};

}  // namespace

TEMPLATE_TEST_CASE_SIG(
    "local damping opposes a node's velocity, component by component, and spares rest", "",
    ((int Dim), Dim), 2, 3) {
  for (const Isa isa : kernels::kAllIsas) {
    for (const double vx : {-1.0, 0.0, 2.0}) {
      for (const double fy : {-4.0, 5.0}) {
        if (!kernels::available(isa)) {
          continue;
        }
        const Motion motion[3] = {expected(0, vx, 3.0), expected(1, -0.5, fy),
                                  expected(2, 0.75, -2.0)};
        OneNode<Dim> one;
        const kernels::NodeSums sums = one.update(isa, motion);
        const kernels::GridView<Dim> view = one.grid.view();
        double damping_work = 0.0;
        double body_work = 0.0;
        INFO(kernels::name(isa) << ", vx " << vx << ", fy " << fy);
        for (int a = 0; a < Dim; ++a) {
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
