#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <string>

#include "random_state.hpp"
#include "rgimp/kernels/table.hpp"

// Each SIMD kernel against its scalar twin, on each ISA this machine has.
namespace rgimp::tests {
namespace {

using kernels::Isa;
using kernels::KernelTable;
using kernels::RowRange;

// Of the largest value of a field: sums of about a hundred terms in another order, and weights that
// are squares of distances whose own round-off is 1e-14 cells.
constexpr double kTolerance = 1e-12;
constexpr double kDt = 1e-7;

double largest(const double* values, std::size_t count) {
  double most = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    most = std::max(most, std::abs(values[i]));
  }
  return most;
}

void require_close(const std::string& what, const double* value, const double* expected,
                   std::size_t count) {
  const double scale = largest(expected, count);
  double worst = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    REQUIRE(std::isfinite(value[i]));
    worst = std::max(worst, std::abs(value[i] - expected[i]));
  }
  INFO(what << ": largest difference " << worst << " of " << scale);
  REQUIRE(worst <= kTolerance * scale);
}

void require_same_nodes(RandomState& state, RandomState& twin) {
  const auto nodes = static_cast<std::size_t>(state.grid.rows() * state.grid.row_stride());
  for (const int layer : {0, 1}) {
    const kernels::GridView<2> got = state.grid.view(layer);
    const kernels::GridView<2> expected = twin.grid.view(layer);
    require_close("mass", got.mass, expected.mass, nodes);
    for (int a = 0; a < 2; ++a) {
      const std::string axis = a == 0 ? " x" : " y";
      require_close("momentum" + axis, got.momentum[a], expected.momentum[a], nodes);
      require_close("force" + axis, got.force[a], expected.force[a], nodes);
      require_close("second field" + axis, got.second_field[a], expected.second_field[a], nodes);
    }
  }
}

// Padding may differ: it is weightless, and the scalar twins pass over it.
void require_same_particles(RandomState& state, RandomState& twin) {
  std::vector<std::vector<double>> got;
  std::vector<std::vector<double>> expected;
  const auto collect = [](RandomState& s, std::vector<std::vector<double>>& columns) {
    s.particles.for_each_column([&](const auto& column, auto) {
      columns.emplace_back();
      for (std::size_t i = 0; i < column.size(); ++i) {
        if (!s.particles.is_padding(i)) {
          columns.back().push_back(static_cast<double>(column[i]));
        }
      }
    });
  };
  collect(state, got);
  collect(twin, expected);
  for (std::size_t c = 0; c < got.size(); ++c) {
    require_close("column " + std::to_string(c), got[c].data(), expected[c].data(), got[c].size());
  }
}

std::size_t node_of(const Particles<2>& p, std::size_t lane) {
  const auto& begin = p.group_begin;
  const auto after = std::upper_bound(begin.begin(), begin.end(), lane / 8);
  return static_cast<std::size_t>(after - begin.begin() - 1) * 8 + lane % 8;
}

// Nothing may move or load it: it would not stay finite next to nearly empty nodes.
void require_inert_padding(const Particles<2>& p, const Grid<2>& nodes) {
  for (std::size_t i = 0; i < p.lanes(); ++i) {
    if (p.is_padding(i)) {
      REQUIRE(p.mass[i] == 0.0);
      REQUIRE(p.volume[i] == 0.0);
      REQUIRE(p.viscous_energy[i] == 0.0);
      REQUIRE(p.failure_mode[i] == kernels::kPadding);
      for (int a = 0; a < 2; ++a) {
        REQUIRE(p.velocity[a][i] == 0.0);
        REQUIRE(p.position[a][i] == nodes.position(static_cast<std::ptrdiff_t>(node_of(p, i)))[a]);
      }
      for (const auto& stress : p.stress) {
        REQUIRE(stress[i] == 0.0);
      }
    }
  }
}

using Run = std::function<void(const KernelTable<2>&, RandomState&)>;

void compare(const Run& run) {
  const Filling fillings[] = {
      {.most_slots = 6},
      {.most_slots = 40, .occupied = 0.5},
      {.most_slots = 3, .occupied = 0.0, .only_one_per_group = true},
      {.most_slots = 4, .occupied = 1.0, .initial_stress = 1e5},
      {.most_slots = 6, .softens = true},
  };
  for (const Isa isa : kernels::kAllIsas) {
    if (!kernels::available(isa) || isa == Isa::reference) {
      continue;
    }
    for (const int particles_per_cell : {2, 3, 4}) {
      unsigned seed = 1;
      for (const Filling& filling : fillings) {
        INFO(kernels::name(isa) << ", " << particles_per_cell << " particles per cell and axis, "
                                << "filling " << seed);
        RandomState state(seed, particles_per_cell, filling);
        RandomState twin(seed, particles_per_cell, filling);
        state.randomise_nodes();
        twin.randomise_nodes();
        run(kernels::kernels_for<2>(isa), state);
        run(kernels::kernels_for<2>(Isa::reference), twin);
        require_same_nodes(state, twin);
        require_same_particles(state, twin);
        require_inert_padding(state.particles, state.grid);
        ++seed;
      }
    }
  }
}

RowRange all_rows(const RandomState& state) {
  return {1, state.grid.rows() - 1};
}

kernels::NodeUpdate<2> node_update() {
  return {.dt = kDt, .least_mass = 1e-9, .body_acceleration = {3.0, -9.81}};
}

}  // namespace

TEST_CASE("scatter of everything equals its scalar twin") {
  compare([](const KernelTable<2>& k, RandomState& s) {
    s.grid.clear({0, s.grid.rows()});
    k.scatter_all(s.particles.view(), s.grid.view(), all_rows(s));
  });
}

TEST_CASE("scatter adds to what nodes hold") {
  compare([](const KernelTable<2>& k, RandomState& s) {
    k.scatter_mass_momentum(s.particles.view(), s.grid.view(), all_rows(s));
  });
}

TEST_CASE("a scatter row by row equals one over all rows to the bit") {
  for (const Isa isa : kernels::kAllIsas) {
    if (!kernels::available(isa)) {
      continue;
    }
    const KernelTable<2>& k = kernels::kernels_for<2>(isa);
    RandomState whole(7, 2, {});
    RandomState cut(7, 2, {});
    k.scatter_all(whole.particles.view(), whole.grid.view(), all_rows(whole));
    for (std::ptrdiff_t row = 1; row < cut.grid.rows() - 1; ++row) {
      k.scatter_all(cut.particles.view(), cut.grid.view(), {row, row + 1});
    }
    const auto nodes = static_cast<std::size_t>(whole.grid.rows() * whole.grid.row_stride());
    for (std::size_t n = 0; n < nodes; ++n) {
      REQUIRE(whole.grid.view().mass[n] == cut.grid.view().mass[n]);
      REQUIRE(whole.grid.view().force[0][n] == cut.grid.view().force[0][n]);
    }
  }
}

TEST_CASE("node update equals its scalar twin, sums included") {
  std::vector<kernels::NodeSums> sums[2];
  for (const Isa isa : kernels::kAllIsas) {
    if (!kernels::available(isa)) {
      continue;
    }
    RandomState s(3, 2, {});
    s.randomise_nodes();
    std::vector<kernels::NodeSums> got(static_cast<std::size_t>(s.grid.rows()));
    kernels::kernels_for<2>(isa).update_nodes(s.grid.view(), node_update(), {0, s.grid.rows()},
                                              got.data());
    if (isa == Isa::reference) {
      sums[0] = got;
      continue;
    }
    for (std::size_t row = 0; row < got.size(); ++row) {
      INFO(kernels::name(isa) << ", row " << row);
      REQUIRE(got[row].damping_work == Approx(sums[0][row].damping_work).epsilon(1e-12));
      REQUIRE(got[row].body_force_work ==
              Approx(sums[0][row].body_force_work).epsilon(1e-10).margin(1e-16));
    }
  }
  compare([](const KernelTable<2>& k, RandomState& s) {
    std::vector<kernels::NodeSums> by_row(static_cast<std::size_t>(s.grid.rows()));
    k.update_nodes(s.grid.view(), node_update(), {0, s.grid.rows()}, by_row.data());
  });
}

TEST_CASE("division by mass equals its scalar twin, in place and from the momentum") {
  compare([](const KernelTable<2>& k, RandomState& s) {
    const kernels::GridView<2> view = s.grid.view();
    k.divide_by_mass(view, view.second_field, 1e-9, {0, s.grid.rows()});
  });
  compare([](const KernelTable<2>& k, RandomState& s) {
    const kernels::GridView<2> view = s.grid.view();
    k.divide_by_mass(view, view.momentum, 1e-9, {0, s.grid.rows()});
  });
}

using Pass = KernelTable<2>::Pass KernelTable<2>::*;

struct NamedPass {
  std::string name;
  Pass pass;
};

const NamedPass kPasses[] = {
    {"MUSL, accelerate", &KernelTable<2>::accelerate},
    {"MUSL, strain and move", &KernelTable<2>::strain_and_move},
    {"USL", &KernelTable<2>::accelerate_strain_and_move},
    {"USF, strain", &KernelTable<2>::strain},
    {"USF, accelerate and move", &KernelTable<2>::accelerate_and_move},
};

/// One entry per row of the grid.
struct RowSums {
  explicit RowSums(RandomState& state)
      : particles(static_cast<std::size_t>(state.grid.rows())),
        reach(static_cast<std::size_t>(state.grid.rows())) {}
  std::vector<kernels::ParticleSums> particles;
  std::vector<kernels::Reach> reach;
};

// From the first layer to the second; what it adds to starts as it is.
RowSums run_pass(Pass pass, const KernelTable<2>& k, RandomState& s, double dt, RowRange rows) {
  RowSums sums(s);
  const kernels::ParticleUpdate update{.dt = dt,
                                       .step = 12,
                                       .materials = s.materials.data(),
                                       .sums = sums.particles.data(),
                                       .reach = sums.reach.data()};
  (k.*pass)(s.particles.view(), s.grid.view(0), s.grid.view(1), update, rows);
  return sums;
}

TEST_CASE("passes equal their scalar twins, sums included") {
  for (const NamedPass& named : kPasses) {
    INFO(named.name);
    std::vector<RowSums> all;
    compare([&](const KernelTable<2>& k, RandomState& s) {
      all.push_back(run_pass(named.pass, k, s, kDt, all_rows(s)));
    });
    std::int64_t failed_tension = 0;
    std::int64_t failed_shear = 0;
    for (std::size_t pair = 0; pair < all.size(); pair += 2) {
      for (std::size_t row = 0; row < all[pair].particles.size(); ++row) {
        const kernels::ParticleSums& got = all[pair].particles[row];
        const kernels::ParticleSums& expected = all[pair + 1].particles[row];
        REQUIRE(got.failed_tension == expected.failed_tension);
        REQUIRE(got.failed_shear == expected.failed_shear);
        REQUIRE(got.viscous_work == Approx(expected.viscous_work).epsilon(1e-9).margin(1e-14));
        REQUIRE(got.released_energy ==
                Approx(expected.released_energy).epsilon(1e-9).margin(1e-14));
        failed_tension += got.failed_tension;
        failed_shear += got.failed_shear;
      }
    }
    // The states were chosen to reach every branch.
    const bool strains = named.pass == &KernelTable<2>::strain_and_move ||
                         named.pass == &KernelTable<2>::accelerate_strain_and_move ||
                         named.pass == &KernelTable<2>::strain;
    REQUIRE((failed_tension > 100) == strains);
    REQUIRE((failed_shear > 100) == strains);
  }
}

TEST_CASE("the reach of a row equals its scalar twin's and leaves padding out") {
  for (const Pass pass :
       {&KernelTable<2>::strain_and_move, &KernelTable<2>::accelerate_strain_and_move,
        &KernelTable<2>::accelerate_and_move}) {
    std::vector<kernels::Reach> expected;
    for (const Isa isa : kernels::kAllIsas) {
      if (!kernels::available(isa)) {
        continue;
      }
      RandomState s(5, 2, {});
      s.randomise_nodes();
      const std::vector<kernels::Reach> reach =
          run_pass(pass, kernels::kernels_for<2>(isa), s, 0.1, all_rows(s)).reach;
      expected = isa == Isa::reference ? reach : expected;
      for (std::size_t row = 0; row < reach.size(); ++row) {
        INFO(kernels::name(isa) << ", row " << row);
        REQUIRE(reach[row].distance == Approx(expected[row].distance).epsilon(1e-12));
        REQUIRE(reach[row].step == Approx(expected[row].step).epsilon(1e-12));
      }
      REQUIRE(reach[5].distance > 0.5);
    }
  }
}

TEST_CASE("a pass scatters what a scatter alone would from the same particles, to the bit") {
  for (const Isa isa : kernels::kAllIsas) {
    if (!kernels::available(isa)) {
      continue;
    }
    INFO(kernels::name(isa));
    const KernelTable<2>& k = kernels::kernels_for<2>(isa);
    RandomState s(7, 2, {.most_slots = 20});
    s.randomise_nodes();
    s.grid.clear({0, s.grid.rows()}, 1);
    run_pass(&KernelTable<2>::strain_and_move, k, s, kDt, all_rows(s));
    const auto nodes = static_cast<std::size_t>(s.grid.rows() * s.grid.row_stride());
    const kernels::GridView<2> view = s.grid.view(1);
    const std::vector<double> mass(view.mass, view.mass + nodes);
    const std::vector<double> force(view.force[1], view.force[1] + nodes);
    s.grid.clear({0, s.grid.rows()}, 1);
    k.scatter_all(s.particles.view(), view, all_rows(s));
    for (std::size_t n = 0; n < nodes; ++n) {
      REQUIRE(view.mass[n] == mass[n]);
      REQUIRE(view.force[1][n] == force[n]);
    }
  }
}

}  // namespace rgimp::tests
