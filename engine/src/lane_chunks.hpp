#pragma once

#include <algorithm>
#include <cstddef>

#include "workers.hpp"

namespace rgimp {

/// Lanes from `first` to before `last`.
struct LaneRange {
  std::size_t first;
  std::size_t last;
};

inline constexpr std::size_t kLanesOfChunk = std::size_t{1} << 13;

inline std::size_t chunks_of(std::size_t lanes) {
  return (lanes + kLanesOfChunk - 1) / kLanesOfChunk;
}

/// Of so many lanes, those of one chunk.
inline LaneRange lanes_of_chunk(std::size_t chunk, std::size_t lanes) {
  return {chunk * kLanesOfChunk, std::min((chunk + 1) * kLanesOfChunk, lanes)};
}

/// visit(chunk, its lanes) for all chunks of so many lanes, on all threads.
template <typename Visit>
void for_each_chunk(std::size_t lanes, Workers& workers, Visit visit) {
  workers.for_each(static_cast<std::ptrdiff_t>(chunks_of(lanes)), [&](std::ptrdiff_t index) {
    const auto chunk = static_cast<std::size_t>(index);
    visit(chunk, lanes_of_chunk(chunk, lanes));
  });
}

}  // namespace rgimp
