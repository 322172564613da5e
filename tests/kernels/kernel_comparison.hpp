#pragma once

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "random_state.hpp"
#include "rgimp/kernels/table.hpp"

/// Runs kernels on random states and compares what they leave with what others do.
namespace rgimp::tests {

/// Of the largest value of a field: sums of about a hundred terms in another order, and weights
/// that are squares of distances whose own round-off is 1e-14 cells.
inline constexpr double kTolerance = 1e-12;
inline constexpr double kDt = 1e-7;

inline void require_close(const std::string& what, const double* value, const double* expected,
                          std::size_t count) {
  double scale = 0.0;
  double worst = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    REQUIRE(std::isfinite(value[i]));
    scale = std::max(scale, std::abs(expected[i]));
    worst = std::max(worst, std::abs(value[i] - expected[i]));
  }
  INFO(what << ": largest difference " << worst << " of " << scale);
  REQUIRE(worst <= kTolerance * scale);
}

/// Calls visit(name, values) for the node fields that kernels write.
template <int Dim, typename Visit>
void for_each_node_field(const kernels::GridView<Dim>& view, Visit visit) {
  visit("mass", view.mass);
  for (int a = 0; a < Dim; ++a) {
    const std::string axis = std::string(" ") + "xyz"[a];
    visit("momentum" + axis, view.momentum[a]);
    visit("force" + axis, view.force[a]);
    visit("second field" + axis, view.second_field[a]);
  }
}

/// The node fields of a layer, one after the other.
template <int Dim>
std::vector<std::vector<double>> node_fields(RandomState<Dim>& state, int layer) {
  std::vector<std::vector<double>> fields;
  for_each_node_field(state.grid.view(layer), [&](const std::string&, const double* values) {
    fields.emplace_back(values, values + state.nodes());
  });
  return fields;
}

/// The columns of all particles. Padding may differ: it is weightless, and the scalar twins pass
/// over it.
template <int Dim>
std::vector<std::vector<double>> particle_columns(RandomState<Dim>& state) {
  std::vector<std::vector<double>> columns;
  state.particles.for_each_column([&](const auto& column, auto) {
    columns.emplace_back();
    for (std::size_t i = 0; i < column.size(); ++i) {
      if (!state.particles.is_padding(i)) {
        columns.back().push_back(static_cast<double>(column[i]));
      }
    }
  });
  return columns;
}

template <int Dim>
void require_same_nodes(RandomState<Dim>& state, RandomState<Dim>& twin) {
  for (const int layer : {0, 1}) {
    const std::vector<std::vector<double>> expected = node_fields(twin, layer);
    std::size_t field = 0;
    for_each_node_field(state.grid.view(layer), [&](const std::string& name, const double* values) {
      require_close(name, values, expected[field++].data(), state.nodes());
    });
  }
}

template <int Dim>
void require_same_particles(RandomState<Dim>& state, RandomState<Dim>& twin) {
  const std::vector<std::vector<double>> got = particle_columns(state);
  const std::vector<std::vector<double>> expected = particle_columns(twin);
  for (std::size_t c = 0; c < got.size(); ++c) {
    require_close("column " + std::to_string(c), got[c].data(), expected[c].data(), got[c].size());
  }
}

template <int Dim>
std::size_t node_of(const Particles<Dim>& p, std::size_t lane) {
  const auto& begin = p.group_begin;
  const auto after = std::upper_bound(begin.begin(), begin.end(), lane / 8);
  return static_cast<std::size_t>(after - begin.begin() - 1) * 8 + lane % 8;
}

/// Nothing may move or load it: it would not stay finite next to nearly empty nodes.
template <int Dim>
void require_inert_padding(const Particles<Dim>& p, const Grid<Dim>& nodes) {
  for (std::size_t i = 0; i < p.lanes(); ++i) {
    if (p.is_padding(i)) {
      REQUIRE(p.mass[i] == 0.0);
      REQUIRE(p.volume[i] == 0.0);
      REQUIRE(p.viscous_energy[i] == 0.0);
      REQUIRE(p.failure_mode[i] == kernels::kPadding);
      const Vector node = nodes.position(static_cast<std::ptrdiff_t>(node_of(p, i)));
      for (int a = 0; a < Dim; ++a) {
        REQUIRE(p.velocity[a][i] == 0.0);
        REQUIRE(p.position[a][i] == node[a]);
      }
      for (const auto& stress : p.stress) {
        REQUIRE(stress[i] == 0.0);
      }
    }
  }
}

/// Few particles and many (several rounds of a group in each dimension), gaps and none, little
/// stress and much, softening.
inline const Filling kFillings[] = {
    {.most_slots = 6},
    {.most_slots = 40, .occupied = 0.5},
    {.most_slots = 150, .occupied = 0.2},
    {.most_slots = 3, .occupied = 0.0, .only_one_per_group = true},
    {.most_slots = 4, .occupied = 1.0, .initial_stress = 1e5},
    {.most_slots = 6, .softens = true},
};

/// Calls run(kernels, state) for each ISA but the reference, and with the reference for its twin,
/// and compares the two.
template <int Dim, typename Run>
void compare(const Run& run) {
  using kernels::Isa;
  for (const Isa isa : kernels::kAllIsas) {
    if (!kernels::available(isa) || isa == Isa::reference) {
      continue;
    }
    for (const int particles_per_cell : {2, 3, 4}) {
      unsigned seed = 1;
      for (const Filling& filling : kFillings) {
        INFO(kernels::name(isa) << ", " << particles_per_cell << " particles per cell and axis, "
                                << "filling " << seed);
        RandomState<Dim> state(seed, particles_per_cell, filling);
        RandomState<Dim> twin(seed, particles_per_cell, filling);
        state.randomise_nodes();
        twin.randomise_nodes();
        run(kernels::kernels_for<Dim>(isa), state);
        run(kernels::kernels_for<Dim>(Isa::reference), twin);
        require_same_nodes(state, twin);
        require_same_particles(state, twin);
        require_inert_padding(state.particles, state.grid);
        ++seed;
      }
    }
  }
}

/// One entry per row of the grid.
template <int Dim>
struct RowSums {
  explicit RowSums(RandomState<Dim>& state)
      : particles(static_cast<std::size_t>(state.grid.rows())),
        reach(static_cast<std::size_t>(state.grid.rows())) {}
  std::vector<kernels::ParticleSums> particles;
  std::vector<kernels::Reach> reach;
};

template <int Dim>
using PassOf = typename kernels::KernelTable<Dim>::Pass kernels::KernelTable<Dim>::*;

/// From the first layer to the second; what it adds to starts as it is.
template <int Dim>
RowSums<Dim> run_pass(PassOf<Dim> pass, const kernels::KernelTable<Dim>& k, RandomState<Dim>& s,
                      double dt, kernels::RowRange rows) {
  RowSums<Dim> sums(s);
  const kernels::ParticleUpdate update{.dt = dt,
                                       .step = 12,
                                       .materials = s.materials.data(),
                                       .sums = sums.particles.data(),
                                       .reach = sums.reach.data()};
  (k.*pass)(s.particles.view(), s.grid.view(0), s.grid.view(1), update, rows);
  return sums;
}

/// A pass of the table, and what it does besides scattering.
template <int Dim>
struct NamedPass {
  std::string name;
  PassOf<Dim> pass;
  bool strains;
  bool moves;
};

template <int Dim>
std::vector<NamedPass<Dim>> all_passes() {
  using Table = kernels::KernelTable<Dim>;
  return {
      {"MUSL, accelerate", &Table::accelerate, false, false},
      {"MUSL, strain and move", &Table::strain_and_move, true, true},
      {"USL", &Table::accelerate_strain_and_move, true, true},
      {"USF, strain", &Table::strain, true, false},
      {"USF, accelerate and move", &Table::accelerate_and_move, false, true},
  };
}

template <int Dim>
kernels::NodeUpdate<Dim> node_update() {
  kernels::NodeUpdate<Dim> update{
      .dt = kDt, .least_mass = 1e-9 * kThickness<Dim>, .body_acceleration = {3.0, -9.81}};
  if constexpr (Dim == 3) {
    update.body_acceleration[2] = 1.5;
  }
  return update;
}

}  // namespace rgimp::tests
