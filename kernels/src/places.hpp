#pragma once

#include "shape.hpp"

namespace rgimp::kernels {
namespace {

using Mask = xsimd::batch_bool<double, Batch::arch_type>;

/// Where a batch of particles lies about its bins' nodes.
template <int Dim>
struct Places {
  Places(const ParticleView<Dim>& particles, std::size_t index, const BinOffsets<Dim>& offsets,
         const ShapeConstants<Dim>& shape) {
#pragma GCC unroll 3
    for (int a = 0; a < Dim; ++a) {
      const Batch position = Batch::load_aligned(particles.position[a] + index);
      axis[a] = axis_place(node_distance(position, offsets, shape, a), shape);
    }
  }
  AxisPlace axis[Dim];
};

/// `value` where a lane holds a particle, 0 in padding. Padding must stay where it is: next to
/// nearly empty nodes, whose accelerations have no bound, it would fly off and overflow, and a
/// weight of zero does not undo an infinity.
template <int Dim>
inline Batch where_present(const ParticleView<Dim>& particles, std::size_t index, double value) {
  const Mask present = Batch::load_aligned(particles.mass + index) > Batch(0.0);
  return xsimd::select(present, Batch(value), Batch(0.0));
}

/// Largest lane, and at least 0.
inline double largest(Batch values) {
  alignas(64) double lane[kLanes];
  values.store_aligned(lane);
  double most = 0.0;
  for (const double value : lane) {
    most = value > most ? value : most;
  }
  return most;
}

}  // namespace
}  // namespace rgimp::kernels
