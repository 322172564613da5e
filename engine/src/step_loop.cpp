#include "step_loop.hpp"

#include <algorithm>

namespace rgimp {

namespace {

constexpr double kPace = 0.2;  // s between two calls of on_progress

}  // namespace

StepLoop::StepLoop(Simulation& simulation, const RunOptions& options)
    : simulation_(simulation),
      options_(options),
      facts_(simulation.facts()),
      first_step_(simulation.steps_done()),
      chunk_(kPace) {}

void StepLoop::advance(std::int64_t stop) {
  const std::int64_t start = simulation_.steps_done();
  const Clock::time_point begin = Clock::now();
  simulation_.run_until(std::min(stop, start + chunk_.steps()));
  const Clock::time_point end = Clock::now();
  const double seconds = std::chrono::duration<double>(end - begin).count();
  const std::int64_t steps = simulation_.steps_done() - start;
  seconds_ += seconds;
  // Particles may leave on the way: those at the end of the chunk count.
  particle_steps_ +=
      static_cast<double>(steps) * static_cast<double>(simulation_.facts().particles);
  chunk_.learn(steps, seconds);
  if (std::chrono::duration<double>(end - last_report_).count() >= kPace) {
    report();
  }
}

void StepLoop::report() {
  last_report_ = Clock::now();
  if (!options_.on_progress) {
    return;
  }
  const HistoryRow row = simulation_.history();
  options_.on_progress({row.step, first_step_, facts_.total_steps, facts_.particles, seconds_,
                        row.failed_tension + row.failed_shear});
}

double StepLoop::particle_steps_per_second() const {
  return seconds_ > 0.0 ? particle_steps_ / seconds_ : 0.0;
}

}  // namespace rgimp
