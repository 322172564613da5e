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

/// v += dt sum S a [Eq. 6].
template <int Dim>
void accelerate(const ParticleView<Dim>& particles, std::size_t p, const Stencil<Dim>& stencil,
                const Shape<Dim>& shape, const GridView<Dim>& grid, double dt) {
  const Gathered<Dim> acceleration = gather(stencil, shape, grid.force);
  for (int a = 0; a < Dim; ++a) {
    particles.velocity[a][p] += dt * acceleration.value[a];
  }
}

/// x += dt sum S v [Eq. 6], and how far that took it.
template <int Dim>
void move(const ParticleView<Dim>& particles, std::size_t p, const BinNode<Dim>& bin,
          const Gathered<Dim>& velocity, const Shape<Dim>& shape, double dt, Reach& reach) {
  double step2 = 0.0;
  for (int a = 0; a < Dim; ++a) {
    const double step = dt * velocity.value[a];
    particles.position[a][p] += step;
    step2 += step * step;
    reach.distance = std::max(reach.distance, std::abs(node_distance(particles, p, bin, shape, a)));
  }
  reach.step = std::max(reach.step, std::sqrt(step2));
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
