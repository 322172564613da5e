#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "rgimp/case.hpp"

namespace rgimp {

/// Which steps of a run are written. Step 0 and the last step always are, to history and snapshots.
class OutputSchedule {
 public:
  OutputSchedule(const OutputSettings& settings, std::int64_t total_steps);

  bool writes_history(std::int64_t step) const;
  bool writes_snapshot(std::int64_t step) const;
  /// Never the last step: nothing goes on from there.
  bool writes_checkpoint(std::int64_t step) const;
  /// The first step after `step` where anything is written; the last step at most.
  std::int64_t next_stop(std::int64_t step) const;

 private:
  bool is_end(std::int64_t step) const { return step == 0 || step == total_steps_; }

  std::int64_t total_steps_;
  std::int64_t history_every_;
  std::optional<std::int64_t> snapshot_every_;
  std::optional<std::int64_t> checkpoint_every_;
  std::vector<std::int64_t> snapshot_steps_;  // ascending
};

/// How many steps to compute before looking at the clock again, so that progress can be shown at an
/// even pace whatever a step costs. Never changes what is computed.
class ChunkSize {
 public:
  /// `pace`: seconds a chunk should last.
  explicit ChunkSize(double pace) : pace_(pace) {}

  std::int64_t steps() const { return steps_; }
  /// Learns from a chunk of `steps` that lasted `seconds`.
  void learn(std::int64_t steps, double seconds);

 private:
  double pace_;
  std::int64_t steps_ = 1;
};

}  // namespace rgimp
