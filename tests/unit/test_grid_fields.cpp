#include <catch2/catch.hpp>
#include <limits>

#include "models.hpp"
#include "particle_table.hpp"
#include "rgimp/error.hpp"
#include "rgimp/grid_fields.hpp"

namespace rgimp::tests {
namespace {

/// A block that shears as it falls, away from nodes.
Case moving_block() {
  Case settings = free_block(4.0, 6.0);
  settings.bodies.front().velocity = Vector(3.0, -7.0, 0.0);
  settings.bodies.front().center = Vector(0.13e-3, -0.21e-3, 0.0);
  return settings;
}

/// The same beside a heavier one that moves otherwise.
Case moving_blocks() {
  Case settings = moving_block();
  Body heavy = settings.bodies.front();
  heavy.center.x() += heavy.size.x();
  heavy.velocity = Vector(-1.0, 2.0, 0.0);
  heavy.material = "heavy";
  settings.materials["heavy"] = settings.materials["rock"];
  settings.materials["heavy"].density *= 3.0;
  settings.bodies.push_back(heavy);
  return settings;
}

void remove_first(ParticleTable& particles) {
  const auto remove = [](auto& column) { column.erase(column.begin()); };
  remove(particles.id);
  remove(particles.position);
  remove(particles.velocity);
  remove(particles.stress);
  remove(particles.max_principal_stress);
  remove(particles.failed);
  remove(particles.damage);
  remove(particles.failure_step);
}

/// The masses of the nodes as a step starts with them: the engine's own scatter.
template <int Dim>
void check_against_engine(const Case& settings) {
  ModelIn<Dim> model(settings);
  model.steps(120);
  const GridFields fields =
      grid_fields(settings, table_of(model.solver.particles()), model.solver.steps_done());
  model.solver.rebin();
  model.workers.region([&] { model.solver.prepare(); });
  const kernels::GridView<Dim>& grid = model.solver.now();
  double largest = 0.0;
  for (std::int64_t k = 0; k < fields.nodes[2]; ++k) {
    for (std::int64_t j = 0; j < fields.nodes[1]; ++j) {
      for (std::int64_t i = 0; i < fields.nodes[0]; ++i) {
        const std::int64_t row = j + fields.nodes[1] * k;
        const auto node = static_cast<std::size_t>(i + fields.nodes[0] * row);
        const std::ptrdiff_t lane = i + row * model.solver.grid().row_stride();
        largest = std::max(largest, std::abs(fields.mass[node] - grid.mass[lane]));
      }
    }
  }
  const double particle = model.solver.particles().mass[0];
  CHECK(largest < 1e-12 * particle);
  CHECK(fields.particles_outside == 0);
}

}  // namespace

TEST_CASE("nodes of the fields hold the mass that steps put there") {
  check_against_engine<2>(moving_block());
  check_against_engine<3>(in_space(moving_block(), 4.0));
}

TEST_CASE("the nodes are where the platens have moved the grid to") {
  check_against_engine<2>(compressed_block(4.0, 6.0, 2.0));
}

TEST_CASE("nodes average velocity by mass, stress and damage by volume") {
  const Case settings = moving_blocks();
  Model model(settings);
  ParticleTable particles = table_of(model.solver.particles());
  remove_first(particles);  // ids and rows differ from here on
  for (std::size_t row = 0; row < particles.size(); ++row) {
    particles.stress[row] = {-1.0, 2.0, 3.0, 4.0, 5.0, 6.0};
    particles.damage[row] = 0.25;
  }
  const GridFields fields = grid_fields(settings, particles, 0);
  double largest = 0.0;
  std::array<double, 2> momentum{};
  for (std::size_t node = 0; node < fields.mass.size(); ++node) {
    if (fields.mass[node] > 0.0) {
      for (std::size_t c = 0; c < 6; ++c) {
        largest = std::max(largest, std::abs(fields.stress[node][c] - particles.stress[0][c]));
      }
      largest = std::max(largest, std::abs(fields.damage[node] - 0.25));
    }
    for (std::size_t a = 0; a < 2; ++a) {
      momentum[a] += fields.mass[node] * fields.velocity[node][a];
    }
  }
  CHECK(largest < 1e-12);
  const Particles<2>& columns = model.solver.particles();
  std::array<double, 2> expected{};
  for (std::size_t lane = 0; lane < columns.lanes(); ++lane) {
    if (!columns.is_padding(lane) && columns.id[lane] != 0) {
      for (std::size_t a = 0; a < 2; ++a) {
        expected[a] += columns.mass[lane] * columns.velocity[a][lane];
      }
    }
  }
  CHECK(momentum[0] == Approx(expected[0]).epsilon(1e-12));
  CHECK(momentum[1] == Approx(expected[1]).epsilon(1e-12));
}

TEST_CASE("particles out of the grid's reach are counted and left out, unknown ones refused") {
  const Case settings = moving_block();
  Model model(settings);
  ParticleTable particles = table_of(model.solver.particles());
  const GridFields all = grid_fields(settings, particles, 0);
  const double infinity = std::numeric_limits<double>::infinity();
  particles.position[3] = {1.0, 0.0, 0.0};
  particles.position[4] = {0.0, -infinity, 0.0};
  particles.position[5] = {std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0};
  const GridFields fields = grid_fields(settings, particles, 0);
  CHECK(fields.particles_outside == 3);
  double missing_mass = 0.0;
  for (std::size_t node = 0; node < fields.mass.size(); ++node) {
    missing_mass += all.mass[node] - fields.mass[node];
  }
  CHECK(missing_mass == Approx(3.0 * model.solver.particles().mass[0]));
  particles.id[7] = static_cast<std::uint32_t>(particles.size());
  CHECK_THROWS_AS(grid_fields(settings, particles, 0), CaseError);
}

}  // namespace rgimp::tests
