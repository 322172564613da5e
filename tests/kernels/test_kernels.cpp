#include "kernel_comparison.hpp"

// Scatters and node kernels against their scalar twins, on each ISA this machine has.
namespace rgimp::tests {
namespace {

using kernels::Isa;
using kernels::KernelTable;

}  // namespace

TEMPLATE_TEST_CASE_SIG("scatter of everything equals its scalar twin", "", ((int Dim), Dim), 2, 3) {
  compare<Dim>([](const KernelTable<Dim>& k, RandomState<Dim>& s) {
    s.grid.clear({0, s.grid.rows()});
    k.scatter_all(s.particles.view(), s.grid.view(), s.bin_rows());
  });
}

TEMPLATE_TEST_CASE_SIG("scatter adds to what nodes hold", "", ((int Dim), Dim), 2, 3) {
  compare<Dim>([](const KernelTable<Dim>& k, RandomState<Dim>& s) {
    k.scatter_mass_momentum(s.particles.view(), s.grid.view(), s.bin_rows());
  });
}

/// Rows in the order that kernels take them: in space all planes of a row along y before the next.
/// The scalar twins go through memory.
template <int Dim>
std::vector<std::ptrdiff_t> rows_in_order(Isa isa, const kernels::GridView<Dim>& grid,
                                          kernels::RowRange rows) {
  std::vector<std::ptrdiff_t> order(static_cast<std::size_t>(rows.last - rows.first));
  std::iota(order.begin(), order.end(), rows.first);
  if (Dim == 3 && isa != Isa::reference) {
    std::stable_sort(order.begin(), order.end(), [&](std::ptrdiff_t a, std::ptrdiff_t b) {
      return (a - rows.first) % grid.rows_in_plane < (b - rows.first) % grid.rows_in_plane;
    });
  }
  return order;
}

TEMPLATE_TEST_CASE_SIG("a scatter row by row equals one over all rows to the bit", "",
                       ((int Dim), Dim), 2, 3) {
  for (const Isa isa : kernels::kAllIsas) {
    if (!kernels::available(isa)) {
      continue;
    }
    INFO(kernels::name(isa));
    const KernelTable<Dim>& k = kernels::kernels_for<Dim>(isa);
    RandomState<Dim> whole(7, 2, {});
    RandomState<Dim> cut(7, 2, {});
    const kernels::RowRange rows = whole.bin_rows();
    k.scatter_all(whole.particles.view(), whole.grid.view(), rows);
    for (const std::ptrdiff_t row : rows_in_order<Dim>(isa, cut.grid.view(), rows)) {
      k.scatter_all(cut.particles.view(), cut.grid.view(), {row, row + 1});
    }
    REQUIRE(node_fields(whole, 0) == node_fields(cut, 0));
  }
}

TEMPLATE_TEST_CASE_SIG("node update equals its scalar twin, sums included", "", ((int Dim), Dim), 2,
                       3) {
  std::vector<kernels::NodeSums> expected;
  for (const Isa isa : kernels::kAllIsas) {
    if (!kernels::available(isa)) {
      continue;
    }
    RandomState<Dim> s(3, 2, {});
    s.randomise_nodes();
    std::vector<kernels::NodeSums> got(static_cast<std::size_t>(s.grid.rows()));
    kernels::kernels_for<Dim>(isa).update_nodes(s.grid.view(), node_update<Dim>(),
                                                {0, s.grid.rows()}, got.data());
    expected = isa == Isa::reference ? got : expected;
    for (std::size_t row = 0; row < got.size(); ++row) {
      INFO(kernels::name(isa) << ", row " << row);
      REQUIRE(got[row].damping_work == Approx(expected[row].damping_work).epsilon(1e-12));
      REQUIRE(got[row].body_force_work ==
              Approx(expected[row].body_force_work).epsilon(1e-10).margin(1e-16 * kThickness<Dim>));
    }
  }
  compare<Dim>([](const KernelTable<Dim>& k, RandomState<Dim>& s) {
    std::vector<kernels::NodeSums> by_row(static_cast<std::size_t>(s.grid.rows()));
    k.update_nodes(s.grid.view(), node_update<Dim>(), {0, s.grid.rows()}, by_row.data());
  });
}

TEMPLATE_TEST_CASE_SIG("division by mass equals its scalar twin, in place and from the momentum",
                       "", ((int Dim), Dim), 2, 3) {
  const double least_mass = node_update<Dim>().least_mass;
  compare<Dim>([=](const KernelTable<Dim>& k, RandomState<Dim>& s) {
    const kernels::GridView<Dim> view = s.grid.view();
    k.divide_by_mass(view, view.second_field, least_mass, {0, s.grid.rows()});
  });
  compare<Dim>([=](const KernelTable<Dim>& k, RandomState<Dim>& s) {
    const kernels::GridView<Dim> view = s.grid.view();
    k.divide_by_mass(view, view.momentum, least_mass, {0, s.grid.rows()});
  });
}

}  // namespace rgimp::tests
