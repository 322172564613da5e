#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace rgimp {

/// The particles where the steps keep them: no copy, one span per quantity, all of one length.
///
/// Order: sorted by the bin (the nearest node) a particle was in when it was last sorted, in slots
/// of eight lanes, one for each of eight bins side by side along x. A bin that has fewer particles
/// than its neighbours has lanes without one: their `id` is `no_id`, their mass and stress zero,
/// their position arbitrary. Particles change lanes when they are sorted anew; `id` stays.
///
/// Valid until the simulation steps, restores a checkpoint, is moved from or ends.
struct ParticleColumns {
  /// The id in lanes without a particle.
  static constexpr std::uint32_t no_id = std::numeric_limits<std::uint32_t>::max();
  /// Where lane_of_id() has no lane.
  static constexpr std::size_t no_lane = std::numeric_limits<std::size_t>::max();

  std::array<std::span<const double>, 3> position;  ///< m; the third is empty in 2D
  std::array<std::span<const double>, 3> velocity;  ///< m/s; the third is empty in 2D
  /// Pa, tension > 0; xx, yy, zz, xy, yz, xz; the last two are empty in 2D
  std::array<std::span<const double>, 6> stress;
  std::span<const double> volume;  ///< m3 (2D: m2)
  std::span<const double> mass;    ///< kg (2D: kg per metre of thickness)
  std::span<const double> failed;  ///< 1 in tension, 2 in shear; below 1 where not failed
  /// 1, share of the strength lost; empty where no material softens
  std::span<const double> damage;
  std::span<const std::int32_t> failure_step;  ///< -1 while intact
  std::span<const std::uint32_t> id;           ///< of step 0; `no_id` in padding

  /// The length of every column that is not empty.
  std::size_t lanes() const { return id.size(); }
  /// The lane of every id there ever was; `no_lane` for one that was taken out.
  std::vector<std::size_t> lane_of_id() const;
};

}  // namespace rgimp
