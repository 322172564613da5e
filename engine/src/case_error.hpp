#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>

#include "rgimp/case.hpp"
#include "rgimp/error.hpp"

/// How a case is criticised: "case.toml:12: body[0].size: what is wrong", and the override in
/// place of the line where one set the key.
namespace rgimp {

/// One line that names the place of `key`, or of the nearest table around it, and says `what`.
std::string complaint(const CaseSource& source, std::string_view key, std::string_view what);

[[noreturn]] void refuse(const CaseSource& source, std::string_view key, std::string_view what);

}  // namespace rgimp
