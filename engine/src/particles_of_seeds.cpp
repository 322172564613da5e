#include "particles_of_seeds.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <numeric>

namespace rgimp {
namespace {

std::size_t count_of(const SeedParts& seeds) {
  return std::accumulate(
      seeds.begin(), seeds.end(), std::size_t{0},
      [](std::size_t sum, const std::vector<ParticleSeed>& part) { return sum + part.size(); });
}

/// visit(part, id of its first) for all parts, on all threads.
template <typename Visit>
void for_each_part(const SeedParts& seeds, Workers& workers, Visit visit) {
  std::vector<std::size_t> first_id{0};
  for (const std::vector<ParticleSeed>& part : seeds) {
    first_id.push_back(first_id.back() + part.size());
  }
  workers.for_each(std::ssize(seeds), [&](std::ptrdiff_t index) {
    const auto part = static_cast<std::size_t>(index);
    visit(seeds[part], first_id[part]);
  });
}

}  // namespace

template <int Dim>
Particles<Dim> particles_from(const SeedParts& seeds, Workers& workers) {
  Particles<Dim> particles;
  particles.count = count_of(seeds);
  particles.for_each_column([&](auto& column, auto) { column.resize(particles.count); });
  for_each_part(seeds, workers, [&](const std::vector<ParticleSeed>& part, std::size_t first_id) {
    // Column by column: they all start at the same place in a page, so that a seed's values side
    // by side pushed one another out of the cache.
    const auto set = [&](auto& column, auto value_of) {
      std::transform(part.begin(), part.end(), column.data() + first_id, value_of);
    };
    const auto zero = [](const ParticleSeed&) { return 0.0; };
    for (int a = 0; a < Dim; ++a) {
      set(particles.position[a], [a](const ParticleSeed& seed) { return seed.position[a]; });
      set(particles.velocity[a], [a](const ParticleSeed& seed) { return seed.velocity[a]; });
    }
    for (auto& component : particles.stress) {
      set(component, zero);
    }
    set(particles.volume, [](const ParticleSeed& seed) { return seed.volume; });
    set(particles.mass, [](const ParticleSeed& seed) { return seed.mass; });
    set(particles.viscous_energy, zero);
    set(particles.failure_mode, [](const ParticleSeed&) { return kernels::kIntact; });
    set(particles.failure_step, [](const ParticleSeed&) { return -1; });
    set(particles.id,
        [id = static_cast<std::uint32_t>(first_id)](const ParticleSeed&) mutable { return id++; });
  });
  return particles;
}

std::vector<std::uint8_t> materials_of(const SeedParts& seeds, Workers& workers) {
  std::vector<std::uint8_t> materials(count_of(seeds));
  for_each_part(seeds, workers, [&](const std::vector<ParticleSeed>& part, std::size_t first_id) {
    std::transform(part.begin(), part.end(), materials.data() + first_id,
                   [](const ParticleSeed& seed) { return seed.material; });
  });
  return materials;
}

template Particles<2> particles_from<2>(const SeedParts&, Workers&);
template Particles<3> particles_from<3>(const SeedParts&, Workers&);

}  // namespace rgimp
