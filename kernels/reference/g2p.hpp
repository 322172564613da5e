#pragma once

#include "shape.hpp"

namespace rgimp::kernels::reference {

/// Sum of S_i field_i at a particle [Eq. 6].
template <int Dim>
struct Gathered {
  double value[Dim] = {};
};

template <int Dim>
Gathered<Dim> gather(const Stencil<Dim>& stencil, const Shape<Dim>& shape,
                     const double* const* field) {
  Gathered<Dim> sum;
  for_each_node(stencil, shape, [&](std::ptrdiff_t node, double weight, const double(&)[Dim]) {
    for (int a = 0; a < Dim; ++a) {
      sum.value[a] += weight * field[a][node];
    }
  });
  return sum;
}

template <int Dim>
void gather_velocity(const ParticleView<Dim>& particles, const GridView<Dim>& grid, double dt,
                     RowRange bins) {
  const Shape<Dim> shape(grid);
  for_each_particle(particles, grid, bins,
                    [&](std::size_t p, const BinNode<Dim>& bin, std::size_t) {
                      const Gathered<Dim> acceleration =
                          gather(stencil_of(particles, p, bin, shape), shape, grid.force);
                      for (int a = 0; a < Dim; ++a) {
                        particles.velocity[a][p] += dt * acceleration.value[a];
                      }
                    });
}

template <int Dim>
void gather_position(const ParticleView<Dim>& particles, const GridView<Dim>& grid, double dt,
                     RowRange bins, Reach* by_row) {
  const Shape<Dim> shape(grid);
  for (std::ptrdiff_t row = bins.first; row < bins.last; ++row) {
    Reach reach{};
    for_each_particle(
        particles, grid, {row, row + 1}, [&](std::size_t p, const BinNode<Dim>& bin, std::size_t) {
          const Gathered<Dim> velocity =
              gather(stencil_of(particles, p, bin, shape), shape, grid.momentum);
          double step2 = 0.0;
          for (int a = 0; a < Dim; ++a) {
            const double step = dt * velocity.value[a];
            particles.position[a][p] += step;
            step2 += step * step;
            reach.distance =
                std::max(reach.distance, std::abs(node_distance(particles, p, bin, shape, a)));
          }
          reach.step = std::max(reach.step, std::sqrt(step2));
        });
    by_row[row] = reach;
  }
}

/// value[a][b] = d field_a / d x_b, 1/s for a velocity.
template <int Dim>
struct Gradient {
  double value[Dim][Dim] = {};
};

template <int Dim>
Gradient<Dim> gradient_at(const Stencil<Dim>& stencil, const Shape<Dim>& shape,
                          const double* const* field) {
  Gradient<Dim> sum;
  for_each_node(stencil, shape, [&](std::ptrdiff_t node, double, const double(&gradient)[Dim]) {
    for (int a = 0; a < Dim; ++a) {
      for (int b = 0; b < Dim; ++b) {
        sum.value[a][b] += gradient[b] * field[a][node];
      }
    }
  });
  return sum;
}

}  // namespace rgimp::kernels::reference
