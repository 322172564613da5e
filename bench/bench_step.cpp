// Whole steps of the paper's first example, with everything on: failure check, damping, platens,
// drift bound. Each engine is first held against the scalar reference, then timed; the table at the
// end gives every median as a ratio to the scalar reference on one thread of the same run.

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <map>
#include <string>

#include "rgimp/case_file.hpp"
#include "rgimp/kernels/table.hpp"
#include "solver.hpp"

namespace {

using rgimp::Integrator;
using rgimp::kernels::Isa;

// Steps that share one region of Workers, as those of a run between two outputs do.
constexpr std::int64_t kStepsPerIteration = 50;

struct Setting {
  Isa isa;
  int threads;
  Integrator integrator;

  std::string name() const {
    const char* const kIntegrators[] = {"musl", "usl", "usf"};
    return std::string(rgimp::kernels::name(isa)) + "/" +
           kIntegrators[static_cast<int>(integrator)] + "/threads:" + std::to_string(threads);
  }
};

rgimp::Case example_1(Integrator integrator, double local_damping) {
  rgimp::Case settings = rgimp::read_case(RGIMP_EXAMPLES "/single_flaw.toml");
  settings.time.integrator = integrator;
  settings.local_damping = local_damping;
  return settings;
}

struct Engine {
  explicit Engine(const Setting& setting, double local_damping = 0.7)
      : settings(example_1(setting.integrator, local_damping)),
        workers(setting.threads),
        solver(settings, setting.isa, workers) {}

  void steps(std::int64_t count) {
    workers.region([&] {
      for (std::int64_t i = 0; i < count; ++i) {
        solver.step();
      }
    });
  }

  rgimp::Case settings;
  rgimp::Workers workers;
  rgimp::Solver<2> solver;
};

/// Energy and reaction after some steps equal the scalar reference's, or what differs.
std::string difference_from_reference(const Setting& setting) {
  constexpr std::int64_t kSteps = 100;
  // USL strains with the velocities of nearly empty nodes, whose forces over masses have no more
  // digits than the particle's distance from the edge of its weights.
  const double tolerance = setting.integrator == Integrator::usl ? 1e-6 : 1e-10;
  static std::map<Integrator, rgimp::HistoryRow> expected;
  // Without local damping, which turns on the sign of velocities that start as round-off.
  if (!expected.contains(setting.integrator)) {
    Engine reference({Isa::reference, 1, setting.integrator}, 0.0);
    reference.steps(kSteps);
    expected[setting.integrator] = reference.solver.history();
  }
  Engine engine(setting, 0.0);
  engine.steps(kSteps);
  const rgimp::HistoryRow got = engine.solver.history();
  const rgimp::HistoryRow& row = expected[setting.integrator];
  const double strain = std::abs(got.strain_energy / row.strain_energy - 1.0);
  const double reaction = std::abs(got.reaction / row.reaction - 1.0);
  if (strain <= tolerance && reaction <= tolerance) {
    return {};
  }
  return fmt::format(
      "differs from the scalar reference: strain energy by {:.3g}, reaction by {:.3g}", strain,
      reaction);
}

void run(benchmark::State& state, const Setting& setting) {
  const std::string difference = difference_from_reference(setting);
  if (!difference.empty()) {
    state.SkipWithError(difference.c_str());
    return;
  }
  Engine engine(setting);
  engine.steps(kStepsPerIteration);
  for (auto _ : state) {
    engine.steps(kStepsPerIteration);
  }
  const double particle_steps = static_cast<double>(engine.solver.particles().count) *
                                static_cast<double>(kStepsPerIteration * state.iterations());
  state.counters["particle_steps_per_second"] =
      benchmark::Counter(particle_steps, benchmark::Counter::kIsRate);
  state.counters["ns_per_particle_step_and_core"] =
      benchmark::Counter(particle_steps * 1e-9 / setting.threads,
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

/// Prints as usual and keeps the medians.
class Ratios : public benchmark::ConsoleReporter {
 public:
  void ReportRuns(const std::vector<Run>& runs) override {
    ConsoleReporter::ReportRuns(runs);
    for (const Run& run : runs) {
      any_error_ = any_error_ || run.error_occurred;
      if (!run.error_occurred && run.aggregate_name == "median") {
        const auto found = run.counters.find("particle_steps_per_second");
        speed_[run.run_name.function_name] = found->second;
      }
    }
  }

  bool any_error() const { return any_error_; }

  void print() const {
    std::printf("\n%-28s %24s %10s\n", "median", "M particle-steps/s", "ratio");
    for (const auto& [name, speed] : speed_) {
      const std::string integrator =
          name.substr(name.find('/') + 1, name.rfind('/') - name.find('/') - 1);
      const auto reference = speed_.find("reference/" + integrator + "/threads:1");
      std::printf("%-28s %24.1f", name.c_str(), speed * 1e-6);
      if (reference != speed_.end()) {
        std::printf(" %10.2f", speed / reference->second);
      }
      std::printf("\n");
    }
  }

 private:
  std::map<std::string, double> speed_;
  bool any_error_ = false;
};

void add_benchmarks() {
  for (const Integrator integrator : {Integrator::musl, Integrator::usl, Integrator::usf}) {
    for (const Isa isa : rgimp::kernels::kAllIsas) {
      for (const int threads : {1, 2}) {
        const Setting setting{isa, threads, integrator};
        if (rgimp::kernels::available(isa) && (isa != Isa::reference || threads == 1)) {
          benchmark::RegisterBenchmark(setting.name().c_str(), run, setting)
              ->UseRealTime()
              ->Unit(benchmark::kMillisecond)
              ->Repetitions(5)
              ->ReportAggregatesOnly(true)
              ->MinTime(0.2);
        }
      }
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) {
    return 2;
  }
  add_benchmarks();
  Ratios ratios;
  benchmark::RunSpecifiedBenchmarks(&ratios);
  ratios.print();
  return ratios.any_error() ? 1 : 0;
}
