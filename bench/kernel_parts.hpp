#pragma once

#include <cstddef>

#include "rgimp/kernels/views.hpp"

namespace rgimp::bench {

/// What the parts of a pass work on: the particles of some rows of bins, all of one material.
struct PartInput {
  kernels::ParticleView<2> particles;
  kernels::GridView<2> grid;
  const kernels::MaterialConstants* material;
  double strain_per_velocity;  ///< s/m
  kernels::RowRange bins;
};

/// A part writes its columns of a slot, eight lanes each, to the place of slot & `slot_mask`: all
/// slots of it are kept to be compared; a few, which stay in the first cache as what a pass finds
/// of a round does, to be timed. Padding may hold anything.
using Part = void (*)(const PartInput&, double* out, std::size_t slot_mask);

inline constexpr int kWeightColumns = 12;  // by axis, three weights and their slopes per cell
inline constexpr int kGatherColumns = 2;
inline constexpr int kStressColumns = 4;
inline constexpr int kFailureColumns = 1;

/// The parts of the kernels, compiled once per ISA; the reference's are those of the scalar twins.
struct KernelParts {
  /// Weights and slopes along each axis.
  Part weights;
  /// The force field of the grid at the particles.
  Part gather;
  /// The stress after a strain increment. Any of the right size does: xx and yy are the particle's
  /// velocities times strain_per_velocity, the shear is their sum, twice the rotation their
  /// difference.
  Part stress;
  /// 1 where a stress is to fail, or so near that only the exact test decides, else 0.
  Part failure;
};

extern const KernelParts kReferenceParts;
extern const KernelParts kBaselineParts;
extern const KernelParts kAvx2Parts;
extern const KernelParts kAvx512Parts;

}  // namespace rgimp::bench
