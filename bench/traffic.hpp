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

namespace columns {
inline constexpr int kPosition = 2;
inline constexpr int kVelocity = 2;
inline constexpr int kMass = 1;
inline constexpr int kVolume = 1;
inline constexpr int kViscousEnergy = 1;
inline constexpr int kFailureMode = 1;
inline constexpr int kStress = 4;
inline constexpr int kAll =
    kPosition + kVelocity + kMass + kVolume + kViscousEnergy + kFailureMode + kStress;
inline constexpr int kMotion = kPosition + kVelocity + kMass;
inline constexpr int kStrained = kVolume + kViscousEnergy + kStress;  // what a new strain changes
}  // namespace columns

/// Bytes per lane and step.
constexpr double bytes_of_step(Integrator integrator) {
  using namespace columns;
  Pass first{};
  Pass second{};
  switch (integrator) {
    case Integrator::musl:
      first = {kMotion, kVelocity};            // new velocities, scattered again
      second = {kAll, kPosition + kStrained};  // strain, move, scatter
      break;
    case Integrator::usl:
      first = {kAll, kVelocity + kPosition + kStrained};  // all in one
      break;
    case Integrator::usf:
      first = {kMotion, kPosition + kVelocity};  // move, scatter momentum
      second = {kAll - kVelocity, kStrained};    // strain, scatter force
      break;
  }
  return static_cast<double>(sizeof(double)) *
         (first.reads + first.writes + second.reads + second.writes);
}

}  // namespace rgimp::bench
