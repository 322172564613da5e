#include "facts.hpp"

#include <fmt/format.h>

#include <cstdio>

#include "format.hpp"

namespace rgimp::cli {

namespace {

std::string describe_grid(const Facts& facts, const Case& settings) {
  const auto& nodes = facts.nodes;
  const std::string depth = settings.dimension == 3 ? fmt::format(" x {}", nodes[2]) : "";
  return fmt::format("{} x {}{} nodes, cell size {:g} m", nodes[0], nodes[1], depth,
                     settings.grid.cell_size);
}

}  // namespace

void print_line(std::string_view name, std::string_view value) {
  fmt::print("{:<15} {}\n", name, printable(value));
}

std::string describe_speed(double particle_steps_per_second) {
  return fmt::format("{:.1f} M particle-steps/s", particle_steps_per_second * 1e-6);
}

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
             fmt::format("{}, at most {} (in a snapshot, or to go on)",
                         format_bytes(facts.memory_bytes), format_bytes(facts.peak_memory_bytes)));
  print_line("machine", fmt::format("{}, {} threads", facts.isa, facts.threads));
  std::fflush(stdout);  // for the physics may stop the steps
}

}  // namespace rgimp::cli
