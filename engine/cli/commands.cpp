#include "commands.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <utility>

#include "crack_table.hpp"
#include "format.hpp"
#include "interruption.hpp"
#include "messages.hpp"
#include "progress_display.hpp"
#include "rgimp/rgimp.hpp"

namespace rgimp::cli {

namespace {

constexpr int kStoppedBySignal = 128;  // plus the signal's number, as shells have it

/// Snapshots listed past the new end go: a short trial of a long case is no error.
void set_steps(Case& settings, std::int64_t steps) {
  settings.time.steps = steps;
  settings.time.duration.reset();
  std::erase_if(settings.output.snapshot_steps,
                [steps](std::int64_t step) { return step > steps; });
}

Case load(const CaseArguments& arguments) {
  Case settings = read_case(arguments.file, arguments.overrides);
  if (arguments.steps) {
    set_steps(settings, *arguments.steps);
  }
  if (arguments.threads) {
    settings.tuning.threads = *arguments.threads;
  }
  for (const std::string& warning : check_case(settings)) {
    print_warning(warning);
  }
  return settings;
}

std::string describe(const FirstFailure& failure) {
  const Vector& at = failure.position;
  return fmt::format("step {} at ({:.6g}, {:.6g}, {:.6g}) m in {}, closure {:.4g} m",
                     with_separators(failure.step), at.x(), at.y(), at.z(),
                     failure.mode == FailureMode::tension ? "tension" : "shear", failure.closure);
}

std::string describe(const RemovedParticles& removed) {
  return fmt::format("{} that left the grid, {:.4g} kg, {:.4g} J",
                     with_separators(removed.particles), removed.mass, removed.energy);
}

void print_line(std::string_view name, std::string_view value) {
  fmt::print("{:<15} {}\n", name, printable(value));
}

std::string describe_speed(double particle_steps_per_second) {
  return fmt::format("{:.1f} M particle-steps/s", particle_steps_per_second * 1e-6);
}

/// "P2G 40 %, nodes 5 %", of the time in steps.
std::string describe(const std::vector<StageTime>& stages) {
  double total = 0.0;
  for (const StageTime& stage : stages) {
    total += stage.seconds;
  }
  std::string text;
  for (const StageTime& stage : stages) {
    if (stage.seconds > 0.0) {
      text += fmt::format("{}{} {:.0f} %", text.empty() ? "" : ", ", stage.name,
                          100.0 * stage.seconds / total);
    }
  }
  return text;
}

void print_results(const Simulation& simulation, const Progress& progress,
                   const std::filesystem::path& directory) {
  const HistoryRow row = simulation.history();
  const auto failure = simulation.first_failure();
  print_line("results", directory.string());
  print_line("steps", fmt::format("{}, {:.4g} s simulated", with_separators(row.step), row.time));
  print_line("first failure", failure ? describe(*failure) : "none");
  print_line("failed",
             fmt::format("{} in tension, {} in shear", with_separators(row.failed_tension),
                         with_separators(row.failed_shear)));
  if (simulation.removed().particles > 0) {
    print_line("removed", describe(simulation.removed()));
  }
  if (progress.seconds > 0.0) {
    const double work = static_cast<double>(progress.particles) *
                        static_cast<double>(row.step - progress.first_step);
    print_line("speed", fmt::format("{} in {}", describe_speed(work / progress.seconds),
                                    format_duration(progress.seconds)));
    print_line("of that", describe(simulation.stage_times()));
  }
  print_line("pictures", fmt::format("rgimp-plot {}", directory.string()));
}

/// Seconds a step takes, from running for about a third of a second.
double time_steps(Simulation& simulation) {
  using Clock = std::chrono::steady_clock;
  constexpr std::chrono::duration<double> span{0.3};
  constexpr std::int64_t many = 8;
  const std::int64_t total = simulation.facts().total_steps;
  Clock::time_point start = Clock::now();
  simulation.run_until(std::min<std::int64_t>(total, 1));  // touches all memory: no fair sample
  std::chrono::duration<double> elapsed = Clock::now() - start;
  const std::int64_t chunk = elapsed < span / many ? many : 1;
  const std::int64_t first = simulation.steps_done();
  start = Clock::now();
  elapsed = {};
  while (elapsed < span && simulation.steps_done() < total) {
    simulation.run_until(std::min(total, simulation.steps_done() + chunk));
    elapsed = Clock::now() - start;
  }
  return elapsed.count() /
         static_cast<double>(std::max<std::int64_t>(1, simulation.steps_done() - first));
}

RunEnd run_to_end(Simulation& simulation, const RunOptions& options) {
  try {
    return run_case(simulation, options);
  } catch (const PhysicsError& error) {
    throw PhysicsError(fmt::format("{} (see '{}' for the results up to step {})", error.what(),
                                   options.directory.string(), simulation.steps_done()),
                       error.report());
  }
}

std::string describe_grid(const Facts& facts, const Case& settings) {
  const auto& nodes = facts.nodes;
  const std::string depth = settings.dimension == 3 ? fmt::format(" x {}", nodes[2]) : "";
  return fmt::format("{} x {}{} nodes, cell size {:g} m", nodes[0], nodes[1], depth,
                     settings.grid.cell_size);
}

/// What the case is, before any of it is run.
void print_facts(const Simulation& simulation, const std::filesystem::path& file) {
  const Facts facts = simulation.facts();
  const Case& settings = simulation.settings();
  print_line("case", settings.title.empty() ? file.string() : settings.title);
  print_line("particles", with_separators(static_cast<std::int64_t>(facts.particles)));
  print_line("grid", describe_grid(facts, settings));
  print_line("time step", fmt::format("{:.6g} s, {:.4f} of the critical step (dt/dt_cr)", facts.dt,
                                      simulation.critical_step_ratio()));
  print_line("steps", fmt::format("{}, {:.4g} s simulated", with_separators(facts.total_steps),
                                  static_cast<double>(facts.total_steps) * facts.dt));
  print_line("memory",
             fmt::format("{}, at most {} (in a snapshot)", format_bytes(facts.memory_bytes),
                         format_bytes(facts.peak_memory_bytes)));
  print_line("machine", fmt::format("{}, {} threads", facts.isa, facts.threads));
  std::fflush(stdout);  // for the physics may stop the steps
}

}  // namespace

int run(const RunArguments& arguments) {
  const Interruption interruption;
  RunOptions options;
  options.directory = arguments.directory.value_or(arguments.input.file.stem());
  options.existing = arguments.existing;
  options.stop_requested = [&] { return interruption.signal().has_value(); };
  Simulation simulation(load(arguments.input));
  const bool quiet = arguments.verbosity == Verbosity::quiet;
  if (!quiet) {
    print_facts(simulation, arguments.input.file);
  }
  ProgressDisplay display;
  Progress latest;
  options.on_progress = [&](const Progress& progress) {
    latest = progress;
    if (!quiet) {
      display.show(progress);
    }
  };
  options.on_notice = [&](const std::string& notice) {
    display.clear();
    print_notice(notice);
  };
  const RunEnd end = run_to_end(simulation, options);
  display.clear();
  if (end == RunEnd::stopped) {
    print_notice(fmt::format("stopped at step {} with a checkpoint in '{}'; go on with --resume",
                             with_separators(simulation.steps_done()), options.directory.string()));
    return kStoppedBySignal + interruption.signal().value_or(0);
  }
  if (simulation.removed().particles > 0) {
    print_warning(
        fmt::format("particles were taken out (grid.on_exit): {}", describe(simulation.removed())));
  }
  if (end == RunEnd::finished && !quiet) {
    print_results(simulation, latest, options.directory);
  }
  return 0;
}

void check(const CaseArguments& arguments) {
  Simulation simulation(load(arguments));
  print_facts(simulation, arguments.file);
  const Facts facts = simulation.facts();
  const double step_seconds = time_steps(simulation);
  if (step_seconds > 0.0) {
    print_line("speed", describe_speed(static_cast<double>(facts.particles) / step_seconds));
    print_line("estimated time",
               format_duration(static_cast<double>(facts.total_steps) * step_seconds));
  }
}

void show_cracks(const CracksArguments& arguments) {
  const Results results = read_results(arguments.directory, arguments.step);
  if (results.settings.dimension == 3) {
    const CrackClusters cracks = trace_clusters(results.settings, results.particles);
    fmt::print("{}", format_clusters(cracks));
    if (arguments.json) {
      write_clusters(*arguments.json, cracks);
    }
    return;
  }
  const Cracks cracks = trace_cracks(results.settings, results.particles);
  fmt::print("{}", format_cracks(cracks));
  if (arguments.json) {
    write_cracks(*arguments.json, cracks);
  }
}

void info() {
  const Machine machine = describe_machine();
  print_line("version", version());
  print_line("instructions", machine.isa);
  print_line("threads", fmt::format("{}", machine.threads));
  print_line("RGIMP_ISA", fmt::format("unset, or one of: {}", fmt::join(machine.isas, ", ")));
}

}  // namespace rgimp::cli
