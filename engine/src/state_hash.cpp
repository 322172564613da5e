#include "state_hash.hpp"

#include <algorithm>
#include <cstring>
#include <limits>

namespace rgimp {

class Fnv1a {
 public:
  template <typename T>
  void add(T value) {
    unsigned char bytes[sizeof(T)];
    std::memcpy(bytes, &value, sizeof(T));
    for (const unsigned char byte : bytes) {
      state_ = (state_ ^ byte) * 0x100000001b3u;
    }
  }
  std::uint64_t value() const { return state_; }

 private:
  std::uint64_t state_ = 0xcbf29ce484222325u;
};

template <int Dim>
std::vector<std::size_t> lanes_by_id(const Particles<Dim>& particles) {
  constexpr std::size_t kNoLane = std::numeric_limits<std::size_t>::max();
  std::vector<std::size_t> lane(particles.count, kNoLane);
  for (std::size_t i = 0; i < particles.lanes(); ++i) {
    if (!particles.is_padding(i)) {
      const std::size_t id = particles.id[i];
      lane.resize(std::max(lane.size(), id + 1), kNoLane);
      lane[id] = i;
    }
  }
  std::erase(lane, kNoLane);  // particles that were taken out
  return lane;
}

template <int Dim>
std::uint64_t state_hash(Particles<Dim>& particles) {
  Fnv1a hash;
  for (const std::size_t lane : lanes_by_id(particles)) {
    particles.for_each_column([&](const auto& column, auto) { hash.add(column[lane]); });
  }
  return hash.value();
}

template std::vector<std::size_t> lanes_by_id<2>(const Particles<2>&);
template std::vector<std::size_t> lanes_by_id<3>(const Particles<3>&);
template std::uint64_t state_hash<2>(Particles<2>&);
template std::uint64_t state_hash<3>(Particles<3>&);

}  // namespace rgimp
