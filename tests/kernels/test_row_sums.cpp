#include "kernel_comparison.hpp"

// What a pass reports of its rows is of this pass alone.
namespace rgimp::tests {
namespace {

using kernels::Isa;

/// Of a pass over all rows but the outer ones, which had reported `sums` and `reach`.
template <int Dim>
RowSums<Dim> run(PassOf<Dim> pass, Isa isa, const kernels::ParticleSums& sums,
                 const kernels::Reach& reach) {
  RandomState<Dim> state(11, 2, {});
  state.randomise_nodes();
  RowSums<Dim> reports(state);
  std::fill(reports.particles.begin(), reports.particles.end(), sums);
  std::fill(reports.reach.begin(), reports.reach.end(), reach);
  const kernels::ParticleUpdate update{.dt = 1e-7,
                                       .step = 3,
                                       .materials = state.materials.data(),
                                       .sums = reports.particles.data(),
                                       .reach = reports.reach.data()};
  (kernels::kernels_for<Dim>(isa).*pass)(state.particles.view(), state.grid.view(0),
                                         state.grid.view(1), update, state.bin_rows());
  return reports;
}

template <int Dim>
void check_forgets(Isa isa, const NamedPass<Dim>& reporter) {
  const kernels::ParticleSums sums{3.0, 4.0, 5, 6};
  const kernels::Reach reach{7.0, 8.0};
  const RowSums<Dim> clean = run<Dim>(reporter.pass, isa, {}, {});
  const RowSums<Dim> used = run<Dim>(reporter.pass, isa, sums, reach);
  const kernels::RowRange rows = RandomState<Dim>(11, 2, {}).bin_rows();
  for (std::ptrdiff_t row = 0; row < static_cast<std::ptrdiff_t>(clean.reach.size()); ++row) {
    INFO(kernels::name(isa) << ", " << reporter.name << ", row " << row);
    const bool inside = row >= rows.first && row < rows.last;
    const kernels::ParticleSums& got = used.particles[row];
    const kernels::ParticleSums& expected =
        reporter.strains && inside ? clean.particles[row] : sums;
    const kernels::Reach& expected_reach = reporter.moves && inside ? clean.reach[row] : reach;
    CHECK(got.viscous_work == expected.viscous_work);
    CHECK(got.released_energy == expected.released_energy);
    CHECK(got.failed_tension == expected.failed_tension);
    CHECK(got.failed_shear == expected.failed_shear);
    CHECK(used.reach[row].distance == expected_reach.distance);
    CHECK(used.reach[row].step == expected_reach.step);
  }
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("a pass replaces what its rows reported before, and leaves other rows alone",
                       "", ((int Dim), Dim), 2, 3) {
  for (const Isa isa : kernels::kAllIsas) {
    for (const NamedPass<Dim>& reporter : all_passes<Dim>()) {
      if (kernels::available(isa)) {
        check_forgets(isa, reporter);
      }
    }
  }
}

}  // namespace rgimp::tests
