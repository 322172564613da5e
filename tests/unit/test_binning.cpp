#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <iterator>
#include <limits>
#include <random>
#include <set>

#include "binning.hpp"
#include "floating_point_traps.hpp"
#include "particles_of_seeds.hpp"

namespace rgimp::tests {
namespace {

constexpr double kCell = 0.5e-3;

template <int Dim>
GridExtent extent() {
  if (Dim == 3) {
    return {Vector(-1e-3, 2e-3, -3e-3), Vector::Constant(kCell), {21, 13, 9}};
  }
  return {Vector(-1e-3, 2e-3, 0.0), Vector::Constant(kCell), {40, 30, 1}};
}

/// All over the grid but for its outermost cells.
template <int Dim>
std::vector<ParticleSeed> random_seeds(std::size_t count) {
  const GridExtent grid = extent<Dim>();
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::vector<ParticleSeed> seeds;
  for (std::size_t i = 0; i < count; ++i) {
    ParticleSeed seed;
    seed.position = grid.origin;
    for (int a = 0; a < Dim; ++a) {
      const double cells = static_cast<double>(grid.nodes[static_cast<std::size_t>(a)] - 1);
      seed.position[a] += kCell * (1.0 + (cells - 2.0) * unit(random));
    }
    seed.volume = 1e-8 * (1.0 + unit(random));
    seed.mass = 2600.0 * seed.volume;
    seed.material = unit(random) < 0.3 ? 1 : 0;
    seeds.push_back(seed);
  }
  return seeds;
}

}  // namespace

TEMPLATE_TEST_CASE_SIG(
    "binning puts each particle, with all it carries, in a lane of its nearest node", "",
    ((int Dim), Dim), 2, 3) {
  const std::vector<ParticleSeed> seeds = random_seeds<Dim>(3000);
  const SeedParts parts{seeds};
  const Grid<Dim> grid(extent<Dim>(), 2, 0.0);
  Workers workers(2);
  Particles<Dim> particles = particles_from<Dim>(parts, workers);
  REQUIRE(bin_particles(particles, materials_of(parts, workers), grid, workers).empty());

  std::set<std::uint32_t> ids;
  for (std::size_t group = 0; group + 1 < particles.group_begin.size(); ++group) {
    for (std::size_t slot = particles.group_begin[group]; slot < particles.group_begin[group + 1];
         ++slot) {
      for (std::size_t lane = 0; lane < 8; ++lane) {
        const std::size_t i = slot * 8 + lane;
        const Vector node = grid.position(static_cast<std::ptrdiff_t>(group * 8 + lane));
        double away = 0.0;
        for (int a = 0; a < Dim; ++a) {
          away = std::max(away, std::abs(particles.position[a][i] - node[a]));
        }
        if (particles.is_padding(i)) {
          REQUIRE(away == 0.0);
          REQUIRE(particles.mass[i] == 0.0);
          REQUIRE(particles.failure_mode[i] == kernels::kPadding);
          continue;
        }
        const ParticleSeed& seed = seeds[particles.id[i]];
        REQUIRE(ids.insert(particles.id[i]).second);
        for (int a = 0; a < Dim; ++a) {
          REQUIRE(particles.position[a][i] == seed.position[a]);
        }
        REQUIRE(particles.volume[i] == seed.volume);
        REQUIRE(particles.failure_step[i] == -1);
        REQUIRE(particles.slot_material[slot] == seed.material);
        REQUIRE(away <= (0.5 + 1e-12) * kCell);
      }
    }
  }
  REQUIRE(ids.size() == seeds.size());
}

TEMPLATE_TEST_CASE_SIG("binning again changes nothing, and keeps the order within a bin", "",
                       ((int Dim), Dim), 2, 3) {
  const SeedParts seeds{random_seeds<Dim>(2000)};
  const Grid<Dim> grid(extent<Dim>(), 2, 0.0);
  Workers workers(2);
  Particles<Dim> particles = particles_from<Dim>(seeds, workers);
  REQUIRE(bin_particles(particles, materials_of(seeds, workers), grid, workers).empty());
  const Column<std::uint32_t> once = particles.id;
  REQUIRE(bin_particles(particles, materials_of(seeds, workers), grid, workers).empty());
  REQUIRE(particles.id == once);
}

TEMPLATE_TEST_CASE_SIG("any number of threads bins seeds to the same lanes", "", ((int Dim), Dim),
                       2, 3) {
  // More than one chunk of lanes, in parts of which one is empty.
  const SeedParts seeds{random_seeds<Dim>(15000), {}, random_seeds<Dim>(8000)};
  const Grid<Dim> grid(extent<Dim>(), 2, 0.0);
  const auto bin_on = [&](int threads) {
    Workers workers(threads);
    Particles<Dim> particles;
    workers.region([&] {
      particles = particles_from<Dim>(seeds, workers);
      REQUIRE(bin_particles(particles, materials_of(seeds, workers), grid, workers).empty());
    });
    return particles;
  };
  const Particles<Dim> alone = bin_on(1);
  REQUIRE(alone.count == 23000);
  for (const int threads : {2, 5}) {
    const Particles<Dim> together = bin_on(threads);
    REQUIRE(together.id == alone.id);
    REQUIRE(together.position == alone.position);
    REQUIRE(together.mass == alone.mass);
    REQUIRE(together.failure_mode == alone.failure_mode);
    REQUIRE(together.group_begin == alone.group_begin);
    REQUIRE(together.slot_material == alone.slot_material);
  }
}

TEMPLATE_TEST_CASE_SIG("a particle out of the grid, or nowhere, is named and nothing is moved", "",
                       ((int Dim), Dim), 2, 3) {
  const WithoutTraps none;
  for (const double x : {-1e-3, 1.0, std::numeric_limits<double>::quiet_NaN(), 1e300}) {
    std::vector<ParticleSeed> seeds = random_seeds<Dim>(20);
    seeds[7].position.x() = x;
    seeds[11].position[Dim - 1] = 1.0;
    const SeedParts parts{seeds};
    const Grid<Dim> grid(extent<Dim>(), 2, 0.0);
    Workers workers(1);
    Particles<Dim> particles = particles_from<Dim>(parts, workers);
    const Column<std::uint32_t> before = particles.id;
    REQUIRE(bin_particles(particles, materials_of(parts, workers), grid, workers) ==
            std::vector<std::size_t>{7, 11});
    REQUIRE(particles.id == before);
  }
}

TEMPLATE_TEST_CASE_SIG("particles out of the grid are named in the order of their ids", "",
                       ((int Dim), Dim), 2, 3) {
  const SeedParts seeds{random_seeds<Dim>(200)};
  const Grid<Dim> grid(extent<Dim>(), 2, 0.0);
  Workers workers(1);
  Particles<Dim> particles = particles_from<Dim>(seeds, workers);
  const std::vector<std::uint8_t> materials = materials_of(seeds, workers);
  REQUIRE(bin_particles(particles, materials, grid, workers).empty());
  const auto lane_of = [&](std::uint32_t id) {
    return static_cast<std::size_t>(std::distance(
        particles.id.begin(), std::find(particles.id.begin(), particles.id.end(), id)));
  };
  std::uint32_t later = 1;  // in the order of ids, not of lanes
  while (lane_of(later) > lane_of(0)) {
    ++later;
  }
  particles.position[0][lane_of(0)] = 1.0;
  particles.position[0][lane_of(later)] = 1.0;
  REQUIRE(bin_particles(particles, materials, grid, workers) ==
          std::vector<std::size_t>{lane_of(0), lane_of(later)});
}

}  // namespace rgimp::tests
