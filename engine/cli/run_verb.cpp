#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <fstream>
#include <memory>
#include <sstream>

#include "case_arguments.hpp"
#include "exit_codes.hpp"
#include "facts.hpp"
#include "format.hpp"
#include "interruption.hpp"
#include "json_output.hpp"
#include "messages.hpp"
#include "progress_display.hpp"
#include "rgimp/error.hpp"
#include "rgimp/run.hpp"
#include "terminal.hpp"
#include "verbs.hpp"

namespace rgimp::cli {

namespace {

enum class Verbosity { quiet, normal };

struct RunArguments {
  CaseArguments input;
  std::optional<std::filesystem::path> directory;  // none: named after the case file
  ExistingOutput existing = ExistingOutput::refuse;
  Verbosity verbosity = Verbosity::normal;
  ResultFormat format = ResultFormat::text;
};

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

/// Nothing where a run came to no end, stopped by a signal.
void print_summary(const std::filesystem::path& directory) {
  std::ifstream file(directory / "summary.json");
  std::ostringstream text;
  if (file && text << file.rdbuf()) {
    fmt::print("{}", text.str());
  }
}

RunEnd run_to_end(Simulation& simulation, const RunOptions& options, ResultFormat format) {
  try {
    const RunEnd end = run_case(simulation, options);
    if (format == ResultFormat::json && end != RunEnd::stopped) {
      print_summary(options.directory);
    }
    return end;
  } catch (const PhysicsError& error) {
    if (format == ResultFormat::json) {
      print_summary(options.directory);
    }
    throw PhysicsError(fmt::format("{} (see '{}' for the results up to step {})", error.what(),
                                   options.directory.string(), simulation.steps_done()),
                       error.report());
  }
}

int run(const RunArguments& arguments) {
  const Interruption interruption;
  RunOptions options;
  options.directory = arguments.directory.value_or(arguments.input.file.stem());
  options.existing = arguments.existing;
  options.stop_requested = [&] { return interruption.signal().has_value(); };
  Simulation simulation(load_case(arguments.input));
  const bool prints = arguments.verbosity == Verbosity::normal;
  const bool prints_text = prints && arguments.format == ResultFormat::text;
  if (prints_text) {
    print_facts(simulation, arguments.input.file);
  }
  const bool shows_progress = prints_text || (prints && is_terminal(stderr));
  ProgressDisplay display;
  Progress latest;
  options.on_progress = [&](const Progress& progress) {
    latest = progress;
    if (shows_progress) {
      display.show(line_of(progress));
    }
  };
  options.on_notice = [&](const std::string& notice) {
    display.clear();
    print_notice(notice);
  };
  const RunEnd end = run_to_end(simulation, options, arguments.format);
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
  if (end == RunEnd::finished && prints_text) {
    print_results(simulation, latest, options.directory);
  }
  return kDone;
}

void add_output_options(CLI::App& command, RunArguments& arguments) {
  command
      .add_option("-o,--output", arguments.directory,
                  "Output directory, the case file's name without its ending by default")
      ->type_name("DIR");
  CLI::Option* force = command.add_flag_callback(
      "--force", [&arguments] { arguments.existing = ExistingOutput::replace; },
      "Replace the results in an output directory that is not empty; other files in it stay");
  command
      .add_flag_callback(
          "--resume", [&arguments] { arguments.existing = ExistingOutput::resume; },
          "Go on from the newest checkpoint in the output directory; from step 0 if there is none")
      ->excludes(force);
  command.add_flag_callback(
      "--quiet", [&arguments] { arguments.verbosity = Verbosity::quiet; },
      "Show no progress and no results; errors and warnings still go to stderr");
  command.add_flag_callback(
      "--json", [&arguments] { arguments.format = ResultFormat::json; },
      "Print the summary, summary.json, at the end and nothing else on stdout");
}

}  // namespace

void add_run(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("run", "Run a case and write its output directory");
  const auto arguments = std::make_shared<RunArguments>();
  add_case_options(*command, arguments->input);
  add_output_options(*command, *arguments);
  command->footer(
      "Examples:\n"
      "  rgimp run single_flaw.toml\n"
      "  rgimp run single_flaw.toml -o out/fine --set grid.cell_size=0.25e-3 --threads 8\n"
      "  rgimp run single_flaw.toml --force --set time.integrator=usl --steps 1000\n"
      "  rgimp run single_flaw.toml --resume\n"
      "  rgimp run single_flaw.toml --json | jq .peak_axial_stress_Pa\n"
      "\n"
      "Ctrl-C (SIGINT), SIGTERM, SIGHUP and SIGPIPE end a run with a checkpoint; --resume goes on\n"
      "from there. Threads, output, grid.on_exit and the number of steps may have changed "
      "meanwhile;\n"
      "what was written before stays as it was.");
  command->callback([arguments, &exit_code] { exit_code = run(*arguments); });
}

}  // namespace rgimp::cli
