#pragma once

#include <compare>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "failed_particles.hpp"
#include "rgimp/cracks.hpp"

/// Failed particles to cracks.
namespace rgimp {

struct CrackScale {
  double pitch = 0.0;      ///< m, the finest of the particles' lattices
  double cell_size = 0.0;  ///< m
};

struct Crack {
  std::size_t source = 0;
  std::vector<CrackParticle> particles;  ///< in the order of `step`; none: a flaw's outline only
};

/// A crack, or the failed outline of a flaw at a source.
struct CrackPlace {
  std::size_t source = 0;
  std::optional<std::size_t> crack;  ///< index in CrackGrowth::cracks

  // clang-tidy 14 takes the 0 that the compiler compares with for a null pointer.
  auto operator<=>(const CrackPlace&) const = default;  // NOLINT(modernize-use-nullptr)
};

/// Where two cracks touch first, or a crack and the outline of another flaw.
struct Meeting {
  std::int64_t step = 0;
  CrackPlace one;
  CrackPlace other;
  Vector position = Vector::Zero();  ///< m
};

struct CrackGrowth {
  std::vector<Crack> cracks;      ///< in the order in which they leave their flaws
  std::vector<Meeting> meetings;  ///< one for a pair
  std::size_t outline = 0;
  std::size_t elsewhere = 0;
};

/// Grows cracks through failed particles, which come in order of step. A particle belongs to the
/// crack that is connected to it first, through particles each of which has failed by then.
CrackGrowth grow_cracks(const std::vector<FailedParticle>& failed, const CrackScale& scale);

}  // namespace rgimp
