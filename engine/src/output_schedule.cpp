#include "output_schedule.hpp"

#include <algorithm>

namespace rgimp {

namespace {

std::int64_t next_multiple(std::int64_t step, std::int64_t every) {
  return (step / every + 1) * every;
}

}  // namespace

OutputSchedule::OutputSchedule(const OutputSettings& settings, std::int64_t total_steps)
    : total_steps_(total_steps),
      history_every_(settings.history_every),
      snapshot_every_(settings.snapshot_every),
      checkpoint_every_(settings.checkpoint_every),
      snapshot_steps_(settings.snapshot_steps) {
  std::erase_if(snapshot_steps_, [total_steps](std::int64_t step) { return step > total_steps; });
  std::sort(snapshot_steps_.begin(), snapshot_steps_.end());
}

bool OutputSchedule::writes_history(std::int64_t step) const {
  return is_end(step) || step % history_every_ == 0;
}

bool OutputSchedule::writes_snapshot(std::int64_t step) const {
  return is_end(step) || (snapshot_every_ && step % *snapshot_every_ == 0) ||
         std::binary_search(snapshot_steps_.begin(), snapshot_steps_.end(), step);
}

bool OutputSchedule::writes_checkpoint(std::int64_t step) const {
  return checkpoint_every_ && !is_end(step) && step % *checkpoint_every_ == 0;
}

std::int64_t OutputSchedule::next_stop(std::int64_t step) const {
  std::int64_t stop = std::min(total_steps_, next_multiple(step, history_every_));
  if (snapshot_every_) {
    stop = std::min(stop, next_multiple(step, *snapshot_every_));
  }
  if (checkpoint_every_) {
    stop = std::min(stop, next_multiple(step, *checkpoint_every_));
  }
  const auto listed = std::upper_bound(snapshot_steps_.begin(), snapshot_steps_.end(), step);
  return listed == snapshot_steps_.end() ? stop : std::min(stop, *listed);
}

void ChunkSize::learn(std::int64_t steps, double seconds) {
  // Tenfold at most: a first step is no fair sample, and a clock may tick coarsely.
  const double most = 10.0 * static_cast<double>(steps);
  const double wanted = seconds > 0.0 ? pace_ * static_cast<double>(steps) / seconds : most;
  steps_ = std::max<std::int64_t>(1, static_cast<std::int64_t>(std::min(wanted, most)));
}

}  // namespace rgimp
