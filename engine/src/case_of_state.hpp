#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "rgimp/case.hpp"

namespace rgimp {

/// The case as far as a state depends on it, as TOML: without title, output and tuning, and
/// whatever its number of steps and grid.on_exit, so that a run can go on further, with other
/// threads, or past a particle that stopped it.
std::string case_of_state(Case settings);

/// Throws CaseError naming the first line in which a checkpoint's case_of_state() is another.
void require_same_case(const Case& settings, std::string_view text_of_checkpoint,
                       std::string_view checkpoint);

/// Throws CaseError naming a function that acted on a checkpoint's state and is not set here: a
/// restored simulation would go on by other physics, and nothing would tell. Both are
/// Solver::own_functions().
void require_own_functions(const std::vector<std::string>& set,
                           const std::vector<std::string>& of_checkpoint,
                           std::string_view checkpoint);

}  // namespace rgimp
