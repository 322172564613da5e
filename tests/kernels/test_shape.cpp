#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "one_particle.hpp"

// The weights, seen through what one particle scatters.
namespace rgimp::tests {
namespace {

using kernels::Isa;

// Eq. 18 with its fourth range corrected, for any distance in cells from a node.
double eq_18(double distance, double half) {
  const double d = std::abs(distance);
  if (d <= half) {
    return 1.0 - (d * d + half * half) / (2.0 * half);
  }
  if (d <= 1.0 - half) {
    return 1.0 - d;
  }
  if (d < 1.0 + half) {
    return (1.0 + half - d) * (1.0 + half - d) / (4.0 * half);
  }
  return 0.0;
}

// Its derivative, per cell.
double eq_18_slope(double distance, double half) {
  const double d = std::abs(distance);
  const double sign = distance > 0.0 ? 1.0 : -1.0;
  if (d <= half) {
    return -distance / half;
  }
  if (d <= 1.0 - half) {
    return -sign;
  }
  return d < 1.0 + half ? -sign * (1.0 + half - d) / (2.0 * half) : 0.0;
}

Material unit_material() {
  return {2600.0, 17e9, 0.14, {}};
}

// One particle moved from its node without binning it again, as far as it may drift.
struct Drifted : OneParticle {
  Drifted(int particles_per_cell, double x, double y)
      : OneParticle(unit_material(), Vector::Zero(), particles_per_cell),
        half(0.5 / particles_per_cell),
        at(8.0 + x, 8.0 + y, 0.0) {
    particles().position[0][lane()] = kCell * at.x();
    particles().position[1][lane()] = kCell * at.y();
  }
  double half;
  Vector at;  // cells
};

template <typename Check>
void on_every_isa_and_place(Check check) {
  for (const Isa isa : kernels::kAllIsas) {
    if (!kernels::available(isa)) {
      continue;
    }
    for (const int particles_per_cell : {2, 3, 4}) {
      const double reach = 1.0 - 0.5 / particles_per_cell;
      for (int column = -6; column <= 6; ++column) {
        for (int row = -12; row <= 12; ++row) {
          const double x = reach * column / 6;
          const double y = reach * row / 12;
          INFO(kernels::name(isa) << ", " << particles_per_cell << " particles per cell, at (" << x
                                  << ", " << y << ") cells");
          Drifted one(particles_per_cell, x, y);
          check(kernels::kernels_for<2>(isa), one);
        }
      }
    }
  }
}

}  // namespace

TEST_CASE("weights are those of Eq. 18 over the whole legal drift, and sum to one") {
  on_every_isa_and_place([](const kernels::KernelTable<2>& k, Drifted& one) {
    one.grid().clear({0, one.grid().rows()});
    k.scatter_mass_momentum(one.particles().view(), one.grid().view(), {1, 16});
    const kernels::GridView<2> view = one.grid().view();
    double sum = 0.0;
    for (std::ptrdiff_t n = 0; n < one.grid().rows() * one.grid().row_stride(); ++n) {
      const Vector node = one.grid().position(n) / OneParticle::kCell;
      const double expected =
          eq_18(one.at.x() - node.x(), one.half) * eq_18(one.at.y() - node.y(), one.half);
      REQUIRE(view.mass[n] / one.mass() == Approx(expected).margin(1e-13));
      sum += view.mass[n];
    }
    REQUIRE(sum / one.mass() == Approx(1.0).epsilon(1e-14));
  });
}

TEST_CASE("gradients are those of Eq. 18, and sum to zero") {
  on_every_isa_and_place([](const kernels::KernelTable<2>& k, Drifted& one) {
    one.set_stress({1.0, 0.0, 0.0, 0.0});  // f_x = -V dS/dx
    one.grid().clear({0, one.grid().rows()});
    k.scatter_all(one.particles().view(), one.grid().view(), {1, 16});
    const kernels::GridView<2> view = one.grid().view();
    const double scale = one.volume() / OneParticle::kCell;
    double sum = 0.0;
    for (std::ptrdiff_t n = 0; n < one.grid().rows() * one.grid().row_stride(); ++n) {
      const Vector node = one.grid().position(n) / OneParticle::kCell;
      const double expected =
          eq_18_slope(one.at.x() - node.x(), one.half) * eq_18(one.at.y() - node.y(), one.half);
      REQUIRE(-view.force[0][n] / scale == Approx(expected).margin(1e-13));
      REQUIRE(view.force[1][n] == 0.0);
      sum += view.force[0][n];
    }
    REQUIRE(std::abs(sum) / scale < 1e-14);
  });
}

// sigma less the viscous pressure, with the slopes along both axes.
TEST_CASE("a node's force is -(V sigma - V q I) grad S") {
  const double stress[2][2] = {{3.0, -1.5}, {-1.5, -2.0}};
  on_every_isa_and_place([&](const kernels::KernelTable<2>& k, Drifted& one) {
    one.set_stress({stress[0][0], stress[1][1], 7.0, stress[0][1]});
    const double pressure = 0.8;
    one.particles().viscous_energy[one.lane()] = pressure * one.volume();
    one.grid().clear({0, one.grid().rows()});
    k.scatter_all(one.particles().view(), one.grid().view(), {1, 16});
    const kernels::GridView<2> view = one.grid().view();
    const double scale = one.volume() / OneParticle::kCell;
    double worst = 0.0;
    for (std::ptrdiff_t n = 0; n < one.grid().rows() * one.grid().row_stride(); ++n) {
      const Vector away = one.at - one.grid().position(n) / OneParticle::kCell;
      const double slope[2] = {eq_18_slope(away.x(), one.half) * eq_18(away.y(), one.half),
                               eq_18(away.x(), one.half) * eq_18_slope(away.y(), one.half)};
      for (int a = 0; a < 2; ++a) {
        const double pull = stress[a][0] * slope[0] + stress[a][1] * slope[1];
        const double expected = -scale * (pull - pressure * slope[a]);
        worst = std::max(worst, std::abs(view.force[a][n] - expected) / scale);
      }
    }
    REQUIRE(worst < 1e-12);
  });
}

TEST_CASE("a linear field is gathered exactly") {
  on_every_isa_and_place([](const kernels::KernelTable<2>& k, Drifted& one) {
    const kernels::GridView<2> view = one.grid().view();
    for (std::ptrdiff_t n = 0; n < one.grid().rows() * one.grid().row_stride(); ++n) {
      const Vector node = one.grid().position(n) / OneParticle::kCell;
      view.force[0][n] = 3.0 + 2.0 * node.x() - node.y();
      view.force[1][n] = -1.0 + 0.5 * node.x();
    }
    const kernels::ParticleUpdate update{.dt = 2.0};
    k.accelerate(one.particles().view(), view, one.grid().view(1), update, {1, 16});
    REQUIRE(one.particles().velocity[0][one.lane()] ==
            Approx(2.0 * (3.0 + 2.0 * one.at.x() - one.at.y())).epsilon(1e-13));
    REQUIRE(one.particles().velocity[1][one.lane()] ==
            Approx(2.0 * (-1.0 + 0.5 * one.at.x())).epsilon(1e-13));
  });
}

}  // namespace rgimp::tests
