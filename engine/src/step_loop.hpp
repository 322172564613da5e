#pragma once

#include <chrono>
#include <cstdint>

#include "output_schedule.hpp"
#include "rgimp/run.hpp"

namespace rgimp {

/// Advances a simulation, timing nothing but its steps, and reports progress at an even pace.
class StepLoop {
 public:
  StepLoop(Simulation& simulation, const RunOptions& options);

  /// Some steps, a fifth of a second's worth, and never past `stop`.
  void advance(std::int64_t stop);
  void report();
  double particle_steps_per_second() const;

 private:
  using Clock = std::chrono::steady_clock;

  Simulation& simulation_;
  const RunOptions& options_;
  Facts facts_;
  std::int64_t first_step_;
  ChunkSize chunk_;
  Clock::time_point last_report_ = Clock::now();
  double seconds_ = 0.0;         // of finished chunks
  double particle_steps_ = 0.0;  // likewise
};

}  // namespace rgimp
