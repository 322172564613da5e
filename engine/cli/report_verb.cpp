#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <optional>

#include "case_arguments.hpp"
#include "sibling_program.hpp"
#include "verbs.hpp"

namespace rgimp::cli {

namespace {

struct ReportArguments {
  std::filesystem::path directory;            // written by `rgimp run`
  std::optional<std::filesystem::path> page;  // none: report.html in it
};

/// Paths are made absolute: one that begins with a dash would be taken for an option.
int write_report(const ReportArguments& arguments) {
  std::vector<std::string> words{std::filesystem::absolute(arguments.directory).string()};
  if (arguments.page) {
    words.insert(words.end(), {"-o", std::filesystem::absolute(*arguments.page).string()});
  }
  return run_sibling("rgimp-report", words);
}

}  // namespace

void add_report(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand(
      "report",
      "Write one HTML page about an output directory, which needs no network: case, pictures, "
      "crack growth with a slider, curves, cracks, speed");
  const auto arguments = std::make_shared<ReportArguments>();
  add_results_option(*command, arguments->directory);
  command
      ->add_option("-o,--output", arguments->page,
                   "Where the page goes, report.html in DIR by default")
      ->type_name("FILE.html");
  command->footer(
      "Works on runs that have not ended too, and then says so.\n"
      "Examples:\n"
      "  rgimp report single_flaw\n"
      "  rgimp report single_flaw -o page.html");
  command->callback([arguments, &exit_code] { exit_code = write_report(*arguments); });
}

}  // namespace rgimp::cli
