#pragma once

#include "rgimp/case.hpp"

namespace rgimp {

/// How large a case is, estimated from its shapes alone: nothing is seeded. Real numbers, for what
/// is to be refused need not fit an integer.
struct CaseSize {
  double particles = 0.0;  ///< flaws not taken out
  double lanes = 0.0;      ///< particles and the padding in their groups
  double nodes = 0.0;
  double padded_nodes = 0.0;  ///< rows are whole groups
  double state_bytes = 0.0;   ///< of particles and grid while stepping
};

CaseSize estimate_size(const Case& settings);

/// Bytes that a run with this state takes at its peak: when it writes a snapshot, or when it goes
/// on from a checkpoint, whose state is read whole before it replaces any.
double peak_bytes(double state_bytes, double particles);

}  // namespace rgimp
