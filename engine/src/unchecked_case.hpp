#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "rgimp/case.hpp"

namespace rgimp {

/// The case that a text describes: keys, types and words are right, but check_case has not seen it.
/// `path` is where the text came from, for messages; no file is touched. Throws CaseError.
Case parse_case(const std::string& text, const std::filesystem::path& path,
                std::span<const std::string> overrides = {});

}  // namespace rgimp
