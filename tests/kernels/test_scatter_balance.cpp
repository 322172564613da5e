#include <Eigen/Geometry>
#include <numeric>

#include "kernel_comparison.hpp"

// What scatters keep: mass, momentum and angular momentum; internal forces have neither a
// resultant nor a moment.
namespace rgimp::tests {
namespace {

using kernels::Isa;

/// Resultant, moment about the origin, and the sizes that went into them.
struct Balance {
  Vector resultant = Vector::Zero();
  Vector moment = Vector::Zero();
  double size = 0.0;
  double size_of_moment = 0.0;

  void add(const Vector& position, const Vector& value) {
    resultant += value;
    moment += position.cross(value);
    size += value.norm();
    size_of_moment += position.norm() * value.norm();
  }
};

template <int Dim>
Vector vector_at(const double* const* field, std::size_t index) {
  Vector v = Vector::Zero();
  for (int a = 0; a < Dim; ++a) {
    v[a] = field[a][index];
  }
  return v;
}

template <int Dim>
Balance of_nodes(const Grid<Dim>& grid, const double* const* field) {
  Balance sum;
  for (std::ptrdiff_t n = 0; n < grid.rows() * grid.row_stride(); ++n) {
    Vector position = grid.position(n);
    position.z() = Dim == 2 ? 0.0 : position.z();
    sum.add(position, vector_at<Dim>(field, static_cast<std::size_t>(n)));
  }
  return sum;
}

template <int Dim>
Balance of_particles(Particles<Dim>& particles) {
  Balance sum;
  const kernels::ParticleView<Dim> view = particles.view();
  for (std::size_t i = 0; i < particles.lanes(); ++i) {
    sum.add(vector_at<Dim>(view.position, i), view.mass[i] * vector_at<Dim>(view.velocity, i));
  }
  return sum;
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("scatters keep mass, momentum and angular momentum; forces sum to nothing",
                       "", ((int Dim), Dim), 2, 3) {
  for (const Isa isa : kernels::kAllIsas) {
    for (const int particles_per_cell : {2, 3, 4}) {
      if (!kernels::available(isa)) {
        continue;
      }
      INFO(kernels::name(isa) << ", " << particles_per_cell << " particles per cell and axis");
      RandomState<Dim> s(23, particles_per_cell, {.most_slots = 12});
      s.grid.clear({0, s.grid.rows()});
      const kernels::GridView<Dim> view = s.grid.view();
      kernels::kernels_for<Dim>(isa).scatter_all(s.particles.view(), view, s.bin_rows());
      double mass = 0.0;
      for (std::size_t n = 0; n < s.nodes(); ++n) {
        mass += view.mass[n];
      }
      const double expected_mass =
          std::accumulate(s.particles.mass.begin(), s.particles.mass.end(), 0.0);
      REQUIRE(mass == Approx(expected_mass).epsilon(1e-13));
      const Balance expected = of_particles(s.particles);
      const Balance momentum = of_nodes(s.grid, view.momentum);
      REQUIRE((momentum.resultant - expected.resultant).norm() < 1e-13 * expected.size);
      REQUIRE((momentum.moment - expected.moment).norm() < 1e-13 * expected.size_of_moment);
      const Balance force = of_nodes(s.grid, view.force);
      REQUIRE(force.size > 0.0);
      REQUIRE(force.resultant.norm() < 1e-13 * force.size);
      REQUIRE(force.moment.norm() < 1e-13 * force.size_of_moment);
    }
  }
}

}  // namespace rgimp::tests
