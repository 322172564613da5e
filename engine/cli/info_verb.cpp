#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "facts.hpp"
#include "json_output.hpp"
#include "rgimp/machine.hpp"
#include "rgimp/version.hpp"
#include "verbs.hpp"

namespace rgimp::cli {

namespace {

void info(ResultFormat format) {
  const Machine machine = describe_machine();
  if (format == ResultFormat::json) {
    print_json({{"version", version()},
                {"isa", machine.isa},
                {"isas", machine.isas},
                {"threads", machine.threads}});
    return;
  }
  print_line("version", version());
  print_line("instructions", machine.isa);
  print_line("threads", fmt::format("{}", machine.threads));
  print_line("RGIMP_ISA", fmt::format("unset, or one of: {}", fmt::join(machine.isas, ", ")));
}

}  // namespace

void add_info(CLI::App& app) {
  CLI::App* command =
      app.add_subcommand("info", "Version, instruction set and threads of this build and machine");
  const auto format = std::make_shared<ResultFormat>(ResultFormat::text);
  command->add_flag_callback(
      "--json", [format] { *format = ResultFormat::json; },
      "Print JSON: version, isa (in use), isas (that RGIMP_ISA may name), threads");
  command->footer(
      "Examples:\n"
      "  rgimp info\n"
      "  RGIMP_ISA=baseline rgimp info --json");
  command->callback([format] { info(*format); });
}

}  // namespace rgimp::cli
