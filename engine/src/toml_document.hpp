#pragma once

#include <toml++/toml.h>

#include <filesystem>
#include <span>
#include <string>

#include "rgimp/case.hpp"

namespace rgimp {

/// A case file as text: its keys, overrides applied, and where each came from.
struct TomlDocument {
  toml::table root;
  CaseSource source;
};

/// The text of a file. Throws FileError where it cannot be read or is longer than any case.
std::string read_text(const std::filesystem::path& path);

/// `path` is where the text came from, for messages. Throws CaseError for its syntax and for
/// overrides that have no place in it.
TomlDocument parse_document(const std::string& text, const std::filesystem::path& path,
                            std::span<const std::string> overrides);

}  // namespace rgimp
