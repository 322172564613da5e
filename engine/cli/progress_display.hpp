#pragma once

#include <chrono>
#include <cstdio>
#include <string>

#include "rgimp/run.hpp"

namespace rgimp::cli {

/// The figures of a progress line: "93,424/222,440 steps  231.4 M particle-steps/s ...".
std::string describe(const Progress& progress);
/// One line of at most `columns` characters: percent, a bar where there is room, the figures.
std::string draw_progress(const Progress& progress, std::size_t columns);

/// Shows how far a run is: one line rewritten in place on a terminal, a plain line every few
/// seconds where neither stderr nor stdout is one.
class ProgressDisplay {
 public:
  ProgressDisplay();
  ~ProgressDisplay();
  ProgressDisplay(const ProgressDisplay&) = delete;
  ProgressDisplay& operator=(const ProgressDisplay&) = delete;

  void show(const Progress& progress);
  /// Takes the rewritten line away, so that what is printed next starts on a clean line.
  void clear();

 private:
  void show_on_terminal(const Progress& progress);
  void show_as_line(const Progress& progress);

  std::FILE* terminal_;  // null: none
  bool line_shown_ = false;
  std::chrono::steady_clock::time_point next_line_;
};

}  // namespace rgimp::cli
