#include <malloc.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <new>
#include <string>
#include <system_error>

#include "commands.hpp"
#include "messages.hpp"
#include "rgimp/error.hpp"
#include "rgimp/simulation.hpp"

/// The `rgimp` command: a thin client of the library.
namespace {

using namespace rgimp::cli;

enum ExitCode {
  kDone = 0,
  kUnexpected = 1,
  kWrongRequest = 2,
  kPhysicsStopped = 3,
  kFileTrouble = 4
};

CLI::Validator at_least(std::int64_t least) {
  const auto complaint = [least](const std::string& text) -> std::string {
    std::int64_t number = 0;
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, number);
    if (error == std::errc() && stop == end && number >= least) {
      return {};
    }
    return "'" + text + "' is not a whole number from " + std::to_string(least) + " up";
  };
  return {complaint, ""};
}

void add_case_options(CLI::App& command, CaseArguments& arguments) {
  command.add_option("CASE", arguments.file, "Case file (TOML)")
      ->required()
      ->type_name("FILE.toml");
  command
      .add_option("--set", arguments.overrides,
                  "Change a key of the case: a dotted key and a TOML value (a bare word is a "
                  "string); may be repeated")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
  command.add_option("--steps", arguments.steps, "Total number of steps, whatever the case says")
      ->type_name("N")
      ->check(at_least(1));
  command.add_option("--threads", arguments.threads, "Number of threads, 0 for all there are")
      ->type_name("N")
      ->check(at_least(0));
}

void add_run(CLI::App& app, RunArguments& arguments, int& exit_code) {
  CLI::App* command = app.add_subcommand("run", "Run a case and write its output directory");
  add_case_options(*command, arguments.input);
  command
      ->add_option("-o,--output", arguments.directory,
                   "Output directory, the case file's name without its ending by default")
      ->type_name("DIR");
  CLI::Option* force = command->add_flag_callback(
      "--force", [&arguments] { arguments.existing = rgimp::ExistingOutput::replace; },
      "Replace the results in an output directory that is not empty; other files in it stay");
  command
      ->add_flag_callback(
          "--resume", [&arguments] { arguments.existing = rgimp::ExistingOutput::resume; },
          "Go on from the newest checkpoint in the output directory; from step 0 if there is none")
      ->excludes(force);
  command->add_flag_callback(
      "--quiet", [&arguments] { arguments.verbosity = Verbosity::quiet; },
      "Show no progress and no results; errors and warnings still go to stderr");
  command->footer(
      "Examples:\n"
      "  rgimp run single_flaw.toml\n"
      "  rgimp run single_flaw.toml -o out/fine --set grid.cell_size=0.25e-3 --threads 8\n"
      "  rgimp run single_flaw.toml --force --set time.integrator=usl --steps 1000\n"
      "  rgimp run single_flaw.toml --resume\n"
      "\n"
      "Ctrl-C (SIGINT), SIGTERM, SIGHUP and SIGPIPE end a run with a checkpoint; --resume goes on\n"
      "from there. Threads, output, grid.on_exit and the number of steps may have changed "
      "meanwhile;\n"
      "what was written before stays as it was.");
  command->callback([&arguments, &exit_code] { exit_code = run(arguments); });
}

void add_check(CLI::App& app, CaseArguments& arguments) {
  CLI::App* command = app.add_subcommand(
      "check", "Read a case, try a few steps in memory and say what a run would take");
  add_case_options(*command, arguments);
  command->footer(
      "Examples:\n"
      "  rgimp check single_flaw.toml\n"
      "  rgimp check single_flaw.toml --set grid.cell_size=0.25e-3 --threads 8");
  command->callback([&arguments] { check(arguments); });
}

void add_cracks(CLI::App& app, CracksArguments& arguments) {
  CLI::App* command = app.add_subcommand(
      "cracks",
      "Measure the cracks of an output directory: wings, angles, order of events; in three "
      "dimensions connected cracks, their extents and areas");
  command->add_option("DIR", arguments.directory, "Written by rgimp run")
      ->required()
      ->type_name("DIR");
  command
      ->add_option("--step", arguments.step,
                   "State at this step, the end by default; the last snapshot knows them all")
      ->type_name("N")
      ->check(at_least(0));
  command
      ->add_option("--json", arguments.json,
                   "Write everything, each crack's front over the steps too")
      ->type_name("FILE");
  command->footer(
      "A tip of the n-th slot is the n-th pair of letters: A along its angle, B opposite.\n"
      "Examples:\n"
      "  rgimp cracks single_flaw\n"
      "  rgimp cracks single_flaw --step 66240 --json cracks.json");
  command->callback([&arguments] { show_cracks(arguments); });
}

void describe_app(CLI::App& app) {
  app.set_version_flag("--version", "rgimp " + std::string(rgimp::version()));
  app.require_subcommand(0, 1);
  app.footer(
      "Examples:\n"
      "  rgimp check single_flaw.toml      what a run would take\n"
      "  rgimp run single_flaw.toml        run it; results in single_flaw/\n"
      "  rgimp cracks single_flaw          its cracks in numbers\n"
      "  rgimp-plot single_flaw            pictures of the results\n"
      "  rgimp run --help                  options of a subcommand\n"
      "\n"
      "Exit codes: 0 done, 2 wrong command line or case, 3 the physics stopped the run,\n"
      "4 a file or directory could not be read or written, 128 and more stopped by a signal (130\n"
      "Ctrl-C), 1 anything unexpected.\n"
      "RGIMP_ISA chooses the instruction set (see rgimp info).");
}

/// CLI11 runs the subcommand while it parses.
int parse_and_run(int argc, char** argv) {
  CLI::App app("Simulates rock fracture with the generalized interpolation material point method.",
               "rgimp");
  describe_app(app);
  RunArguments run_arguments;
  int exit_code = kDone;
  add_run(app, run_arguments, exit_code);
  CaseArguments check_arguments;
  add_check(app, check_arguments);
  CracksArguments cracks_arguments;
  add_cracks(app, cracks_arguments);
  app.add_subcommand("info", "Version, instruction set and threads of this build and machine")
      ->callback(info);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& request) {  // --help, --version
    return app.exit(request);
  } catch (const CLI::ParseError& error) {
    print_error(std::string(error.what()) + " (rgimp --help says more)");
    return kWrongRequest;
  }
  if (app.get_subcommands().empty()) {
    std::fputs(app.help().c_str(), stderr);
    return kWrongRequest;
  }
  return exit_code;
}

}  // namespace

int main(int argc, char** argv) {
  // Large blocks go back to the system when they are freed. glibc would keep those below 32 MiB
  // once one was freed: 8 % more memory at 2 million particles.
  mallopt(M_MMAP_THRESHOLD, 4 << 20);
  try {
    return parse_and_run(argc, argv);
  } catch (const rgimp::CaseError& error) {
    print_error(error.what());
    return kWrongRequest;
  } catch (const rgimp::PhysicsError& error) {
    print_error(error.what());
    return kPhysicsStopped;
  } catch (const rgimp::FileError& error) {
    print_error(error.what());
    return kFileTrouble;
  } catch (const std::bad_alloc&) {
    print_error("not enough memory: coarsen the grid, or use a machine with more");
  } catch (const std::exception& error) {
    print_error(std::string("unexpected: ") + error.what());
  }
  return kUnexpected;
}
