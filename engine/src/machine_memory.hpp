#pragma once

#include <filesystem>
#include <optional>

namespace rgimp {

/// Bytes that this process may still take: what the machine has free, or less where a control group
/// of the process has a limit. None where the system does not tell. `root` is where the
/// system's files are.
std::optional<double> available_memory(const std::filesystem::path& root = "/");

}  // namespace rgimp
