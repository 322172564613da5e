#pragma once

#include <string_view>

/// What the fuzzers feed with bytes, and what the test of the corpora replays. Each returns
/// whatever the bytes are, or throws std::logic_error where a promise is broken; anything worse is
/// for the sanitizers to see.
namespace rgimp::fuzz {

/// A case file. Lines that start with "#--set " are overrides besides.
void try_case(std::string_view bytes);

}  // namespace rgimp::fuzz
