#pragma once

#include "rgimp/case.hpp"

/// A counted model of the memory traffic of a step: the particle columns that each pass over the
/// particles reads and writes, in doubles, with all work on a particle that can be done in one pass
/// done in it (an engine that takes more passes moves more). A pass whose columns do not fit into a
/// cache moves them all; columns are updated in place, so a write costs no read besides the one
/// counted. Left out: node fields (8 doubles per node, about 2 per particle, which a band's passes
/// find in cache), group tables, and the step of a failure. Padding lanes move as particles do:
/// multiply by lanes.
namespace rgimp::bench {

struct Pass {
  int reads;
  int writes;
};

/// Columns of each kind.
template <int Dim>
struct Columns {
  static constexpr int kPosition = Dim;
  static constexpr int kVelocity = Dim;
  static constexpr int kMass = 1;
  static constexpr int kVolume = 1;
  static constexpr int kViscousEnergy = 1;
  static constexpr int kFailureMode = 1;
  static constexpr int kStress = Dim == 2 ? 4 : 6;
  static constexpr int kMotion = kPosition + kVelocity + kMass;
  static constexpr int kStrained = kVolume + kViscousEnergy + kStress;  // what a new strain changes
  static constexpr int kAll = kMotion + kStrained + kFailureMode;
};

/// Bytes per lane and step.
template <int Dim>
constexpr double bytes_of_step(Integrator integrator) {
  using Of = Columns<Dim>;
  Pass first{};
  Pass second{};
  switch (integrator) {
    case Integrator::musl:
      first = {Of::kMotion, Of::kVelocity};                // new velocities, scattered again
      second = {Of::kAll, Of::kPosition + Of::kStrained};  // strain, move, scatter
      break;
    case Integrator::usl:
      first = {Of::kAll, Of::kVelocity + Of::kPosition + Of::kStrained};  // all in one
      break;
    case Integrator::usf:
      first = {Of::kMotion, Of::kPosition + Of::kVelocity};  // move, scatter momentum
      second = {Of::kAll - Of::kVelocity, Of::kStrained};    // strain, scatter force
      break;
  }
  return static_cast<double>(sizeof(double)) *
         (first.reads + first.writes + second.reads + second.writes);
}

}  // namespace rgimp::bench
