#include "terminal.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdlib>

namespace rgimp::cli {

namespace {

bool shows_colours(std::FILE* stream) {
  const char* no_color = std::getenv("NO_COLOR");
  const char* terminal = std::getenv("TERM");
  return is_terminal(stream) && (no_color == nullptr || *no_color == '\0') && terminal != nullptr &&
         std::string_view(terminal) != "dumb";
}

/// Of ECMA-48's select graphic rendition.
std::string_view code(Colour colour) {
  switch (colour) {
    case Colour::bold:
      break;
    case Colour::red:
      return "1;31";
    case Colour::yellow:
      return "1;33";
  }
  return "1";
}

}  // namespace

bool is_terminal(std::FILE* stream) {
  return isatty(fileno(stream)) != 0;
}

std::string coloured(std::string_view text, Colour colour, std::FILE* stream) {
  return shows_colours(stream) ? fmt::format("\x1b[{}m{}\x1b[0m", code(colour), text)
                               : std::string(text);
}

}  // namespace rgimp::cli
