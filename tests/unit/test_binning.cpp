#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <random>
#include <set>

#include "binning.hpp"
#include "floating_point_traps.hpp"

namespace rgimp::tests {
namespace {

constexpr double kCell = 0.5e-3;

GridExtent extent() {
  return {Vector(-1e-3, 2e-3, 0.0), Vector::Constant(kCell), {40, 30, 1}};
}

std::vector<ParticleSeed> random_seeds(std::size_t count) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::vector<ParticleSeed> seeds;
  for (std::size_t i = 0; i < count; ++i) {
    ParticleSeed seed;
    seed.position =
        extent().origin + kCell * Vector(1.0 + 37.0 * unit(random), 1.0 + 27.0 * unit(random), 0.0);
    seed.volume = 1e-8 * (1.0 + unit(random));
    seed.mass = 2600.0 * seed.volume;
    seed.material = unit(random) < 0.3 ? 1 : 0;
    seeds.push_back(seed);
  }
  return seeds;
}

std::vector<std::uint8_t> materials_of(const std::vector<ParticleSeed>& seeds) {
  std::vector<std::uint8_t> materials;
  materials.reserve(seeds.size());
  for (const ParticleSeed& seed : seeds) {
    materials.push_back(seed.material);
  }
  return materials;
}

}  // namespace

TEST_CASE("binning puts each particle, with all it carries, in a lane of its nearest node") {
  const std::vector<ParticleSeed> seeds = random_seeds(3000);
  const Grid<2> grid(extent(), 2, 0.0);
  Workers workers(2);
  Particles<2> particles = particles_from<2>(seeds);
  REQUIRE(bin_particles(particles, materials_of(seeds), grid, workers).empty());

  std::set<std::uint32_t> ids;
  for (std::size_t group = 0; group + 1 < particles.group_begin.size(); ++group) {
    for (std::size_t slot = particles.group_begin[group]; slot < particles.group_begin[group + 1];
         ++slot) {
      for (std::size_t lane = 0; lane < 8; ++lane) {
        const std::size_t i = slot * 8 + lane;
        const Vector node = grid.position(static_cast<std::ptrdiff_t>(group * 8 + lane));
        const double away = std::max(std::abs(particles.position[0][i] - node.x()),
                                     std::abs(particles.position[1][i] - node.y()));
        if (particles.is_padding(i)) {
          REQUIRE(away == 0.0);
          REQUIRE(particles.mass[i] == 0.0);
          REQUIRE(particles.failure_mode[i] == kernels::kPadding);
          continue;
        }
        const ParticleSeed& seed = seeds[particles.id[i]];
        REQUIRE(ids.insert(particles.id[i]).second);
        REQUIRE(particles.position[0][i] == seed.position.x());
        REQUIRE(particles.volume[i] == seed.volume);
        REQUIRE(particles.failure_step[i] == -1);
        REQUIRE(particles.slot_material[slot] == seed.material);
        REQUIRE(away <= (0.5 + 1e-12) * kCell);
      }
    }
  }
  REQUIRE(ids.size() == seeds.size());
}

TEST_CASE("binning again changes nothing, and keeps the order within a bin") {
  const std::vector<ParticleSeed> seeds = random_seeds(2000);
  const Grid<2> grid(extent(), 2, 0.0);
  Workers workers(2);
  Particles<2> particles = particles_from<2>(seeds);
  REQUIRE(bin_particles(particles, materials_of(seeds), grid, workers).empty());
  const Column<std::uint32_t> once = particles.id;
  REQUIRE(bin_particles(particles, materials_of(seeds), grid, workers).empty());
  REQUIRE(particles.id == once);
}

TEST_CASE("a particle out of the grid, or nowhere, is named and nothing is moved") {
  const WithoutTraps none;
  for (const double x : {-1e-3, 1.0, std::numeric_limits<double>::quiet_NaN(), 1e300}) {
    std::vector<ParticleSeed> seeds = random_seeds(20);
    seeds[7].position.x() = x;
    seeds[11].position.y() = 1.0;
    const Grid<2> grid(extent(), 2, 0.0);
    Workers workers(1);
    Particles<2> particles = particles_from<2>(seeds);
    const Column<std::uint32_t> before = particles.id;
    REQUIRE(bin_particles(particles, materials_of(seeds), grid, workers) ==
            std::vector<std::size_t>{7, 11});
    REQUIRE(particles.id == before);
  }
}

}  // namespace rgimp::tests
