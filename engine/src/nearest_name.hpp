#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace rgimp {

/// The name that `word` was probably meant to be: fewest edits (insert, delete, replace, swap two
/// neighbours), and no more than a third of the word.
std::optional<std::string_view> nearest_name(std::string_view word,
                                             std::span<const std::string_view> names);

/// `; did you mean "size"?`, or `otherwise` where no name is near.
std::string suggestion(std::string_view word, std::span<const std::string_view> names,
                       std::string_view otherwise);

}  // namespace rgimp
