#include "progress_display.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>

#include "format.hpp"

namespace rgimp::cli {

namespace {

constexpr std::size_t kUsualColumns = 80;  // of a terminal that does not tell
constexpr std::size_t kWidestBar = 40;
constexpr std::size_t kNarrowestBar = 5;
constexpr std::chrono::seconds kLinePace{5};

std::FILE* find_terminal() {
  if (isatty(STDERR_FILENO) != 0) {
    return stderr;
  }
  return isatty(STDOUT_FILENO) != 0 ? stdout : nullptr;
}

std::size_t columns_of(std::FILE* terminal) {
  winsize size{};
  const bool known = ioctl(fileno(terminal), TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  return known ? size.ws_col : kUsualColumns;
}

double fraction_of(const Progress& progress) {
  return progress.total_steps == 0
             ? 1.0
             : static_cast<double>(progress.step) / static_cast<double>(progress.total_steps);
}

/// Rounded down, so that 100 % means done.
int percent_of(const Progress& progress) {
  return static_cast<int>(100.0 * fraction_of(progress));
}

}  // namespace

std::string describe(const Progress& progress) {
  const auto steps = static_cast<double>(progress.step - progress.first_step);
  std::string text = fmt::format("{}/{} steps", with_separators(progress.step),
                                 with_separators(progress.total_steps));
  if (steps > 0.0 && progress.seconds > 0.0) {
    const double speed = static_cast<double>(progress.particles) * steps / progress.seconds;
    const auto steps_left = static_cast<double>(progress.total_steps - progress.step);
    text += fmt::format("  {:.1f} M particle-steps/s  {} left", speed * 1e-6,
                        format_duration(progress.seconds / steps * steps_left));
  }
  return text + fmt::format("  {} failed", with_separators(progress.failed));
}

std::string draw_progress(const Progress& progress, std::size_t columns) {
  const std::string percent = fmt::format("{:3} %", percent_of(progress));
  const std::string figures = describe(progress);
  const std::size_t taken = percent.size() + figures.size() + 4;  // brackets and blanks
  const std::size_t room = columns > taken ? std::min(columns - taken, kWidestBar) : 0;
  if (room < kNarrowestBar) {
    return fmt::format("{} {}", percent, figures).substr(0, columns);
  }
  const auto filled = static_cast<std::size_t>(static_cast<double>(room) * fraction_of(progress));
  return fmt::format("{} [{}{}] {}", percent, std::string(filled, '#'),
                     std::string(room - filled, ' '), figures);
}

ProgressDisplay::ProgressDisplay()
    : terminal_(find_terminal()), next_line_(std::chrono::steady_clock::now() + kLinePace) {}

ProgressDisplay::~ProgressDisplay() {
  clear();
}

void ProgressDisplay::show(const Progress& progress) {
  if (terminal_ != nullptr) {
    show_on_terminal(progress);
  } else {
    show_as_line(progress);
  }
}

void ProgressDisplay::clear() {
  if (line_shown_) {
    std::fputs("\r\x1b[K", terminal_);  // back to the first column, erase to the end of line
    std::fflush(terminal_);
    line_shown_ = false;
  }
}

void ProgressDisplay::show_on_terminal(const Progress& progress) {
  // The last column stays free: a character there makes some terminals wrap.
  const std::string line = draw_progress(progress, columns_of(terminal_) - 1);
  std::fputs(fmt::format("\r{}\x1b[K", line).c_str(), terminal_);
  std::fflush(terminal_);
  line_shown_ = true;
}

void ProgressDisplay::show_as_line(const Progress& progress) {
  const auto now = std::chrono::steady_clock::now();
  if (now < next_line_) {
    return;
  }
  // Not fmt::print, which throws where nobody reads on: a run is worth more than its progress.
  std::fputs(fmt::format("{} %  {}\n", percent_of(progress), describe(progress)).c_str(), stdout);
  std::fflush(stdout);
  next_line_ = now + kLinePace;
}

}  // namespace rgimp::cli
