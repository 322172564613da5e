#include "messages.hpp"

#include <fmt/format.h>

#include <cstdio>

namespace rgimp::cli {

void print_error(std::string_view message) {
  fmt::print(stderr, "rgimp: error: {}\n", message);
}

void print_warning(std::string_view message) {
  fmt::print(stderr, "rgimp: warning: {}\n", message);
}

void print_notice(std::string_view message) {
  fmt::print(stderr, "rgimp: {}\n", message);
}

}  // namespace rgimp::cli
