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

/// Calls visit(particle, node, S, grad S) for all nodes of all particles of the bin rows.
template <int Dim, typename Visit>
void for_each_pair(const ParticleView<Dim>& particles, const GridView<Dim>& grid, RowRange bins,
                   Visit visit) {
  const Shape<Dim> shape(grid);
  for_each_particle(
      particles, grid, bins, [&](std::size_t p, const BinNode<Dim>& bin, std::size_t) {
        for_each_node(stencil_of(particles, p, bin, shape), shape,
                      [&](std::ptrdiff_t node, double weight, const double(&gradient)[Dim]) {
                        visit(p, node, weight, gradient);
                      });
      });
}

template <int Dim>
void scatter_all(const ParticleView<Dim>& particles, const GridView<Dim>& grid, RowRange bins) {
  const Shape<Dim> shape(grid);
  for_each_particle(
      particles, grid, bins, [&](std::size_t p, const BinNode<Dim>& bin, std::size_t) {
        const LoadedStress<Dim> loaded(particles, p);
        for_each_node(stencil_of(particles, p, bin, shape), shape,
                      [&](std::ptrdiff_t node, double weight, const double(&gradient)[Dim]) {
                        const double share = weight * particles.mass[p];
                        grid.mass[node] += share;
                        add_momentum(particles, p, share, grid.momentum, node);
                        add_force(loaded, gradient, grid.force, node);
                      });
      });
}

template <int Dim>
void scatter_mass_momentum(const ParticleView<Dim>& particles, const GridView<Dim>& grid,
                           RowRange bins) {
  for_each_pair(particles, grid, bins,
                [&](std::size_t p, std::ptrdiff_t node, double weight, const double(&)[Dim]) {
                  const double share = weight * particles.mass[p];
                  grid.mass[node] += share;
                  add_momentum(particles, p, share, grid.momentum, node);
                });
}

template <int Dim>
void scatter_force(const ParticleView<Dim>& particles, const GridView<Dim>& grid, RowRange bins) {
  for_each_pair(particles, grid, bins,
                [&](std::size_t p, std::ptrdiff_t node, double, const double(&gradient)[Dim]) {
                  add_force(LoadedStress<Dim>(particles, p), gradient, grid.force, node);
                });
}

template <int Dim>
void scatter_second_momentum(const ParticleView<Dim>& particles, const GridView<Dim>& grid,
                             RowRange bins) {
  for_each_pair(particles, grid, bins,
                [&](std::size_t p, std::ptrdiff_t node, double weight, const double(&)[Dim]) {
                  add_momentum(particles, p, weight * particles.mass[p], grid.second_field, node);
                });
}

}  // namespace rgimp::kernels::reference
