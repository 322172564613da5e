#include "messages.hpp"

#include <fmt/format.h>

#include <cstdio>

#include "format.hpp"
#include "terminal.hpp"

namespace rgimp::cli {

void print_error(std::string_view message) {
  fmt::print(stderr, "rgimp: {} {}\n", coloured("error:", Colour::red, stderr), printable(message));
}

void print_warning(std::string_view message) {
  fmt::print(stderr, "rgimp: {} {}\n", coloured("warning:", Colour::yellow, stderr),
             printable(message));
}

void print_notice(std::string_view message) {
  fmt::print(stderr, "rgimp: {}\n", printable(message));
}

}  // namespace rgimp::cli
