#pragma once

#include <toml++/toml.h>

#include <string>

#include "rgimp/case.hpp"

namespace rgimp {

/// Sets one value of a case file: "body[0].size=[0.05, 0.1]", also "body.0.size=...". Tables on
/// the way are made where they are missing; entries of an array are not. What the key then means
/// is left to the reader, and `source` names the override for it.
void apply_override(toml::table& root, const std::string& text, CaseSource& source);

}  // namespace rgimp
