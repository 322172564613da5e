#include "toml_document.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <fstream>
#include <system_error>

#include "rgimp/error.hpp"
#include "toml_override.hpp"

namespace rgimp {
namespace {

constexpr std::size_t kLongestCase = std::size_t{64} << 20;  // bytes
constexpr std::size_t kMostDots = 100;

[[noreturn]] void refuse_file(const std::filesystem::path& path, int system_error) {
  throw FileError(fmt::format("cannot read {}: {}", path.string(),
                              std::generic_category().message(system_error)));
}

/// The parser limits how deep values nest, but not keys; a.a.a... a million deep, it overflows the
/// stack. What could be one key holds none of the characters that end one; comments and strings may
/// have as many dots as nobody writes.
void refuse_deep_keys(const std::string& text, const std::filesystem::path& path) {
  constexpr std::string_view ends = "\n=,{}[]#";
  std::size_t dots = 0;
  std::size_t line = 1;
  for (const char c : text) {
    line += c == '\n' ? 1 : 0;
    dots = ends.find(c) != std::string_view::npos ? 0 : dots + (c == '.' ? 1 : 0);
    if (dots > kMostDots) {
      throw CaseError(fmt::format("{}:{}: more than {} dots in a row of names", path.string(), line,
                                  kMostDots));
    }
  }
}

toml::table parse(const std::string& text, const std::filesystem::path& path) {
  refuse_deep_keys(text, path);
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
  std::string text;
  std::string piece(std::size_t{1} << 16, '\0');
  while (file.read(piece.data(), static_cast<std::streamsize>(piece.size())) || file.gcount() > 0) {
    text.append(piece, 0, static_cast<std::size_t>(file.gcount()));
    if (text.size() > kLongestCase) {  // /dev/zero has no end
      throw FileError(fmt::format("cannot read {}: longer than {} MiB, which no case file is",
                                  path.string(), kLongestCase >> 20));
    }
  }
  if (file.bad()) {
    refuse_file(path, errno);
  }
  return text;
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
