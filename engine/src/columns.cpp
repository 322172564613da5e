#include "rgimp/columns.hpp"

#include <algorithm>

namespace rgimp {

std::vector<std::size_t> ParticleColumns::lane_of_id() const {
  std::size_t ids = 0;
  for (const std::uint32_t i : id) {
    if (i != no_id) {
      ids = std::max(ids, std::size_t{i} + 1);
    }
  }
  std::vector<std::size_t> lane(ids, no_lane);
  for (std::size_t at = 0; at < id.size(); ++at) {
    if (id[at] != no_id) {
      lane[id[at]] = at;
    }
  }
  return lane;
}

}  // namespace rgimp
