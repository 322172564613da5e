#include "progress_display.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>

#include <algorithm>

#include "format.hpp"
#include "terminal.hpp"

namespace rgimp::cli {

namespace {

constexpr std::size_t kUsualColumns = 80;  // of a terminal that does not tell
constexpr std::size_t kWidestBar = 40;
constexpr std::size_t kNarrowestBar = 5;
constexpr std::chrono::seconds kLinePace{5};

std::FILE* find_terminal() {
  if (is_terminal(stderr)) {
    return stderr;
  }
  return is_terminal(stdout) ? stdout : nullptr;
}

std::size_t columns_of(std::FILE* terminal) {
  winsize size{};
  const bool known = ioctl(fileno(terminal), TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  return known ? size.ws_col : kUsualColumns;
}

/// Rounded down, so that 100 % means done.
int percent_of(const ProgressLine& line) {
  return static_cast<int>(100.0 * line.fraction);
}

}  // namespace

ProgressLine line_of(const Progress& progress) {
  const auto done = static_cast<double>(progress.step);
  const auto total = static_cast<double>(progress.total_steps);
  const auto steps = static_cast<double>(progress.step - progress.first_step);
  std::string text = fmt::format("{}/{} steps", with_separators(progress.step),
                                 with_separators(progress.total_steps));
  if (steps > 0.0 && progress.seconds > 0.0) {
    const double speed = static_cast<double>(progress.particles) * steps / progress.seconds;
    text += fmt::format("  {:.1f} M particle-steps/s  {} left", speed * 1e-6,
                        format_duration(progress.seconds / steps * (total - done)));
  }
  text += fmt::format("  {} failed", with_separators(progress.failed));
  return {progress.total_steps == 0 ? 1.0 : done / total, text};
}

ProgressLine line_of(const SweepProgress& progress) {
  const auto total = static_cast<double>(progress.cases);
  std::string text =
      fmt::format("{}/{} cases, {} running", progress.ended, progress.cases, progress.running);
  if (progress.computed > 0.0) {
    text += fmt::format("  {} left", format_duration(progress.seconds / progress.computed *
                                                     (total - progress.done)));
  }
  return {progress.done / total, text};
}

std::string draw_progress(const ProgressLine& line, std::size_t columns) {
  const std::string percent = fmt::format("{:3} %", percent_of(line));
  const std::size_t taken = percent.size() + line.figures.size() + 4;  // brackets and blanks
  const std::size_t room = columns > taken ? std::min(columns - taken, kWidestBar) : 0;
  if (room < kNarrowestBar) {
    return fmt::format("{} {}", percent, line.figures).substr(0, columns);
  }
  const auto filled = static_cast<std::size_t>(static_cast<double>(room) * line.fraction);
  return fmt::format("{} [{}{}] {}", percent, std::string(filled, '#'),
                     std::string(room - filled, ' '), line.figures);
}

ProgressDisplay::ProgressDisplay()
    : terminal_(find_terminal()), next_line_(std::chrono::steady_clock::now() + kLinePace) {}

ProgressDisplay::~ProgressDisplay() {
  clear();
}

void ProgressDisplay::show(const ProgressLine& line) {
  if (terminal_ != nullptr) {
    show_on_terminal(line);
  } else {
    show_as_line(line);
  }
}

void ProgressDisplay::clear() {
  if (line_shown_) {
    std::fputs("\r\x1b[K", terminal_);  // back to the first column, erase to the end of line
    std::fflush(terminal_);
    line_shown_ = false;
  }
}

void ProgressDisplay::show_on_terminal(const ProgressLine& line) {
  constexpr std::size_t percent = 5;  // characters
  // The last column stays free: a character there makes some terminals wrap.
  const std::string text = draw_progress(line, columns_of(terminal_) - 1);
  const std::string front = coloured(text.substr(0, percent), Colour::bold, terminal_);
  std::fputs(
      fmt::format("\r{}{}\x1b[K", front, text.substr(std::min(percent, text.size()))).c_str(),
      terminal_);
  std::fflush(terminal_);
  line_shown_ = true;
}

void ProgressDisplay::show_as_line(const ProgressLine& line) {
  const auto now = std::chrono::steady_clock::now();
  if (now < next_line_) {
    return;
  }
  // Not fmt::print, which throws where nobody reads on: a run is worth more than its progress.
  std::fputs(fmt::format("{} %  {}\n", percent_of(line), line.figures).c_str(), stdout);
  std::fflush(stdout);
  next_line_ = now + kLinePace;
}

}  // namespace rgimp::cli
