// Problems of the community that a case file cannot express, as they need velocities or body forces
// that vary in space. Prints one JSON line a run; the checks turn them into rows.

#include <CLI/CLI.hpp>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>

#include "axis_aligned.hpp"
#include "free_block.hpp"
#include "manufactured_run.hpp"
#include "rgimp/error.hpp"
#include "vortex.hpp"

namespace rgimp::verification {
namespace {

struct Request {
  Resolution resolution{.cells = 16};
  double amplitude = 0.05;
  int dimension = 2;
  std::int64_t steps = 4000;
};

void print(const ManufacturedSolution& solution, const Request& request) {
  nlohmann::json line = {{"cells", request.resolution.cells}, {"amplitude", request.amplitude}};
  try {
    const ManufacturedErrors errors = run_manufactured(solution, request.resolution);
    line["displacement_error"] = errors.displacement;
    line["stress_error"] = errors.stress;
    line["particles"] = errors.particles;
    line["steps"] = errors.steps;
  } catch (const PhysicsError& error) {
    line["stopped"] = error.what();
  }
  std::cout << line << '\n';
}

void print(const Drift& drift, const Request& request) {
  std::cout << nlohmann::json{{"cells", request.resolution.cells},
                              {"linear_momentum", drift.linear_momentum},
                              {"angular_momentum", drift.angular_momentum},
                              {"energy", drift.energy},
                              {"largest_energy", drift.largest_energy},
                              {"steps", drift.steps}}
            << '\n';
}

using Integrators = std::map<std::string, Integrator>;

void add_options(CLI::App& command, Request& request, const Integrators& integrators) {
  command.add_option("--cells", request.resolution.cells, "cells a metre")
      ->check(CLI::PositiveNumber);
  command.add_option("--step-factor", request.resolution.step_factor, "alpha of Eq. 24")
      ->check(CLI::Range(1e-6, 0.999));
  command.add_option("--particles-per-cell", request.resolution.particles_per_cell, "per axis")
      ->check(CLI::Range(2, 4));
  command.add_option("--integrator", request.resolution.integrator, "of the step")
      ->transform(CLI::CheckedTransformer(integrators));
}

void add_manufactured(CLI::App& app, Request& request) {
  CLI::App* axis_aligned =
      app.add_subcommand("axis-aligned", "a square or cube that moves along its axes");
  CLI::App* vortex = app.add_subcommand("vortex", "a ring that is twisted and let go");
  CLI::App* force = app.add_subcommand("vortex-force", "its body force against the published one");
  for (CLI::App* command : {axis_aligned, vortex, force}) {
    // Not USF: its step starts from mass and momentum alone, with nothing yet to add a force to.
    add_options(*command, request, {{"musl", Integrator::musl}, {"usl", Integrator::usl}});
    command->add_option("--amplitude", request.amplitude, "A, m (axis-aligned) or rad")
        ->check(CLI::PositiveNumber);
  }
  axis_aligned->add_option("--dimension", request.dimension)->check(CLI::Range(2, 3));
  axis_aligned->callback(
      [&] { print(AxisAligned(request.amplitude, request.dimension), request); });
  vortex->callback([&] { print(Vortex(request.amplitude), request); });
  force->callback([&] {
    const Vortex solution(request.amplitude);
    std::cout << nlohmann::json{{"amplitude", request.amplitude},
                                {"distance", solution.distance_from_published_force()},
                                {"largest_shear", solution.largest_shear()}}
              << '\n';
  });
}

void add_free_blocks(CLI::App& app, Request& request) {
  CLI::App* spin = app.add_subcommand("spin", "a free block that turns once");
  CLI::App* vibrate = app.add_subcommand("vibrate", "a free block that swings along its length");
  for (CLI::App* command : {spin, vibrate}) {
    add_options(*command, request,
                {{"musl", Integrator::musl}, {"usl", Integrator::usl}, {"usf", Integrator::usf}});
  }
  vibrate->add_option("--steps", request.steps)->check(CLI::PositiveNumber);
  spin->callback([&] { print(spin_block(request.resolution), request); });
  vibrate->callback([&] { print(vibrate_block(request.resolution, request.steps), request); });
}

}  // namespace
}  // namespace rgimp::verification

int main(int argc, char** argv) {
  try {
    CLI::App app("Runs one of the community's problems and prints a JSON line");
    app.require_subcommand(1);
    rgimp::verification::Request request;
    rgimp::verification::add_manufactured(app, request);
    rgimp::verification::add_free_blocks(app, request);
    CLI11_PARSE(app, argc, argv);
  } catch (const std::exception& error) {
    std::cerr << "verification_community: error: " << error.what() << '\n';
    return 2;
  }
  return 0;
}
