#pragma once

#include <filesystem>
#include <fstream>
#include <string>

namespace rgimp {

/// Throws FileError for what is no file, or not there: a pipe or device may have no end, or block.
void require_regular_file(const std::filesystem::path& path);

/// A regular file, at its start. Throws FileError.
std::ifstream open_file(const std::filesystem::path& path);

/// All of a regular file. Throws FileError.
std::string read_bytes(const std::filesystem::path& path);

}  // namespace rgimp
