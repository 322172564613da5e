#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <vector>

#include "failed_particles.hpp"

namespace rgimp {

/// Failed particles are connected where they touch: one pitch apart along every axis, corners
/// included, with room for the round-off of their places.
inline constexpr double kReach = 1.5;  // pitches, per axis

/// Finds the particles that touch one another.
class Neighbours {
 public:
  /// `failed` must outlive it. `pitch` in m.
  Neighbours(const std::vector<FailedParticle>& failed, double pitch)
      : failed_(failed), reach_(kReach * pitch) {
    for (std::size_t p = 0; p < failed.size(); ++p) {
      box_[key(failed[p].position)].push_back(p);
    }
  }

  template <typename Visit>
  void for_each(std::size_t particle, Visit visit) const {
    const Vector& position = failed_[particle].position;
    const Key center = key(position);
    for (int n = 0; n < 27; ++n) {
      const auto found =
          box_.find({center[0] + n % 3 - 1, center[1] + n / 3 % 3 - 1, center[2] + n / 9 - 1});
      if (found == box_.end()) {
        continue;
      }
      for (const std::size_t other : found->second) {
        const Vector apart = (failed_[other].position - position).cwiseAbs();
        if (other != particle && apart.maxCoeff() <= reach_) {
          visit(other);
        }
      }
    }
  }

 private:
  using Key = std::array<std::int64_t, 3>;

  Key key(const Vector& position) const {
    const auto box = [&](double x) { return static_cast<std::int64_t>(std::floor(x / reach_)); };
    return {box(position.x()), box(position.y()), box(position.z())};
  }

  const std::vector<FailedParticle>& failed_;
  double reach_;  // m
  std::map<Key, std::vector<std::size_t>> box_;
};

}  // namespace rgimp
