#include "step_timing.hpp"

#include <algorithm>
#include <cstdint>

#include "engine.hpp"
#include "rgimp/error.hpp"
#include "traffic.hpp"
#include "verify.hpp"

namespace rgimp::bench {
namespace {

/// About 4 million particle-steps: a good 10 ms on the fastest machines, so that entering a region
/// of Workers costs nothing.
std::int64_t steps_per_iteration(std::size_t particles) {
  constexpr std::int64_t kParticleSteps = 4'000'000;
  return std::max<std::int64_t>(kParticleSteps / static_cast<std::int64_t>(particles), 1);
}

template <int Dim>
void count(benchmark::State& state, Engine<Dim>& engine, const Setting& setting,
           double particle_steps) {
  using benchmark::Counter;
  const auto particles = static_cast<double>(engine.particles());
  const double lanes = static_cast<double>(engine.lanes()) / particles;
  state.counters["particles"] = particles;
  state.counters["lanes_per_particle"] = lanes;
  state.counters["bytes_per_particle"] = static_cast<double>(engine.memory_bytes()) / particles;
  state.counters["startup_seconds"] = engine.startup_seconds();
  state.counters["particle_steps_per_second"] = Counter(particle_steps, Counter::kIsRate);
  state.counters["ns_per_particle_step_and_core"] =
      Counter(particle_steps * 1e-9 / setting.threads, Counter::kIsRate | Counter::kInvert);
  state.counters["model_bytes_per_second"] =
      Counter(particle_steps * lanes * bytes_of_step<Dim>(setting.integrator), Counter::kIsRate);
}

template <int Dim>
void time_steps(benchmark::State& state, Engine<Dim>& engine, const Setting& setting) {
  const std::int64_t steps = steps_per_iteration(engine.particles());
  engine.steps(steps);
  for ([[maybe_unused]] auto _ : state) {
    engine.steps(steps);
  }
  const HistoryRow row = engine.history();
  if (row.failed_tension + row.failed_shear > 0) {
    state.SkipWithError("particles failed: not the state that other settings are timed in");
    return;
  }
  count(state, engine, setting,
        static_cast<double>(engine.particles()) * static_cast<double>(steps * state.iterations()));
}

void verify_and_time(benchmark::State& state, const Setting& setting) {
  const std::string& difference = difference_from_reference(setting);
  if (!difference.empty()) {
    state.SkipWithError(difference.c_str());
    return;
  }
  try {
    with_engine(setting, case_of(setting),
                [&](auto& engine) { time_steps(state, engine, setting); });
  } catch (const Error& error) {
    state.SkipWithError(error.what());
  }
}

}  // namespace

void add_step_benchmark(const char* prefix, const Setting& setting) {
  const std::string full_name = std::string(prefix) + "/" + name(setting);
  benchmark::RegisterBenchmark(full_name.c_str(), verify_and_time, setting)
      ->UseRealTime()
      ->Unit(benchmark::kMillisecond);
}

}  // namespace rgimp::bench
