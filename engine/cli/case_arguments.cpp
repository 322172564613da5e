#include "case_arguments.hpp"

#include <charconv>
#include <system_error>

#include "messages.hpp"
#include "rgimp/case_file.hpp"

namespace rgimp::cli {

namespace {

/// Snapshots listed past the new end go: a short trial of a long case is no error.
void set_steps(Case& settings, std::int64_t steps) {
  settings.time.steps = steps;
  settings.time.duration.reset();
  std::erase_if(settings.output.snapshot_steps,
                [steps](std::int64_t step) { return step > steps; });
}

}  // namespace

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

void add_results_option(CLI::App& command, std::filesystem::path& directory) {
  command.add_option("DIR", directory, "Written by rgimp run")->required()->type_name("DIR");
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

void apply(const CaseArguments& arguments, Case& settings) {
  if (arguments.steps) {
    set_steps(settings, *arguments.steps);
  }
  if (arguments.threads) {
    settings.tuning.threads = *arguments.threads;
  }
}

Case load_case(const CaseArguments& arguments) {
  Case settings = read_case(arguments.file, arguments.overrides);
  apply(arguments, settings);
  for (const std::string& warning : check_case(settings)) {
    print_warning(warning);
  }
  return settings;
}

}  // namespace rgimp::cli
