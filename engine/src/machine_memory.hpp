#pragma once

#include <optional>
#include <string>

namespace rgimp {

/// Bytes that this process may still take: what the machine has free, or less where a control group
/// of the process has a limit. None where the system does not tell. The system's files are in
/// `root`/proc and `root`/sys.
std::optional<double> available_memory(const std::string& root = "");

}  // namespace rgimp
