#pragma once

#include <chrono>
#include <cstdio>
#include <string>

#include "rgimp/run.hpp"
#include "rgimp/sweep.hpp"

namespace rgimp::cli {

/// How far something is, and its figures.
struct ProgressLine {
  double fraction = 0.0;
  std::string figures;
};

/// "93,424/222,440 steps  231.4 M particle-steps/s ..."
ProgressLine line_of(const Progress& progress);
/// "3/14 cases, 2 running  1 min 05 s left"
ProgressLine line_of(const SweepProgress& progress);
/// One line of at most `columns` characters: percent, a bar where there is room, the figures.
std::string draw_progress(const ProgressLine& line, std::size_t columns);

/// Shows how far a run or sweep is: one line rewritten in place on a terminal, a plain line every
/// few seconds where neither stderr nor stdout is one.
class ProgressDisplay {
 public:
  ProgressDisplay();
  ~ProgressDisplay();
  ProgressDisplay(const ProgressDisplay&) = delete;
  ProgressDisplay& operator=(const ProgressDisplay&) = delete;

  void show(const ProgressLine& line);
  /// Takes the rewritten line away, so that what is printed next starts on a clean line.
  void clear();

 private:
  void show_on_terminal(const ProgressLine& line);
  void show_as_line(const ProgressLine& line);

  std::FILE* terminal_;  // null: none
  bool line_shown_ = false;
  std::chrono::steady_clock::time_point next_line_;
};

}  // namespace rgimp::cli
