#pragma once

#include <cstdint>
#include <string>
#include <string_view>

/// Numbers as people read them, and text of files as a terminal may be given it.
namespace rgimp::cli {

/// 79618 -> "79,618"
std::string with_separators(std::int64_t number);
/// 0.4 -> "0.4 s", 75 -> "1 min 15 s", 4000 -> "1 h 07 min"
std::string format_duration(double seconds);
/// 7340032 -> "7.0 MiB"
std::string format_bytes(std::size_t bytes);
/// Text of a case or a file name with everything that a terminal would obey, or that is no UTF-8,
/// written as \xNN: a case must not move the cursor, set colours or forge lines.
std::string printable(std::string_view text);

}  // namespace rgimp::cli
