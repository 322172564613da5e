#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "rgimp/case.hpp"

namespace rgimp {

/// Reads a case file (TOML). `overrides` are "dotted.key=value" with a TOML literal as value (a
/// bare word is a string), applied before anything is checked: `body[0].size=[0.05, 0.1]`,
/// `material.rock.failure.cohesion=6e6`, `time.integrator=usl`.
/// Throws FileError where the file cannot be read, CaseError where it is wrong: syntax, unknown,
/// missing or ill-typed key, and everything check_case finds.
Case read_case(const std::filesystem::path& path, std::span<const std::string> overrides = {});

/// Throws CaseError for a case that cannot be run: values out of range, a material that does not
/// exist, bodies that overlap, a flaw outside every body, a slot under two cells across, a platen
/// off the grid lines, no particle left. Returns warnings, a sentence each (an oblique slot under
/// three cells across still carries load; a box's edge is not a whole number of particles; a
/// snapshot is listed past the last step).
std::vector<std::string> check_case(const Case& settings);

/// The case as a complete TOML text, defaults included, which read_case reads back to the same
/// case.
std::string write_case(const Case& settings);

}  // namespace rgimp
