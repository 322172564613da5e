#include <catch2/catch.hpp>
#include <vector>

#include "random_state.hpp"
#include "rgimp/kernels/table.hpp"

// What a pass reports of its rows is of this pass alone.
namespace rgimp::tests {
namespace {

using kernels::Isa;
using kernels::KernelTable;
using Pass = KernelTable<2>::Pass KernelTable<2>::*;

struct Reports {
  std::vector<kernels::ParticleSums> sums;
  std::vector<kernels::Reach> reach;
};

/// Of a pass over all rows but the first and the last, which had reported `sums` and `reach`.
Reports run(Pass pass, Isa isa, const kernels::ParticleSums& sums, const kernels::Reach& reach) {
  RandomState state(11, 2, {});
  state.randomise_nodes();
  const auto rows = static_cast<std::size_t>(state.grid.rows());
  Reports reports{std::vector(rows, sums), std::vector(rows, reach)};
  const kernels::ParticleUpdate update{.dt = 1e-7,
                                       .step = 3,
                                       .materials = state.materials.data(),
                                       .sums = reports.sums.data(),
                                       .reach = reports.reach.data()};
  (kernels::kernels_for<2>(isa).*pass)(state.particles.view(), state.grid.view(0),
                                       state.grid.view(1), update, {1, state.grid.rows() - 1});
  return reports;
}

/// A pass, and which of the reports it makes.
struct Reporter {
  Pass pass;
  bool strains;
  bool moves;
};

void check_forgets(Isa isa, const Reporter& reporter) {
  const kernels::ParticleSums sums{3.0, 4.0, 5, 6};
  const kernels::Reach reach{7.0, 8.0};
  const Reports clean = run(reporter.pass, isa, {}, {});
  const Reports used = run(reporter.pass, isa, sums, reach);
  for (std::size_t row = 0; row < clean.sums.size(); ++row) {
    INFO(kernels::name(isa) << ", row " << row);
    const bool inside = row > 0 && row + 1 < clean.sums.size();
    const kernels::ParticleSums& expected = reporter.strains && inside ? clean.sums[row] : sums;
    const kernels::Reach& expected_reach = reporter.moves && inside ? clean.reach[row] : reach;
    CHECK(used.sums[row].viscous_work == expected.viscous_work);
    CHECK(used.sums[row].released_energy == expected.released_energy);
    CHECK(used.sums[row].failed_tension == expected.failed_tension);
    CHECK(used.sums[row].failed_shear == expected.failed_shear);
    CHECK(used.reach[row].distance == expected_reach.distance);
    CHECK(used.reach[row].step == expected_reach.step);
  }
}

}  // namespace

TEST_CASE("a pass replaces what its rows reported before, and leaves other rows alone") {
  const Reporter reporters[] = {
      {.pass = &KernelTable<2>::strain_and_move, .strains = true, .moves = true},
      {.pass = &KernelTable<2>::accelerate_strain_and_move, .strains = true, .moves = true},
      {.pass = &KernelTable<2>::strain, .strains = true, .moves = false},
      {.pass = &KernelTable<2>::accelerate_and_move, .strains = false, .moves = true},
      {.pass = &KernelTable<2>::accelerate, .strains = false, .moves = false}};
  for (const Isa isa : kernels::kAllIsas) {
    for (const Reporter& reporter : reporters) {
      if (kernels::available(isa)) {
        check_forgets(isa, reporter);
      }
    }
  }
}

}  // namespace rgimp::tests
