#pragma once

#include <string_view>

/// The version, for programs that are built against more than one (`#if`). The build takes it from
/// here; see engine/docs/library.md for what each number promises.
#define RGIMP_VERSION_MAJOR 0  ///< rises when something breaks, from 1 on
#define RGIMP_VERSION_MINOR 1  ///< rises when something breaks while the first is 0
#define RGIMP_VERSION_PATCH 0  ///< rises when nothing breaks

namespace rgimp {

/// The version of the library that the program is linked with, "0.1.0".
std::string_view version();

}  // namespace rgimp
