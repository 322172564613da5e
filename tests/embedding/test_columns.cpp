#include <catch2/catch.hpp>
#include <cmath>
#include <set>

#include "models.hpp"
#include "rgimp/rgimp.hpp"

// The columns that a simulation shows are its particles, in their place.
namespace rgimp::tests {
namespace {

Case case_in(int dimension) {
  return dimension == 3 ? cracking_block_in_space() : cracking_block();
}

void require_row(const ParticleColumns& columns, std::size_t lane, const ParticleTable& table,
                 std::size_t row, int dimension) {
  for (int a = 0; a < dimension; ++a) {
    REQUIRE(columns.position[a][lane] == table.position[row][a]);
    REQUIRE(columns.velocity[a][lane] == table.velocity[row][a]);
  }
  for (int c = 0; c < 2 * dimension; ++c) {
    REQUIRE(columns.stress[c][lane] == table.stress[row][c]);
  }
  REQUIRE(columns.failure_step[lane] == table.failure_step[row]);
  REQUIRE((columns.failed[lane] >= 1.0) == (table.failed[row] != FailureMode::intact));
}

}  // namespace

TEST_CASE("columns hold every particle of the table once, under its id") {
  const int dimension = GENERATE(2, 3);
  Simulation simulation(case_in(dimension));
  simulation.run_until(300);
  const ParticleColumns columns = simulation.columns();
  const ParticleTable table = simulation.particles();
  const std::vector<std::size_t> lane = columns.lane_of_id();

  REQUIRE(lane.size() == table.size());
  REQUIRE(std::set<std::size_t>(lane.begin(), lane.end()).size() == table.size());
  for (std::size_t row = 0; row < table.size(); ++row) {
    REQUIRE(columns.id[lane[row]] == table.id[row]);
    require_row(columns, lane[row], table, row, dimension);
  }
}

TEST_CASE("columns are of one length, and lanes without a particle have no mass") {
  const int dimension = GENERATE(2, 3);
  const Simulation simulation(case_in(dimension));
  const ParticleColumns columns = simulation.columns();

  std::size_t particles = 0;
  double mass = 0.0;
  for (std::size_t lane = 0; lane < columns.lanes(); ++lane) {
    const bool is_particle = columns.id[lane] != ParticleColumns::no_id;
    REQUIRE((columns.mass[lane] > 0.0) == is_particle);
    particles += is_particle ? 1 : 0;
    mass += columns.mass[lane];
  }
  CHECK(columns.lanes() % 8 == 0);
  CHECK(particles == simulation.facts().particles);
  const double spacing = 0.5 * simulation.settings().grid.cell_size;
  CHECK(mass == Approx(2600.0 * static_cast<double>(particles) * std::pow(spacing, dimension)));
  CHECK(columns.position[0].size() == columns.lanes());
  CHECK(columns.position[2].size() == (dimension == 3 ? columns.lanes() : 0));
  CHECK(columns.stress[4].size() == (dimension == 3 ? columns.lanes() : 0));
}

TEST_CASE("columns are the simulation's own, not copies") {
  Simulation simulation(case_in(2));
  const double* before = simulation.columns().stress[0].data();
  CHECK(simulation.columns().stress[0].data() == before);
}

}  // namespace rgimp::tests
