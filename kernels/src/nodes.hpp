#pragma once

#include "places.hpp"

namespace rgimp::kernels {
namespace {

/// Lanes of a sum, added up in one order on every ISA.
struct alignas(64) LaneSum {
  double lane[kGroupWidth] = {};

  void add(Batch value, int part) {
    (Batch::load_aligned(lane + part * kLanes) + value).store_aligned(lane + part * kLanes);
  }
  double total() const {
    double sum = 0.0;
    for (const double value : lane) {
      sum += value;
    }
    return sum;
  }
};

/// 1 / m, and 0 for nodes too light to trust. No lane divides by zero: tests trap that.
inline Batch inverse_mass(Batch mass, Batch least) {
  const Mask heavy = mass > least;
  return xsimd::select(heavy, Batch(1.0) / xsimd::select(heavy, mass, Batch(1.0)), Batch(0.0));
}

/// One batch of nodes; see the scalar twin for what the works mean.
template <int Dim>
inline void update_node_batch(const GridView<Dim>& grid, const NodeUpdate<Dim>& update,
                              std::ptrdiff_t node, Batch& damping_work, Batch& body_work) {
  const Batch zero(0.0);
  const Batch mass = Batch::load_aligned(grid.mass + node);
  const Batch inverse = inverse_mass(mass, Batch(update.least_mass));
  const Batch beta = Batch::load_aligned(grid.damping + node);
  const Batch dt(update.dt);
#pragma GCC unroll 3
  for (int a = 0; a < Dim; ++a) {
    const Batch velocity = Batch::load_aligned(grid.momentum[a] + node) * inverse;
    const Batch body = mass * Batch(update.body_acceleration[a]);
    const Batch force = Batch::load_aligned(grid.force[a] + node) + body;
    const Batch size = beta * xsimd::abs(force);
    const Batch damping =
        xsimd::select(velocity > zero, size, xsimd::select(velocity < zero, -size, zero));
    const Batch acceleration = (force - damping) * inverse;
    const Batch new_velocity = fused(dt, acceleration, velocity);
    damping_work = fused(damping, dt * velocity, damping_work);
    body_work = fused(body, Batch(0.5 * update.dt) * (velocity + new_velocity), body_work);
    acceleration.store_aligned(grid.force[a] + node);
    new_velocity.store_aligned(grid.momentum[a] + node);
  }
}

template <int Dim>
void update_nodes(const GridView<Dim>& grid, const NodeUpdate<Dim>& update, RowRange nodes,
                  NodeSums* by_row) {
  const std::ptrdiff_t stride = grid.groups_in_row * kGroupWidth;
  for (std::ptrdiff_t row = nodes.first; row < nodes.last; ++row) {
    LaneSum damping;
    LaneSum body;
    for (int part = 0; part < kParts; ++part) {
      Batch damping_work(0.0);
      Batch body_work(0.0);
      for (std::ptrdiff_t i = part * kLanes; i < stride; i += kGroupWidth) {
        update_node_batch(grid, update, row * stride + i, damping_work, body_work);
      }
      damping.add(damping_work, part);
      body.add(body_work, part);
    }
    by_row[row] = {damping.total(), body.total()};
  }
}

template <int Dim>
void divide_by_mass(const GridView<Dim>& grid, const double* const* momentum, double least_mass,
                    RowRange nodes) {
  const std::ptrdiff_t stride = grid.groups_in_row * kGroupWidth;
  const Batch least(least_mass);
  for (std::ptrdiff_t n = nodes.first * stride; n < nodes.last * stride; n += kLanes) {
    const Batch inverse = inverse_mass(Batch::load_aligned(grid.mass + n), least);
#pragma GCC unroll 3
    for (int a = 0; a < Dim; ++a) {
      (Batch::load_aligned(momentum[a] + n) * inverse).store_aligned(grid.second_field[a] + n);
    }
  }
}

}  // namespace
}  // namespace rgimp::kernels
