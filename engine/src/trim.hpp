#pragma once

#include <algorithm>
#include <string_view>

namespace rgimp {

/// Without blanks and tabs at its ends.
inline std::string_view trim(std::string_view text) {
  const std::size_t first = std::min(text.find_first_not_of(" \t"), text.size());
  const std::size_t last = text.find_last_not_of(" \t");
  return text.substr(first, last == std::string_view::npos ? 0 : last + 1 - first);
}

}  // namespace rgimp
