#include "kernel_comparison.hpp"

// Passes over the particles against their scalar twins, on each ISA this machine has.
namespace rgimp::tests {
namespace {

using kernels::Isa;
using kernels::KernelTable;

// Sums of a row of cancelling terms: of the row, or of the least that a row of any weight holds.
template <int Dim>
Approx close_to(double expected) {
  return Approx(expected).epsilon(1e-9).margin(1e-14 * kThickness<Dim>);
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("passes equal their scalar twins, sums included", "", ((int Dim), Dim), 2,
                       3) {
  for (const NamedPass<Dim>& named : all_passes<Dim>()) {
    INFO(named.name);
    std::vector<RowSums<Dim>> all;
    compare<Dim>([&](const KernelTable<Dim>& k, RandomState<Dim>& s) {
      all.push_back(run_pass(named.pass, k, s, kDt, s.bin_rows()));
    });
    std::int64_t failed_tension = 0;
    std::int64_t failed_shear = 0;
    for (std::size_t pair = 0; pair < all.size(); pair += 2) {
      for (std::size_t row = 0; row < all[pair].particles.size(); ++row) {
        const kernels::ParticleSums& got = all[pair].particles[row];
        const kernels::ParticleSums& expected = all[pair + 1].particles[row];
        REQUIRE(got.failed_tension == expected.failed_tension);
        REQUIRE(got.failed_shear == expected.failed_shear);
        REQUIRE(got.viscous_work == close_to<Dim>(expected.viscous_work));
        REQUIRE(got.released_energy == close_to<Dim>(expected.released_energy));
        failed_tension += got.failed_tension;
        failed_shear += got.failed_shear;
      }
    }
    // The states were chosen to reach every branch.
    REQUIRE((failed_tension > 100) == named.strains);
    REQUIRE((failed_shear > 100) == named.strains);
  }
}

TEMPLATE_TEST_CASE_SIG("the reach of a row equals its scalar twin's and leaves padding out", "",
                       ((int Dim), Dim), 2, 3) {
  for (const NamedPass<Dim>& named : all_passes<Dim>()) {
    std::vector<kernels::Reach> expected;
    for (const Isa isa : kernels::kAllIsas) {
      if (!kernels::available(isa) || !named.moves) {
        continue;
      }
      RandomState<Dim> s(5, 2, {});
      s.randomise_nodes();
      const std::vector<kernels::Reach> reach =
          run_pass(named.pass, kernels::kernels_for<Dim>(isa), s, 0.1, s.bin_rows()).reach;
      expected = isa == Isa::reference ? reach : expected;
      for (std::size_t row = 0; row < reach.size(); ++row) {
        INFO(kernels::name(isa) << ", row " << row);
        REQUIRE(reach[row].distance == Approx(expected[row].distance).epsilon(1e-12));
        REQUIRE(reach[row].step == Approx(expected[row].step).epsilon(1e-12));
      }
      const auto full = static_cast<std::size_t>(s.bin_rows().first + 4);
      REQUIRE(reach[full].distance > 0.5);
    }
  }
}

TEMPLATE_TEST_CASE_SIG(
    "a pass scatters what a scatter alone would from the same particles, to the bit", "",
    ((int Dim), Dim), 2, 3) {
  for (const Isa isa : kernels::kAllIsas) {
    if (!kernels::available(isa)) {
      continue;
    }
    INFO(kernels::name(isa));
    const KernelTable<Dim>& k = kernels::kernels_for<Dim>(isa);
    RandomState<Dim> s(7, 2, {.most_slots = 20});
    s.randomise_nodes();
    s.grid.clear({0, s.grid.rows()}, 1);
    run_pass<Dim>(&KernelTable<Dim>::strain_and_move, k, s, kDt, s.bin_rows());
    const std::vector<std::vector<double>> with_the_pass = node_fields(s, 1);
    s.grid.clear({0, s.grid.rows()}, 1);
    k.scatter_all(s.particles.view(), s.grid.view(1), s.bin_rows());
    REQUIRE(node_fields(s, 1) == with_the_pass);
  }
}

// Fused operations are written out and lanes are summed in one order.
TEMPLATE_TEST_CASE_SIG("AVX2 and AVX-512 agree to the bit", "", ((int Dim), Dim), 2, 3) {
  if (!kernels::available(Isa::avx512)) {
    WARN("no AVX-512 here: nothing to compare");
    return;
  }
  const KernelTable<Dim>& narrow = kernels::kernels_for<Dim>(Isa::avx2);
  const KernelTable<Dim>& wide = kernels::kernels_for<Dim>(Isa::avx512);
  for (const Filling& filling : kFillings) {
    for (const NamedPass<Dim>& named : all_passes<Dim>()) {
      INFO(named.name);
      RandomState<Dim> a(17, 2, filling);
      RandomState<Dim> b(17, 2, filling);
      std::vector<std::vector<kernels::NodeSums>> sums;
      for (auto [k, s] : {std::pair{&narrow, &a}, std::pair{&wide, &b}}) {
        s->randomise_nodes();
        sums.emplace_back(static_cast<std::size_t>(s->grid.rows()));
        k->update_nodes(s->grid.view(), node_update<Dim>(), {0, s->grid.rows()},
                        sums.back().data());
      }
      const RowSums<Dim> of_a = run_pass(named.pass, narrow, a, kDt, a.bin_rows());
      const RowSums<Dim> of_b = run_pass(named.pass, wide, b, kDt, b.bin_rows());
      REQUIRE(node_fields(a, 0) == node_fields(b, 0));
      REQUIRE(node_fields(a, 1) == node_fields(b, 1));
      REQUIRE(particle_columns(a) == particle_columns(b));
      for (std::size_t row = 0; row < of_a.reach.size(); ++row) {
        REQUIRE(sums[0][row].damping_work == sums[1][row].damping_work);
        REQUIRE(of_a.particles[row].viscous_work == of_b.particles[row].viscous_work);
        REQUIRE(of_a.particles[row].released_energy == of_b.particles[row].released_energy);
        REQUIRE(of_a.reach[row].distance == of_b.reach[row].distance);
      }
    }
  }
}

}  // namespace rgimp::tests
