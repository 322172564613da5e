#include "case_error.hpp"

namespace rgimp {
namespace {

/// "body[0].size[1]" -> "body[0].size" -> "body[0]" -> "body" -> "".
std::string_view parent(std::string_view key) {
  const std::size_t cut = key.find_last_of(".[");
  return cut == std::string_view::npos ? std::string_view{} : key.substr(0, cut);
}

std::string place(const CaseSource& source, std::string_view key) {
  if (source.path.empty()) {
    return {};
  }
  for (; !key.empty(); key = parent(key)) {
    if (const auto found = source.overridden.find(std::string(key));
        found != source.overridden.end()) {
      return fmt::format("--set {}: ", found->second);
    }
    if (const auto found = source.line.find(std::string(key)); found != source.line.end()) {
      return fmt::format("{}:{}: ", source.path.string(), found->second);
    }
  }
  return fmt::format("{}:1: ", source.path.string());
}

}  // namespace

std::string complaint(const CaseSource& source, std::string_view key, std::string_view what) {
  return fmt::format("{}{}: {}", place(source, key), key, what);
}

void refuse(const CaseSource& source, std::string_view key, std::string_view what) {
  throw CaseError(complaint(source, key, what));
}

}  // namespace rgimp
