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

/// Throws FileError where the file cannot be read, CaseError for its syntax and for overrides
/// that have no place in it.
TomlDocument load_document(const std::filesystem::path& path,
                           std::span<const std::string> overrides);

}  // namespace rgimp
