#pragma once

#include <nlohmann/json.hpp>
#include <string_view>

/// What `--json` prints. Keys name their unit, as in summary.json.
namespace rgimp::cli {

using Json = nlohmann::ordered_json;  ///< keys stay in the order in which they are written

enum class ResultFormat { text, json };

/// Prints a value on stdout. File names that are no UTF-8 lose what is none.
void print_json(const Json& json);

/// A number if the text is one, else the text.
Json number_or_text(std::string_view text);

}  // namespace rgimp::cli
