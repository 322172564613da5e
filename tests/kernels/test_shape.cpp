#include <catch2/catch.hpp>
#include <cmath>

#include "one_particle.hpp"

// The weights, seen through what one particle scatters.
namespace rgimp::tests {
namespace {

using kernels::Isa;

constexpr double kHalf = 0.25;

// Eq. 18 with its fourth range corrected, for any distance in cells from a node.
double eq_18(double distance) {
  const double d = std::abs(distance);
  if (d <= kHalf) {
    return 1.0 - (d * d + kHalf * kHalf) / (2.0 * kHalf);
  }
  if (d <= 1.0 - kHalf) {
    return 1.0 - d;
  }
  if (d < 1.0 + kHalf) {
    return (1.0 + kHalf - d) * (1.0 + kHalf - d) / (4.0 * kHalf);
  }
  return 0.0;
}

// Its derivative, per cell.
double eq_18_slope(double distance) {
  const double d = std::abs(distance);
  const double sign = distance > 0.0 ? 1.0 : -1.0;
  if (d <= kHalf) {
    return -distance / kHalf;
  }
  if (d <= 1.0 - kHalf) {
    return -sign;
  }
  return d < 1.0 + kHalf ? -sign * (1.0 + kHalf - d) / (2.0 * kHalf) : 0.0;
}

Material unit_material() {
  return {2600.0, 17e9, 0.14, {}};
}

// One particle moved from its node without binning it again, as far as it may drift.
struct Drifted : OneParticle {
  Drifted(double x, double y) : OneParticle(unit_material(), Vector::Zero()) {
    particles().position[0][lane()] = kCell * (8.0 + x);
    particles().position[1][lane()] = kCell * (8.0 + y);
  }
};

template <typename Check>
void on_every_isa_and_place(Check check) {
  for (const Isa isa : kernels::kAllIsas) {
    if (!kernels::available(isa)) {
      continue;
    }
    for (double x = -0.75; x <= 0.75; x += 0.125) {
      for (double y = -0.75; y <= 0.75; y += 0.0625) {
        INFO(kernels::name(isa) << " at (" << x << ", " << y << ") cells");
        check(kernels::kernels_for<2>(isa), x, y);
      }
    }
  }
}

}  // namespace

TEST_CASE("weights are those of Eq. 18 over the whole legal drift, and sum to one") {
  on_every_isa_and_place([](const kernels::KernelTable<2>& k, double x, double y) {
    Drifted one(x, y);
    one.grid().clear({0, one.grid().rows()});
    k.scatter_mass_momentum(one.particles().view(), one.grid().view(), {1, 16});
    const kernels::GridView<2> view = one.grid().view();
    double sum = 0.0;
    for (std::ptrdiff_t n = 0; n < one.grid().rows() * one.grid().row_stride(); ++n) {
      const Vector node = one.grid().position(n) / OneParticle::kCell;
      const double expected = eq_18(8.0 + x - node.x()) * eq_18(8.0 + y - node.y());
      REQUIRE(view.mass[n] / one.mass() == Approx(expected).margin(1e-13));
      sum += view.mass[n];
    }
    REQUIRE(sum / one.mass() == Approx(1.0).epsilon(1e-14));
  });
}

TEST_CASE("gradients are those of Eq. 18, and sum to zero") {
  on_every_isa_and_place([](const kernels::KernelTable<2>& k, double x, double y) {
    Drifted one(x, y);
    one.set_stress({1.0, 0.0, 0.0, 0.0});  // f_x = -V dS/dx
    one.grid().clear({0, one.grid().rows()});
    k.scatter_force(one.particles().view(), one.grid().view(), {1, 16});
    const kernels::GridView<2> view = one.grid().view();
    const double scale = one.volume() / OneParticle::kCell;
    double sum = 0.0;
    for (std::ptrdiff_t n = 0; n < one.grid().rows() * one.grid().row_stride(); ++n) {
      const Vector node = one.grid().position(n) / OneParticle::kCell;
      const double expected = eq_18_slope(8.0 + x - node.x()) * eq_18(8.0 + y - node.y());
      REQUIRE(-view.force[0][n] / scale == Approx(expected).margin(1e-13));
      REQUIRE(view.force[1][n] == 0.0);
      sum += view.force[0][n];
    }
    REQUIRE(std::abs(sum) / scale < 1e-14);
  });
}

TEST_CASE("a linear field is gathered exactly") {
  on_every_isa_and_place([](const kernels::KernelTable<2>& k, double x, double y) {
    Drifted one(x, y);
    const kernels::GridView<2> view = one.grid().view();
    for (std::ptrdiff_t n = 0; n < one.grid().rows() * one.grid().row_stride(); ++n) {
      const Vector node = one.grid().position(n) / OneParticle::kCell;
      view.force[0][n] = 3.0 + 2.0 * node.x() - node.y();
      view.force[1][n] = -1.0 + 0.5 * node.x();
    }
    k.gather_velocity(one.particles().view(), view, 2.0, {1, 16});
    const double at_x = 8.0 + x;
    REQUIRE(one.particles().velocity[0][one.lane()] ==
            Approx(2.0 * (3.0 + 2.0 * at_x - (8.0 + y))).epsilon(1e-13));
    REQUIRE(one.particles().velocity[1][one.lane()] ==
            Approx(2.0 * (-1.0 + 0.5 * at_x)).epsilon(1e-13));
  });
}

}  // namespace rgimp::tests
