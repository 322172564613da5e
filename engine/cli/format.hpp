#pragma once

#include <cstdint>
#include <string>

/// Numbers as people read them.
namespace rgimp::cli {

/// 79618 -> "79,618"
std::string with_separators(std::int64_t number);
/// 0.4 -> "0.4 s", 75 -> "1 min 15 s", 4000 -> "1 h 07 min"
std::string format_duration(double seconds);
/// 7340032 -> "7.0 MiB"
std::string format_bytes(std::size_t bytes);

}  // namespace rgimp::cli
