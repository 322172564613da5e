#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "rgimp/simulation.hpp"

/// A simulation's figures, for people.
namespace rgimp::cli {

/// "particles       79,618" on stdout.
void print_line(std::string_view name, std::string_view value);

/// "104.2 M particle-steps/s"
std::string describe_speed(double particle_steps_per_second);

/// What the case is, before any of it is run. `file` stands in for a title that is not there.
void print_facts(const Simulation& simulation, const std::filesystem::path& file);

}  // namespace rgimp::cli
