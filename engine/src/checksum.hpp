#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string_view>

namespace rgimp {

/// XXH3 over bytes that come in pieces: against damage, not against intent. It runs at memory
/// speed, so that a checkpoint costs what its writing does.
class Checksum {
 public:
  Checksum();
  ~Checksum();
  Checksum(Checksum&&) noexcept;
  Checksum& operator=(Checksum&&) noexcept;

  void add(std::string_view bytes);
  /// Of all bytes so far.
  std::uint64_t value() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

std::uint64_t checksum_of(std::string_view bytes);

}  // namespace rgimp
