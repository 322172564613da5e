#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <optional>

#include "case_arguments.hpp"
#include "crack_table.hpp"
#include "rgimp/results.hpp"
#include "verbs.hpp"

namespace rgimp::cli {

namespace {

struct CracksArguments {
  std::filesystem::path directory;            // written by `rgimp run`
  std::optional<std::int64_t> step;           // none: of the last snapshot
  std::optional<std::filesystem::path> json;  // none: not written
};

constexpr const char* kStdout = "-";

/// In place of the table on stdout, else beside it.
void print(const CracksArguments& arguments, const std::string& table, const std::string& json) {
  fmt::print("{}", arguments.json && *arguments.json == kStdout ? json : table);
}

void show_cracks(const CracksArguments& arguments) {
  const Results results = read_results(arguments.directory, arguments.step);
  const bool writes_file = arguments.json && *arguments.json != kStdout;
  if (results.settings.dimension == 3) {
    const CrackClusters cracks = trace_clusters(results.settings, results.particles);
    print(arguments, format_clusters(cracks), json_text(cracks));
    if (writes_file) {
      write_clusters(*arguments.json, cracks);
    }
    return;
  }
  const Cracks cracks = trace_cracks(results.settings, results.particles);
  print(arguments, format_cracks(cracks), json_text(cracks));
  if (writes_file) {
    write_cracks(*arguments.json, cracks);
  }
}

}  // namespace

void add_cracks(CLI::App& app) {
  CLI::App* command = app.add_subcommand(
      "cracks",
      "Measure the cracks of an output directory: wings, angles, order of events; in three "
      "dimensions connected cracks, their extents and areas");
  const auto arguments = std::make_shared<CracksArguments>();
  add_results_option(*command, arguments->directory);
  command
      ->add_option("--step", arguments->step,
                   "State at this step, the end by default; the last snapshot knows them all")
      ->type_name("N")
      ->check(at_least(0));
  command
      ->add_option("--json", arguments->json,
                   "Write everything, each crack's front over the steps too; - writes to stdout, "
                   "and no table")
      ->type_name("FILE");
  command->footer(
      "A tip of the n-th slot is the n-th pair of letters: A along its angle, B opposite.\n"
      "Examples:\n"
      "  rgimp cracks single_flaw\n"
      "  rgimp cracks single_flaw --step 66240 --json cracks.json\n"
      "  rgimp cracks single_flaw --json - | jq .events");
  command->callback([arguments] { show_cracks(*arguments); });
}

}  // namespace rgimp::cli
