#pragma once

#include <cstdio>
#include <string>
#include <string_view>

namespace rgimp::cli {

bool is_terminal(std::FILE* stream);

enum class Colour { bold, red, yellow };

/// The text in a colour where the stream is a terminal that shows some, NO_COLOR is unset or empty
/// (https://no-color.org) and TERM is not "dumb"; else as it is.
std::string coloured(std::string_view text, Colour colour, std::FILE* stream);

}  // namespace rgimp::cli
