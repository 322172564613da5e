#include "messages.hpp"

#include <fmt/format.h>

#include <cstdio>

#include "format.hpp"

namespace rgimp::cli {

void print_error(std::string_view message) {
  fmt::print(stderr, "rgimp: error: {}\n", printable(message));
}

void print_warning(std::string_view message) {
  fmt::print(stderr, "rgimp: warning: {}\n", printable(message));
}

void print_notice(std::string_view message) {
  fmt::print(stderr, "rgimp: {}\n", printable(message));
}

}  // namespace rgimp::cli
