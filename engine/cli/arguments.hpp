#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "rgimp/run.hpp"

namespace rgimp::cli {

/// What the command line says of a case: the file and what to change in it.
struct CaseArguments {
  std::filesystem::path file;
  std::vector<std::string> overrides;  ///< "dotted.key=value"
  std::optional<std::int64_t> steps;   ///< in all, in place of time.steps and time.duration
  std::optional<int> threads;
};

enum class Verbosity { quiet, normal };

struct RunArguments {
  CaseArguments input;
  std::optional<std::filesystem::path> directory;  ///< none: named after the case file
  ExistingOutput existing = ExistingOutput::refuse;
  Verbosity verbosity = Verbosity::normal;
};

struct CracksArguments {
  std::filesystem::path directory;            ///< written by `rgimp run`
  std::optional<std::int64_t> step;           ///< none: of the last snapshot
  std::optional<std::filesystem::path> json;  ///< none: not written
};

}  // namespace rgimp::cli
