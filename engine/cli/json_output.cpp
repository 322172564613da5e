#include "json_output.hpp"

#include <fmt/format.h>

#include <string>

namespace rgimp::cli {

void print_json(const Json& json) {
  fmt::print("{}\n", json.dump(2, ' ', false, Json::error_handler_t::replace));
}

Json number_or_text(std::string_view text) {
  const Json value = Json::parse(text, nullptr, false);
  return value.is_number() ? value : Json(std::string(text));
}

}  // namespace rgimp::cli
