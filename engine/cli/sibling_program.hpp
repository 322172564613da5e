#pragma once

#include <string>
#include <vector>

namespace rgimp::cli {

/// Runs a program that is installed beside this one and gives its exit code; 128 and the number of
/// the signal that ended it. Throws FileError where it is not there.
int run_sibling(const std::string& name, const std::vector<std::string>& arguments);

}  // namespace rgimp::cli
