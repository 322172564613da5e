#pragma once

#include "shape.hpp"

namespace rgimp::kernels::reference {

/// column += factor * sum of S_i field_i [Eq. 6].
template <int Dim>
void gather(const ParticleView<Dim>& particles, const GridView<Dim>& grid,
            const double* const* field, double* const* column, double factor, RowRange bins) {
  const Shape<Dim> shape(grid);
  for_each_particle(particles, grid, bins,
                    [&](std::size_t p, const BinNode<Dim>& bin, std::size_t) {
                      double sum[Dim] = {};
                      for_each_node(stencil_of(particles, p, bin, shape), shape,
                                    [&](std::ptrdiff_t node, double weight, const double(&)[Dim]) {
                                      for (int a = 0; a < Dim; ++a) {
                                        sum[a] += weight * field[a][node];
                                      }
                                    });
                      for (int a = 0; a < Dim; ++a) {
                        column[a][p] += factor * sum[a];
                      }
                    });
}

template <int Dim>
void gather_velocity(const ParticleView<Dim>& particles, const GridView<Dim>& grid, double dt,
                     RowRange bins) {
  gather(particles, grid, grid.force, particles.velocity, dt, bins);
}

template <int Dim>
void gather_position(const ParticleView<Dim>& particles, const GridView<Dim>& grid, double dt,
                     RowRange bins) {
  gather(particles, grid, grid.momentum, particles.position, dt, bins);
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
