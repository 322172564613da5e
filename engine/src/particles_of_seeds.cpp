#include "particles_of_seeds.hpp"

#include <cstddef>
#include <iterator>
#include <numeric>

namespace rgimp {
namespace {

/// visit(id, seed) for all, on all threads.
template <typename Visit>
void for_each_seed(const SeedParts& seeds, Workers& workers, Visit visit) {
  std::vector<std::size_t> first_id{0};
  for (const std::vector<ParticleSeed>& part : seeds) {
    first_id.push_back(first_id.back() + part.size());
  }
  workers.for_each(std::ssize(seeds), [&](std::ptrdiff_t index) {
    const auto part = static_cast<std::size_t>(index);
    for (std::size_t i = 0; i < seeds[part].size(); ++i) {
      visit(first_id[part] + i, seeds[part][i]);
    }
  });
}

std::size_t count_of(const SeedParts& seeds) {
  return std::accumulate(
      seeds.begin(), seeds.end(), std::size_t{0},
      [](std::size_t sum, const std::vector<ParticleSeed>& part) { return sum + part.size(); });
}

}  // namespace

template <int Dim>
Particles<Dim> particles_from(const SeedParts& seeds, Workers& workers) {
  Particles<Dim> particles;
  particles.count = count_of(seeds);
  particles.for_each_column([&](auto& column, auto) { column.resize(particles.count); });
  for_each_seed(seeds, workers, [&](std::size_t id, const ParticleSeed& seed) {
    particles.for_each_column([&](auto& column, auto) { column[id] = {}; });
    for (int a = 0; a < Dim; ++a) {
      particles.position[a][id] = seed.position[a];
      particles.velocity[a][id] = seed.velocity[a];
    }
    particles.volume[id] = seed.volume;
    particles.mass[id] = seed.mass;
    particles.failure_step[id] = -1;
    particles.id[id] = static_cast<std::uint32_t>(id);
  });
  return particles;
}

std::vector<std::uint8_t> materials_of(const SeedParts& seeds, Workers& workers) {
  std::vector<std::uint8_t> materials(count_of(seeds));
  for_each_seed(seeds, workers,
                [&](std::size_t id, const ParticleSeed& seed) { materials[id] = seed.material; });
  return materials;
}

template Particles<2> particles_from<2>(const SeedParts&, Workers&);
template Particles<3> particles_from<3>(const SeedParts&, Workers&);

}  // namespace rgimp
