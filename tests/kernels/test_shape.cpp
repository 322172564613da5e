#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <optional>
#include <vector>

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
template <int Dim>
struct Drifted : OneParticle<Dim> {
  Drifted(int particles_per_cell, const Vector& from_node)
      : OneParticle<Dim>(unit_material(), Vector::Zero(), particles_per_cell),
        half(0.5 / particles_per_cell),
        at(OneParticle<Dim>::centre() + from_node) {
    for (int a = 0; a < Dim; ++a) {
      this->particles().position[a][this->lane()] = OneParticle<Dim>::kCell * at[a];
    }
  }

  /// The weight of a node along one axis, or its slope per cell along the axis that is `sloped`.
  double weight(const Vector& node, std::optional<int> sloped = std::nullopt) const {
    double product = 1.0;
    for (int a = 0; a < Dim; ++a) {
      const double distance = at[a] - node[a];
      product *= a == sloped ? eq_18_slope(distance, half) : eq_18(distance, half);
    }
    return product;
  }

  /// Scatters mass, momentum and force to a grid without any.
  void scatter(const kernels::KernelTable<Dim>& k) {
    this->grid().clear({0, this->grid().rows()});
    k.scatter_all(this->particles().view(), this->grid().view(), this->bins());
  }

  /// Calls visit(node, its place in cells) for all nodes.
  template <typename Visit>
  void for_each_node(Visit visit) {
    for (std::ptrdiff_t n = 0; n < this->grid().rows() * this->grid().row_stride(); ++n) {
      visit(n, Vector(this->grid().position(n) / OneParticle<Dim>::kCell));
    }
  }

  double half;
  Vector at;  // cells
};

// Places along an axis, as shares of how far a particle may drift.
template <int Dim>
std::vector<double> places() {
  std::vector<double> shares;
  const int most = Dim == 2 ? 9 : 4;
  for (int i = -most; i <= most; ++i) {
    shares.push_back(static_cast<double>(i) / most);
  }
  return shares;
}

template <int Dim, typename Check>
void on_every_isa_and_place(Check check) {
  on_each_isa([&](Isa isa) {
    for (const int particles_per_cell : {2, 3, 4}) {
      const double reach = 1.0 - 0.5 / particles_per_cell;
      for (const double x : places<Dim>()) {
        for (const double y : places<Dim>()) {
          for (const double z : Dim == 2 ? std::vector{0.0} : places<Dim>()) {
            const Vector from_node = reach * Vector(x, y, z);
            INFO(particles_per_cell << " particles per cell, at (" << from_node.transpose()
                                    << ") cells");
            Drifted<Dim> one(particles_per_cell, from_node);
            check(kernels::kernels_for<Dim>(isa), one);
          }
        }
      }
    }
  });
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("weights are those of Eq. 18 over the whole legal drift, and sum to one", "",
                       ((int Dim), Dim), 2, 3) {
  on_every_isa_and_place<Dim>([](const kernels::KernelTable<Dim>& k, Drifted<Dim>& one) {
    one.scatter(k);
    const double* mass = one.grid().view().mass;
    double sum = 0.0;
    double worst = 0.0;
    one.for_each_node([&](std::ptrdiff_t n, const Vector& node) {
      worst = std::max(worst, std::abs(mass[n] / one.mass() - one.weight(node)));
      sum += mass[n];
    });
    REQUIRE(worst < 1e-13);
    REQUIRE(sum / one.mass() == Approx(1.0).epsilon(1e-14));
  });
}

// f_a = -V dS/dx_a under a stress along the axis a, and no other component.
TEMPLATE_TEST_CASE_SIG("gradients are those of Eq. 18, and sum to zero", "", ((int Dim), Dim), 2,
                       3) {
  on_every_isa_and_place<Dim>([](const kernels::KernelTable<Dim>& k, Drifted<Dim>& one) {
    const double scale = one.volume() / OneParticle<Dim>::kCell;
    for (int a = 0; a < Dim; ++a) {
      typename OneParticle<Dim>::Stress stress = {};
      stress[a] = 1.0;
      one.set_stress_in_space(stress);
      one.scatter(k);
      const kernels::GridView<Dim> view = one.grid().view();
      double sum = 0.0;
      double worst = 0.0;
      double across = 0.0;
      one.for_each_node([&](std::ptrdiff_t n, const Vector& node) {
        worst = std::max(worst, std::abs(-view.force[a][n] / scale - one.weight(node, a)));
        across = std::max(across, std::abs(view.force[(a + 1) % Dim][n]));
        sum += view.force[a][n];
      });
      REQUIRE(worst < 1e-13);
      REQUIRE(across == 0.0);
      REQUIRE(std::abs(sum) / scale < 1e-14);
    }
  });
}

// sigma less the viscous pressure, with the slopes along all axes.
TEMPLATE_TEST_CASE_SIG("a node's force is -(V sigma - V q I) grad S", "", ((int Dim), Dim), 2, 3) {
  const double stress[3][3] = {{3.0, -1.5, 0.7}, {-1.5, -2.0, 1.1}, {0.7, 1.1, 7.0}};
  on_every_isa_and_place<Dim>([&](const kernels::KernelTable<Dim>& k, Drifted<Dim>& one) {
    typename OneParticle<Dim>::Stress columns;
    for (int a = 0; a < 3; ++a) {
      for (int b = 0; b < 3; ++b) {
        const auto column = static_cast<std::size_t>(kernels::kStressColumn[a][b]);
        if (column < columns.size()) {
          columns[column] = stress[a][b];
        }
      }
    }
    one.set_stress_in_space(columns);
    const double pressure = 0.8;
    one.particles().viscous_energy[one.lane()] = pressure * one.volume();
    one.scatter(k);
    const kernels::GridView<Dim> view = one.grid().view();
    const double scale = one.volume() / OneParticle<Dim>::kCell;
    double worst = 0.0;
    one.for_each_node([&](std::ptrdiff_t n, const Vector& node) {
      for (int a = 0; a < Dim; ++a) {
        double pull = 0.0;
        for (int b = 0; b < Dim; ++b) {
          pull += (stress[a][b] - (a == b ? pressure : 0.0)) * one.weight(node, b);
        }
        worst = std::max(worst, std::abs(view.force[a][n] + scale * pull) / scale);
      }
    });
    REQUIRE(worst < 1e-12);
  });
}

TEMPLATE_TEST_CASE_SIG("a linear field is gathered exactly", "", ((int Dim), Dim), 2, 3) {
  const Vector slope[3] = {{2.0, -1.0, 0.3}, {0.5, 0.0, -2.0}, {-0.7, 1.5, 1.0}};
  on_every_isa_and_place<Dim>([&](const kernels::KernelTable<Dim>& k, Drifted<Dim>& one) {
    const kernels::GridView<Dim> view = one.grid().view();
    one.for_each_node([&](std::ptrdiff_t n, const Vector& node) {
      for (int a = 0; a < Dim; ++a) {
        view.force[a][n] = 3.0 + slope[a].dot(node);
      }
    });
    const kernels::ParticleUpdate update{.dt = 2.0};
    k.accelerate(one.particles().view(), view, one.grid().view(1), update, one.bins());
    for (int a = 0; a < Dim; ++a) {
      REQUIRE(one.particles().velocity[a][one.lane()] ==
              Approx(2.0 * (3.0 + slope[a].dot(one.at))).epsilon(1e-13).margin(1e-12));
    }
  });
}

}  // namespace rgimp::tests
