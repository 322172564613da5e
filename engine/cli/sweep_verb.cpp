#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <csignal>
#include <memory>
#include <set>

#include "case_arguments.hpp"
#include "exit_codes.hpp"
#include "interruption.hpp"
#include "messages.hpp"
#include "progress_display.hpp"
#include "rgimp/case_file.hpp"
#include "rgimp/machine.hpp"
#include "rgimp/sweep.hpp"
#include "sweep_output.hpp"
#include "terminal.hpp"
#include "verbs.hpp"

namespace rgimp::cli {

namespace {

struct SweepArguments {
  CaseArguments input;
  std::filesystem::path directory;
  ExistingOutput existing = ExistingOutput::refuse;
  std::optional<int> jobs;  // none: as many as there is room for
  ResultFormat format = ResultFormat::text;
};

/// Each warning once, however many cases have it.
void print_warnings(const Sweep& sweep) {
  std::set<std::string> printed;
  for (const SweepCase& one : sweep.cases) {
    for (const std::string& warning : check_case(one.settings)) {
      if (printed.insert(warning).second) {
        print_warning(warning);
      }
    }
  }
}

/// As many cases at once as there are threads for them.
int choose_jobs(const Sweep& sweep) {
  const int available = describe_machine().threads;
  int most = 1;
  for (const SweepCase& one : sweep.cases) {
    const int threads = one.settings.tuning.threads;
    most = std::max(most, threads == 0 ? available : threads);
  }
  const int jobs = std::max(1, available / most);
  return static_cast<int>(std::min<std::size_t>(jobs, sweep.cases.size()));
}

std::size_t count(const std::vector<SweepOutcome>& outcomes, SweepStatus status) {
  return static_cast<std::size_t>(
      std::count_if(outcomes.begin(), outcomes.end(),
                    [status](const SweepOutcome& outcome) { return outcome.status == status; }));
}

void print_outcomes(const SweepArguments& arguments, const Sweep& sweep,
                    const std::vector<SweepOutcome>& outcomes) {
  if (arguments.format == ResultFormat::json) {
    print_json(
        {{"directory", arguments.directory.string()}, {"cases", outcomes_json(sweep, outcomes)}});
    return;
  }
  fmt::print("{}\ntable           {}\n", format_outcomes(sweep, outcomes),
             (arguments.directory / "sweep.csv").string());
}

int report_end(const SweepArguments& arguments, const std::vector<SweepOutcome>& outcomes,
               std::optional<int> signal) {
  const std::size_t finished = count(outcomes, SweepStatus::finished);
  const std::size_t unfinished =
      count(outcomes, SweepStatus::stopped) + count(outcomes, SweepStatus::pending);
  if (unfinished > 0) {
    print_notice(fmt::format("{} of {} cases are not at their end; go on with --resume in '{}'",
                             unfinished, outcomes.size(), arguments.directory.string()));
    return kStoppedBySignal + signal.value_or(0);
  }
  if (finished < outcomes.size()) {
    print_error(fmt::format("{} of {} cases failed, see the table", outcomes.size() - finished,
                            outcomes.size()));
    return kPhysicsStopped;
  }
  return kDone;
}

int run_all(const SweepArguments& arguments) {
  const Interruption interruption;
  Sweep sweep = read_sweep(arguments.input.file, arguments.input.overrides);
  for (SweepCase& one : sweep.cases) {
    apply(arguments.input, one.settings);
  }
  print_warnings(sweep);
  SweepOptions options;
  options.directory = arguments.directory;
  options.existing = arguments.existing;
  options.jobs = arguments.jobs.value_or(choose_jobs(sweep));
  options.stop_requested = [&] { return interruption.signal().has_value(); };
  ProgressDisplay display;
  if (arguments.format == ResultFormat::text) {
    fmt::print("{} cases, {} at once\n", sweep.cases.size(),
               std::min<std::size_t>(options.jobs, sweep.cases.size()));
  }
  if (arguments.format == ResultFormat::text || is_terminal(stderr)) {
    options.on_progress = [&](const SweepProgress& progress) { display.show(line_of(progress)); };
  }
  options.on_notice = [&](const std::string& notice) {
    display.clear();
    print_notice(notice);
  };
  const std::vector<SweepOutcome> outcomes = run_sweep(sweep, options);
  display.clear();
  if (interruption.signal() != SIGPIPE) {  // else nobody reads them
    print_outcomes(arguments, sweep, outcomes);
  }
  return report_end(arguments, outcomes, interruption.signal());
}

void add_options(CLI::App& command, SweepArguments& arguments) {
  add_case_options(command, arguments.input);
  command.get_option("--set")->description(
      "Change a key of every case, as in rgimp run, or give it several values: "
      "KEY=START:STOP:STEP (numbers) or KEY=A|B|C; may be repeated");
  command.get_option("--threads")->description("Number of threads of each case, 1 by default");
  command
      .add_option("-o,--output", arguments.directory,
                  "Directory of the sweep: sweep.csv, and a run's output directory for each case")
      ->required()
      ->type_name("DIR");
  command
      .add_option("--jobs", arguments.jobs,
                  "Cases at once; by default as many as the machine has threads for")
      ->type_name("N")
      ->check(at_least(1));
  CLI::Option* force = command.add_flag_callback(
      "--force", [&arguments] { arguments.existing = ExistingOutput::replace; },
      "Replace the results of an earlier sweep in the directory; other files in it stay");
  command
      .add_flag_callback(
          "--resume", [&arguments] { arguments.existing = ExistingOutput::resume; },
          "Skip the cases that are finished and go on with the others from their checkpoints")
      ->excludes(force);
  command.add_flag_callback(
      "--json", [&arguments] { arguments.format = ResultFormat::json; },
      "Print the results as JSON, in SI units, and nothing else on stdout");
}

}  // namespace

void add_sweep(CLI::App& app, int& exit_code) {
  CLI::App* command =
      app.add_subcommand("sweep", "Run a case for every combination of values, several at once");
  const auto arguments = std::make_shared<SweepArguments>();
  add_options(*command, *arguments);
  command->footer(
      "Examples:\n"
      "  rgimp sweep single_flaw.toml --set 'flaw[0].angle=0:90:15' -o out/angles\n"
      "  rgimp sweep single_flaw.toml -o out/grid --set 'flaw[0].angle=30|45|60' \\\n"
      "    --set 'material.rock.failure.cohesion=5e6|6e6' --set damping.local=0.5 --jobs 4\n"
      "  rgimp sweep single_flaw.toml --set 'flaw[0].angle=0:90:15' -o out/angles --resume\n"
      "\n"
      "STOP is among the values if the steps come to it. All cases are checked before the first "
      "one\n"
      "runs. sweep.csv has a row for each, from the start on; what does not depend on time is the\n"
      "same whatever --jobs and --threads. closure_at_peak_mm is that of the highest row of\n"
      "history.csv. Status: finished, pending, stopped (by a signal, with a checkpoint), physics\n"
      "stopped or failed (its message says why). Exit code 3 if any case failed.\n"
      "\n"
      "Keys of --json: directory and cases, of which each has case, set (the values), status and\n"
      "message; with peak_axial_stress_Pa, closure_at_peak_m, first_failure (null, or step,\n"
      "closure_m, axial_stress_Pa, position_m, mode), failed_tension, failed_shear, energy_error\n"
      "and wall_s once it finished or the physics stopped it.");
  command->callback([arguments, &exit_code] { exit_code = run_all(*arguments); });
}

}  // namespace rgimp::cli
