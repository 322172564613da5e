#pragma once

#include <string_view>

namespace rgimp::cli {

/// "rgimp: error: MESSAGE" on stderr.
void print_error(std::string_view message);
/// "rgimp: warning: MESSAGE" on stderr.
void print_warning(std::string_view message);
/// "rgimp: MESSAGE" on stderr.
void print_notice(std::string_view message);

}  // namespace rgimp::cli
