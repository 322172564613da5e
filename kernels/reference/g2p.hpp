#pragma once

#include "shape.hpp"

namespace rgimp::kernels::reference {

/// Sum of S_i field_i at a particle [Eq. 6].
template <int Dim>
struct Gathered {
  double value[Dim] = {};
};

template <int Dim>
void add_value(Gathered<Dim>& sum, double weight, const double* const* field, std::ptrdiff_t node) {
  for (int a = 0; a < Dim; ++a) {
    sum.value[a] += weight * field[a][node];
  }
}

/// v += dt a, with a gathered [Eq. 6].
template <int Dim>
void accelerate(const ParticleView<Dim>& particles, std::size_t p,
                const Gathered<Dim>& acceleration, double dt) {
  for (int a = 0; a < Dim; ++a) {
    particles.velocity[a][p] += dt * acceleration.value[a];
  }
}

/// x += dt sum S v [Eq. 6], and how far that took it on the grid it is scattered to.
template <int Dim>
void move(const ParticleView<Dim>& particles, std::size_t p, const BinNode<Dim>& bin,
          const Gathered<Dim>& velocity, const Shape<Dim>& to, double dt, Reach& reach) {
  double step2 = 0.0;
  for (int a = 0; a < Dim; ++a) {
    const double step = dt * velocity.value[a];
    particles.position[a][p] += step;
    step2 += step * step;
    reach.distance = std::max(reach.distance, std::abs(node_distance(particles, p, bin, to, a)));
  }
  reach.step = std::max(reach.step, std::sqrt(step2));
}

/// value[a][b] = d field_a / d x_b, 1/s for a velocity.
template <int Dim>
struct Gradient {
  double value[Dim][Dim] = {};
};

template <int Dim>
void add_gradient(Gradient<Dim>& sum, const double (&gradient)[Dim], const double* const* field,
                  std::ptrdiff_t node) {
  for (int a = 0; a < Dim; ++a) {
    for (int b = 0; b < Dim; ++b) {
      sum.value[a][b] += gradient[b] * field[a][node];
    }
  }
}

/// What particles take from their nodes, all gathered in one visit.
template <int Dim>
struct FromNodes {
  Gathered<Dim> acceleration;
  Gathered<Dim> velocity;
  Gradient<Dim> gradient;
};

/// Acceleration and velocity at the end of the step.
template <int Dim>
FromNodes<Dim> gather_motion(const Stencil<Dim>& stencil, const Shape<Dim>& shape,
                             const GridView<Dim>& grid) {
  FromNodes<Dim> sum;
  for_each_node(stencil, shape, [&](std::ptrdiff_t node, double weight, const double(&)[Dim]) {
    add_value(sum.acceleration, weight, grid.force, node);
    add_value(sum.velocity, weight, grid.momentum, node);
  });
  return sum;
}

/// Velocity at the end of the step, and the gradient of the second field.
template <int Dim>
FromNodes<Dim> gather_velocity_and_strain(const Stencil<Dim>& stencil, const Shape<Dim>& shape,
                                          const GridView<Dim>& grid) {
  FromNodes<Dim> sum;
  for_each_node(stencil, shape,
                [&](std::ptrdiff_t node, double weight, const double(&gradient)[Dim]) {
                  add_value(sum.velocity, weight, grid.momentum, node);
                  add_gradient(sum.gradient, gradient, grid.second_field, node);
                });
  return sum;
}

/// Acceleration, velocity at the end of the step, and its gradient.
template <int Dim>
FromNodes<Dim> gather_all(const Stencil<Dim>& stencil, const Shape<Dim>& shape,
                          const GridView<Dim>& grid) {
  FromNodes<Dim> sum;
  for_each_node(stencil, shape,
                [&](std::ptrdiff_t node, double weight, const double(&gradient)[Dim]) {
                  add_value(sum.acceleration, weight, grid.force, node);
                  add_value(sum.velocity, weight, grid.momentum, node);
                  add_gradient(sum.gradient, gradient, grid.momentum, node);
                });
  return sum;
}

template <int Dim>
Gathered<Dim> gather_acceleration(const Stencil<Dim>& stencil, const Shape<Dim>& shape,
                                  const GridView<Dim>& grid) {
  Gathered<Dim> sum;
  for_each_node(stencil, shape, [&](std::ptrdiff_t node, double weight, const double(&)[Dim]) {
    add_value(sum, weight, grid.force, node);
  });
  return sum;
}

template <int Dim>
Gradient<Dim> gather_strain(const Stencil<Dim>& stencil, const Shape<Dim>& shape,
                            const GridView<Dim>& grid) {
  Gradient<Dim> sum;
  for_each_node(stencil, shape, [&](std::ptrdiff_t node, double, const double(&gradient)[Dim]) {
    add_gradient(sum, gradient, grid.second_field, node);
  });
  return sum;
}

}  // namespace rgimp::kernels::reference
