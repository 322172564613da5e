#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "rgimp/case.hpp"

/// What several verbs are told in the same words.
namespace rgimp::cli {

/// What the command line says of a case: the file and what to change in it.
struct CaseArguments {
  std::filesystem::path file;
  std::vector<std::string> overrides;  ///< "dotted.key=value"
  std::optional<std::int64_t> steps;   ///< in all, in place of time.steps and time.duration
  std::optional<int> threads;
};

/// Accepts whole numbers from `least` up.
CLI::Validator at_least(std::int64_t least);

/// DIR, an output directory of `rgimp run`.
void add_results_option(CLI::App& command, std::filesystem::path& directory);

void add_case_options(CLI::App& command, CaseArguments& arguments);

/// What of the command line is no override: the number of steps and the threads.
void apply(const CaseArguments& arguments, Case& settings);

/// The case that the arguments mean. Its warnings go to stderr.
Case load_case(const CaseArguments& arguments);

}  // namespace rgimp::cli
