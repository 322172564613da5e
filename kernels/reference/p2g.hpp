#pragma once

#include "shape.hpp"

namespace rgimp::kernels::reference {

/// Position of component (a, b) among the stress columns.
template <int Dim>
constexpr int stress_column(int a, int b) {
  if (a == b) {
    return a;
  }
  constexpr int kMixed[4] = {0, 3, 5, 4};  // by a + b: xy = 1, xz = 2, yz = 3
  return kMixed[a + b];
}

template <int Dim>
void add_mass_momentum(const ParticleView<Dim>& particles, std::size_t p,
                       const Stencil<Dim>& stencil, double* mass, double* const* momentum) {
  for (int n = 0; n < kStencil<Dim>; ++n) {
    const double share = stencil.weight[n] * particles.mass[p];
    if (mass != nullptr) {
      mass[stencil.node[n]] += share;
    }
    for (int a = 0; a < Dim; ++a) {
      momentum[a][stencil.node[n]] += share * particles.velocity[a][p];
    }
  }
}

/// Internal force -V (sigma - q I) grad S [Eq. 10], q the bulk viscous pressure.
template <int Dim>
void add_force(const ParticleView<Dim>& particles, std::size_t p, const Stencil<Dim>& stencil,
               double* const* force) {
  double loaded[Dim][Dim];
  for (int a = 0; a < Dim; ++a) {
    for (int b = 0; b < Dim; ++b) {
      loaded[a][b] = particles.volume[p] * particles.stress[stress_column<Dim>(a, b)][p];
    }
    loaded[a][a] -= particles.viscous_energy[p];
  }
  for (int n = 0; n < kStencil<Dim>; ++n) {
    for (int a = 0; a < Dim; ++a) {
      double sum = 0.0;
      for (int b = 0; b < Dim; ++b) {
        sum += loaded[a][b] * stencil.gradient[n][b];
      }
      force[a][stencil.node[n]] -= sum;
    }
  }
}

template <int Dim>
void scatter_all(const ParticleView<Dim>& particles, const GridView<Dim>& grid, RowRange bins) {
  for_each_particle(particles, grid, bins, [&](std::size_t p, std::ptrdiff_t nearest, std::size_t) {
    const Stencil<Dim> stencil = stencil_of(particles, grid, p, nearest);
    add_mass_momentum(particles, p, stencil, grid.mass, grid.momentum);
    add_force(particles, p, stencil, grid.force);
  });
}

template <int Dim>
void scatter_mass_momentum(const ParticleView<Dim>& particles, const GridView<Dim>& grid,
                           RowRange bins) {
  for_each_particle(particles, grid, bins, [&](std::size_t p, std::ptrdiff_t nearest, std::size_t) {
    const Stencil<Dim> stencil = stencil_of(particles, grid, p, nearest);
    add_mass_momentum(particles, p, stencil, grid.mass, grid.momentum);
  });
}

template <int Dim>
void scatter_force(const ParticleView<Dim>& particles, const GridView<Dim>& grid, RowRange bins) {
  for_each_particle(particles, grid, bins, [&](std::size_t p, std::ptrdiff_t nearest, std::size_t) {
    add_force(particles, p, stencil_of(particles, grid, p, nearest), grid.force);
  });
}

template <int Dim>
void scatter_second_momentum(const ParticleView<Dim>& particles, const GridView<Dim>& grid,
                             RowRange bins) {
  for_each_particle(particles, grid, bins, [&](std::size_t p, std::ptrdiff_t nearest, std::size_t) {
    const Stencil<Dim> stencil = stencil_of(particles, grid, p, nearest);
    add_mass_momentum<Dim>(particles, p, stencil, nullptr, grid.second_field);
  });
}

}  // namespace rgimp::kernels::reference
