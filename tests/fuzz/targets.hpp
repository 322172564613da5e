#pragma once

#include <cstdint>
#include <string>
#include <string_view>

/// What the fuzzers feed with bytes, and what the test of the corpora replays. Each function
/// returns whatever the bytes are, or throws std::logic_error where a promise is broken; anything
/// worse is for the sanitizers to see.
namespace rgimp::fuzz {

/// Whether the bytes were refused with a message, or taken and used.
enum class Outcome { refused, used };

/// A case file. Lines that start with "#--set " are overrides besides. Refused too, unread, is
/// what is too large to be run here and no error.
Outcome try_case(std::string_view bytes);

/// A checkpoint of the case of tiny_checkpoint, but for its checksum, which is put right first:
/// no fuzzer would get past it.
Outcome try_checkpoint(std::string_view bytes);

/// A checkpoint after that many steps.
std::string tiny_checkpoint(std::int64_t steps);

}  // namespace rgimp::fuzz
