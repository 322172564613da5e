#pragma once

#include "shape.hpp"

namespace rgimp::kernels::reference {

/// column += factor * sum of S_i field_i [Eq. 6].
template <int Dim>
void gather(const ParticleView<Dim>& particles, const GridView<Dim>& grid,
            const double* const* field, double* const* column, double factor, RowRange bins) {
  for_each_particle(particles, grid, bins, [&](std::size_t p, std::ptrdiff_t nearest, std::size_t) {
    const Stencil<Dim> stencil = stencil_of(particles, grid, p, nearest);
    for (int a = 0; a < Dim; ++a) {
      double sum = 0.0;
      for (int n = 0; n < kStencil<Dim>; ++n) {
        sum += stencil.weight[n] * field[a][stencil.node[n]];
      }
      column[a][p] += factor * sum;
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

/// gradient[a][b] = d field_a / d x_b at a particle, 1/s for a velocity.
template <int Dim>
void gradient_at(const Stencil<Dim>& stencil, const double* const* field,
                 double (&gradient)[Dim][Dim]) {
  for (int a = 0; a < Dim; ++a) {
    for (int b = 0; b < Dim; ++b) {
      gradient[a][b] = 0.0;
      for (int n = 0; n < kStencil<Dim>; ++n) {
        gradient[a][b] += stencil.gradient[n][b] * field[a][stencil.node[n]];
      }
    }
  }
}

}  // namespace rgimp::kernels::reference
