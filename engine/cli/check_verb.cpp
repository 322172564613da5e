#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <memory>

#include "case_arguments.hpp"
#include "exit_codes.hpp"
#include "facts.hpp"
#include "format.hpp"
#include "json_output.hpp"
#include "rgimp/case_file.hpp"
#include "rgimp/specimen.hpp"
#include "sibling_program.hpp"
#include "temporary_directory.hpp"
#include "verbs.hpp"

namespace rgimp::cli {

namespace {

struct CheckArguments {
  CaseArguments input;
  std::optional<std::filesystem::path> picture;  // none: not drawn
  ResultFormat format = ResultFormat::text;
};

CLI::Validator ends_with_png() {
  return {[](const std::string& text) {
            return text.ends_with(".png") ? "" : "'" + text + "' does not end in .png";
          },
          ""};
}

/// Has rgimp-plot draw the specimen as it is now. Gives its exit code.
int draw_specimen(const Simulation& simulation, const std::filesystem::path& picture) {
  const TemporaryDirectory scratch;
  write_specimen(simulation, scratch.path());
  return run_sibling("rgimp-plot", {scratch.path().string(), "--specimen", picture.string()});
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

Json facts_json(const Simulation& simulation, const std::filesystem::path& file) {
  const Facts facts = simulation.facts();
  const Case& settings = simulation.settings();
  return {{"file", file.string()},
          {"title", settings.title},
          {"dimension", settings.dimension},
          {"particles", facts.particles},
          {"nodes", facts.nodes},
          {"cell_size_m", settings.grid.cell_size},
          {"dt_s", facts.dt},
          {"critical_step_ratio", simulation.critical_step_ratio()},
          {"steps", facts.total_steps},
          {"time_s", static_cast<double>(facts.total_steps) * facts.dt},
          {"memory_bytes", facts.memory_bytes},
          {"peak_memory_bytes", facts.peak_memory_bytes},
          {"isa", facts.isa},
          {"threads", facts.threads},
          {"warnings", check_case(settings)}};
}

/// How long a run would take, from trying some steps.
void estimate_time(Simulation& simulation, const CheckArguments& arguments) {
  const Facts facts = simulation.facts();
  Json json = facts_json(simulation, arguments.input.file);  // before the first step
  const double step_seconds = time_steps(simulation);
  const double speed = static_cast<double>(facts.particles) / step_seconds;
  const double seconds = static_cast<double>(facts.total_steps) * step_seconds;
  if (arguments.format == ResultFormat::json) {
    json["particle_steps_per_second"] = speed;  // null where it took no time that can be measured
    json["estimated_wall_s"] = seconds;
    print_json(json);
  } else if (step_seconds > 0.0) {
    print_line("speed", describe_speed(speed));
    print_line("estimated time", format_duration(seconds));
  }
}

/// Gives rgimp-plot's exit code where there is a picture to draw, which comes before any step.
int check(const CheckArguments& arguments) {
  Simulation simulation(load_case(arguments.input));
  const bool prints_text = arguments.format == ResultFormat::text;
  if (prints_text) {
    print_facts(simulation, arguments.input.file);
  }
  if (arguments.picture) {
    const int code = draw_specimen(simulation, *arguments.picture);
    if (code != kDone) {
      return code;
    }
    if (prints_text) {
      print_line("picture", arguments.picture->string());
    }
  }
  estimate_time(simulation, arguments);
  return kDone;
}

}  // namespace

void add_check(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand(
      "check", "Read a case, try a few steps in memory and say what a run would take");
  const auto arguments = std::make_shared<CheckArguments>();
  add_case_options(*command, arguments->input);
  command
      ->add_option("--picture", arguments->picture,
                   "Draw the specimen before any step: particles, flaws, platens, grid")
      ->type_name("FILE.png")
      ->check(ends_with_png());
  command->add_flag_callback(
      "--json", [arguments] { arguments->format = ResultFormat::json; },
      "Print the figures as JSON, in SI units, and nothing else on stdout");
  command->footer(
      "Examples:\n"
      "  rgimp check single_flaw.toml\n"
      "  rgimp check single_flaw.toml --picture specimen.png\n"
      "  rgimp check single_flaw.toml --set grid.cell_size=0.25e-3 --threads 8\n"
      "  rgimp check single_flaw.toml --json | jq .estimated_wall_s\n"
      "\n"
      "Keys of --json: file, title, dimension, particles, nodes, cell_size_m, dt_s,\n"
      "critical_step_ratio (dt/dt_cr), steps, time_s (simulated), memory_bytes,\n"
      "peak_memory_bytes, isa, threads, warnings, particle_steps_per_second, estimated_wall_s.");
  command->callback([arguments, &exit_code] { exit_code = check(*arguments); });
}

}  // namespace rgimp::cli
