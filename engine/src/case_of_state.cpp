#include "case_of_state.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "rgimp/case_file.hpp"
#include "rgimp/error.hpp"

namespace rgimp {
namespace {

/// The next line without its comment; "nothing" after the last.
std::string next_line(std::istringstream& text) {
  std::string line;
  if (!std::getline(text, line)) {
    return "nothing";
  }
  line.resize(std::min(line.find(" #"), line.size()));
  line.resize(line.find_last_not_of(' ') + 1);
  return line;
}

}  // namespace

std::string case_of_state(Case settings) {
  settings.title.clear();
  settings.time.steps = 1;
  settings.time.duration.reset();
  settings.grid.on_exit = OnExit::stop;
  settings.output = OutputSettings{};
  settings.tuning = Tuning{};
  return write_case(settings);
}

void require_same_case(const Case& settings, std::string_view text_of_checkpoint,
                       std::string_view checkpoint) {
  const std::string text = case_of_state(settings);
  if (text == text_of_checkpoint) {
    return;
  }
  std::istringstream here(text);
  std::istringstream there{std::string(text_of_checkpoint)};
  std::string line_here;
  std::string line_there;
  do {
    line_here = next_line(here);
    line_there = next_line(there);
  } while (line_here == line_there && here && there);
  throw CaseError(fmt::format("'{}' is of another case: it has '{}' where this one has '{}'",
                              checkpoint, line_there, line_here));
}

void require_own_functions(const std::vector<std::string>& set,
                           const std::vector<std::string>& of_checkpoint,
                           std::string_view checkpoint) {
  for (const std::string& name : of_checkpoint) {
    if (std::ranges::find(set, name) == set.end()) {
      throw CaseError(
          fmt::format("checkpoint '{}': a function of the program acted on it: call {}() before "
                      "restore()",
                      checkpoint, name));
    }
  }
}

}  // namespace rgimp
