#include "toml_document.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <fstream>
#include <sstream>
#include <system_error>

#include "rgimp/error.hpp"
#include "toml_override.hpp"

namespace rgimp {
namespace {

[[noreturn]] void refuse_file(const std::filesystem::path& path, int system_error) {
  throw FileError(fmt::format("cannot read {}: {}", path.string(),
                              std::generic_category().message(system_error)));
}

toml::table parse(const std::string& text, const std::filesystem::path& path) {
  try {
    return toml::parse(std::string_view(text));
  } catch (const toml::parse_error& error) {
    throw CaseError(
        fmt::format("{}:{}: {}", path.string(), error.source().begin.line, error.description()));
  }
}

void note_lines(const toml::node& node, const std::string& path, CaseSource& source) {
  if (const toml::table* table = node.as_table()) {
    for (const auto& [key, value] : *table) {
      const std::string child =
          path.empty() ? std::string(key.str()) : fmt::format("{}.{}", path, key.str());
      source.line[child] = value.is_value() ? key.source().begin.line : value.source().begin.line;
      note_lines(value, child, source);
    }
  } else if (const toml::array* array = node.as_array()) {
    for (std::size_t i = 0; i < array->size(); ++i) {
      const std::string child = fmt::format("{}[{}]", path, i);
      source.line[child] = (*array)[i].source().begin.line;
      note_lines((*array)[i], child, source);
    }
  }
}

}  // namespace

std::string read_text(const std::filesystem::path& path) {
  if (std::error_code ignored; std::filesystem::is_directory(path, ignored)) {
    refuse_file(path, EISDIR);
  }
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file) {
    refuse_file(path, errno);
  }
  std::ostringstream text;
  // An empty file copies no character, which `<<` reports as a failure of `text`.
  if (file.peek() != std::ifstream::traits_type::eof()) {
    text << file.rdbuf();
  }
  if (file.bad() || text.bad()) {
    refuse_file(path, errno);
  }
  return std::move(text).str();
}

TomlDocument parse_document(const std::string& text, const std::filesystem::path& path,
                            std::span<const std::string> overrides) {
  TomlDocument document;
  document.source.path = path;
  document.root = parse(text, path);
  note_lines(document.root, "", document.source);
  for (const std::string& change : overrides) {
    apply_override(document.root, change, document.source);
  }
  return document;
}

}  // namespace rgimp
