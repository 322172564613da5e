#include <malloc.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <new>
#include <string>

#include "exit_codes.hpp"
#include "messages.hpp"
#include "rgimp/error.hpp"
#include "rgimp/version.hpp"
#include "verbs.hpp"

/// The `rgimp` command: a thin client of the library.
namespace {

using namespace rgimp::cli;

void describe_app(CLI::App& app) {
  app.set_version_flag("--version", "rgimp " + std::string(rgimp::version()));
  app.require_subcommand(0, 1);
  app.footer(
      "Examples:\n"
      "  rgimp new single-flaw             a commented case file, single_flaw.toml\n"
      "  rgimp check single_flaw.toml      what a run would take\n"
      "  rgimp run single_flaw.toml        run it; results in single_flaw/\n"
      "  rgimp cracks single_flaw          its cracks in numbers\n"
      "  rgimp grid single_flaw            stresses on the nodes of the grid, for contours\n"
      "  rgimp sweep single_flaw.toml --set 'flaw[0].angle=0:90:15' -o angles\n"
      "                                    seven angles, as many at once as there are threads\n"
      "  rgimp-plot single_flaw            pictures of the results\n"
      "  rgimp report single_flaw          a page about them\n"
      "  rgimp run --help                  options of a subcommand\n"
      "\n"
      "Exit codes: 0 done, 2 wrong command line or case, 3 the physics stopped the run or a case "
      "of\n"
      "a sweep failed, 4 a file or directory could not be read or written, 128 and more stopped by "
      "a\n"
      "signal (130 Ctrl-C), 1 anything unexpected.\n"
      "Errors and warnings go to stderr, in colours on a terminal unless NO_COLOR is set.\n"
      "RGIMP_ISA chooses the instruction set (see rgimp info).");
}

/// CLI11 runs the verb while it parses.
int parse_and_run(int argc, char** argv) {
  CLI::App app("Simulates rock fracture with the generalized interpolation material point method.",
               "rgimp");
  describe_app(app);
  int exit_code = kDone;
  add_new(app);
  add_run(app, exit_code);
  add_check(app, exit_code);
  add_sweep(app, exit_code);
  add_cracks(app);
  add_grid(app);
  add_report(app, exit_code);
  add_info(app);
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
