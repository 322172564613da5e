#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "rgimp/simulation.hpp"

namespace rgimp {

/// What summary.json says of a run.
struct Summary {
  std::size_t particles = 0;  ///< in the last state, without the removed
  std::int64_t steps = 0;
  double dt = 0.0;            ///< s
  double wall_seconds = 0.0;  ///< of the whole run, start-up left out
  double particle_steps_per_second = 0.0;
  std::string isa;
  int threads = 0;
  std::optional<FirstFailure> first_failure;
  std::int64_t failed_tension = 0;
  std::int64_t failed_shear = 0;
  double peak_axial_stress = 0.0;  ///< Pa
  double energy_error = 0.0;       ///< 1
  RemovedParticles removed;
  std::uint64_t state_hash = 0;
};

/// The text of summary.json. What is not a number becomes null; state_hash is 16 hexadecimal
/// digits, for JSON's numbers hold only 53 bits.
std::string format_summary(const Summary& summary);

/// The energy that the books miss at `last` beyond what `first`, the row of step 0, holds already,
/// over the largest work of the platens and body force or the largest energy of `first`, whichever
/// is larger; 0 where there is neither.
double energy_error(const HistoryRow& first, const HistoryRow& last, double largest_work);

}  // namespace rgimp
