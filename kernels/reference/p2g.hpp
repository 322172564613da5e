#pragma once

#include "shape.hpp"

namespace rgimp::kernels::reference {

/// V sigma - V q I of a particle, J: what its gradients of weights are multiplied with.
template <int Dim>
struct LoadedStress {
  LoadedStress(const ParticleView<Dim>& particles, std::size_t p) {
    for (int a = 0; a < Dim; ++a) {
      for (int b = 0; b < Dim; ++b) {
        value[a][b] = particles.volume[p] * particles.stress[kStressColumn[a][b]][p];
      }
      value[a][a] -= particles.viscous_energy[p];
    }
  }
  double value[Dim][Dim];
};

/// Internal force -V (sigma - q I) grad S of one node [Eq. 10], q the bulk viscous pressure.
template <int Dim>
void add_force(const LoadedStress<Dim>& loaded, const double (&gradient)[Dim], double* const* force,
               std::ptrdiff_t node) {
  for (int a = 0; a < Dim; ++a) {
    double sum = 0.0;
    for (int b = 0; b < Dim; ++b) {
      sum += loaded.value[a][b] * gradient[b];
    }
    force[a][node] -= sum;
  }
}

/// m v S of one node [Eq. 8]; `share` is m S.
template <int Dim>
void add_momentum(const ParticleView<Dim>& particles, std::size_t p, double share,
                  double* const* momentum, std::ptrdiff_t node) {
  for (int a = 0; a < Dim; ++a) {
    momentum[a][node] += share * particles.velocity[a][p];
  }
}

/// m, m v and -V (sigma - q I) grad S of one particle to its nodes [Eq. 8-10].
template <int Dim>
void scatter_all_of(const ParticleView<Dim>& particles, std::size_t p, const Stencil<Dim>& stencil,
                    const Shape<Dim>& shape, const GridView<Dim>& grid) {
  const LoadedStress<Dim> loaded(particles, p);
  for_each_node(stencil, shape,
                [&](std::ptrdiff_t node, double weight, const double(&gradient)[Dim]) {
                  const double share = weight * particles.mass[p];
                  grid.mass[node] += share;
                  add_momentum(particles, p, share, grid.momentum, node);
                  add_force(loaded, gradient, grid.force, node);
                });
}

template <int Dim>
void scatter_mass_momentum_of(const ParticleView<Dim>& particles, std::size_t p,
                              const Stencil<Dim>& stencil, const Shape<Dim>& shape,
                              const GridView<Dim>& grid) {
  for_each_node(stencil, shape, [&](std::ptrdiff_t node, double weight, const double(&)[Dim]) {
    const double share = weight * particles.mass[p];
    grid.mass[node] += share;
    add_momentum(particles, p, share, grid.momentum, node);
  });
}

template <int Dim>
void scatter_second_momentum_of(const ParticleView<Dim>& particles, std::size_t p,
                                const Stencil<Dim>& stencil, const Shape<Dim>& shape,
                                const GridView<Dim>& grid) {
  for_each_node(stencil, shape, [&](std::ptrdiff_t node, double weight, const double(&)[Dim]) {
    add_momentum(particles, p, weight * particles.mass[p], grid.second_field, node);
  });
}

template <int Dim>
void scatter_force_of(const ParticleView<Dim>& particles, std::size_t p,
                      const Stencil<Dim>& stencil, const Shape<Dim>& shape,
                      const GridView<Dim>& grid) {
  const LoadedStress<Dim> loaded(particles, p);
  for_each_node(stencil, shape, [&](std::ptrdiff_t node, double, const double(&gradient)[Dim]) {
    add_force(loaded, gradient, grid.force, node);
  });
}

}  // namespace rgimp::kernels::reference
