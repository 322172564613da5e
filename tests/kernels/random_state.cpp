#include "random_state.hpp"

#include "failure_limits.hpp"

namespace rgimp::tests {
namespace {

constexpr double kCell = 0.5e-3;

template <int Dim>
constexpr std::array<std::int64_t, 3> kNodes = {37, 14, 1};
template <>
constexpr std::array<std::int64_t, 3> kNodes<3> = {21, 7, 6};

template <int Dim>
GridExtent extent() {
  return {Vector(-3e-3, 2e-3, 1e-3), Vector(kCell, 0.93 * kCell, 1.04 * kCell), kNodes<Dim>};
}

/// Where a step of platens on all axes would take the grid, were it that long.
template <int Dim>
GridExtent moved_extent() {
  GridExtent moved = extent<Dim>();
  moved.origin += Vector(0.02 * kCell, -0.03 * kCell, 0.01 * kCell);
  moved.spacing = moved.spacing.cwiseProduct(Vector(0.998, 1.001, 0.999));
  return moved;
}

std::vector<kernels::MaterialConstants> two_materials(const Filling& filling) {
  Case settings;
  settings.grid.cell_size = kCell;
  Material rock{2600.0, 17e9, 0.14, Failure{}};
  rock.failure->cohesion = 5.95e6;
  rock.failure->friction_angle = 40.0;
  rock.failure->tensile_strength = 2e6;
  Material soft{2000.0, 5e9, 0.3, Failure{}};
  soft.failure->criterion = Criterion::shear_strain;
  soft.failure->shear_strain = 1.5e-3;
  soft.failure->treatment = Treatment::pressure_window;
  soft.failure->pressure_min = -1e5;
  soft.failure->pressure_max = 2e6;
  if (filling.softens) {
    rock.failure->fracture_energy = 1.0;
    rock.failure->shear_fracture_energy = 60.0;
    soft.failure->criterion = Criterion::shear_stress;
    soft.failure->shear_strength = 2.5e6;
    soft.failure->shear_fracture_energy = 1.5;
  }
  return {material_constants(rock, settings), material_constants(soft, settings)};
}

}  // namespace

template <int Dim>
RandomState<Dim>::RandomState(unsigned seed, int particles_per_cell, const Filling& filling)
    : grid(extent<Dim>(), particles_per_cell, 0.7),
      materials(two_materials(filling)),
      random_(seed) {
  grid.move(1, moved_extent<Dim>());
  place_slots(filling);
  for (std::size_t group = 0; group + 1 < particles.group_begin.size(); ++group) {
    const std::size_t first = particles.group_begin[group] * kernels::kGroupWidth;
    const std::size_t last = particles.group_begin[group + 1] * kernels::kGroupWidth;
    const std::size_t lone = first + static_cast<std::size_t>(uniform(0.0, 7.999));
    for (std::size_t index = first; index < last; ++index) {
      const bool wanted =
          filling.only_one_per_group ? index == lone : uniform(0.0, 1.0) < filling.occupied;
      const auto column = static_cast<std::ptrdiff_t>(
          group % static_cast<std::size_t>(grid.groups_in_row()) * kernels::kGroupWidth +
          index % 8);
      if (wanted && column >= 1 && column <= grid.extent().nodes[0] - 2) {
        fill_lane(index, filling);
      }
    }
  }
}

template <int Dim>
void RandomState<Dim>::place_slots(const Filling& filling) {
  particles.group_begin = {0};
  for (std::ptrdiff_t row = 0; row < grid.rows(); ++row) {
    for (std::ptrdiff_t column = 0; column < grid.groups_in_row(); ++column) {
      const auto slots = static_cast<std::uint32_t>(
          is_inside(row) ? uniform(0.0, static_cast<double>(filling.most_slots) + 0.999) : 0.0);
      particles.group_begin.push_back(particles.group_begin.back() + slots);
    }
  }
  const std::size_t slots = particles.group_begin.back();
  if (filling.softens) {
    particles.damage = {0.0};  // present, sized below
  }
  for (std::size_t slot = 0; slot < slots; ++slot) {
    particles.slot_material.push_back(uniform(0.0, 1.0) < 0.5 ? 0 : 1);
  }
  particles.for_each_column(
      [&](auto& column, auto padding) { column.assign(slots * kernels::kGroupWidth, padding); });
  for (std::size_t group = 0; group + 1 < particles.group_begin.size(); ++group) {
    for (std::size_t i = particles.group_begin[group] * 8; i < particles.group_begin[group + 1] * 8;
         ++i) {
      const Vector node = grid.position(static_cast<std::ptrdiff_t>(group * 8 + i % 8));
      for (int a = 0; a < Dim; ++a) {
        particles.position[a][i] = node[a];
      }
    }
  }
}

template <int Dim>
bool RandomState<Dim>::is_inside(std::ptrdiff_t row) const {
  const auto& nodes = grid.extent().nodes;
  const std::ptrdiff_t y = row % nodes[1];
  const std::ptrdiff_t z = row / nodes[1];
  return y >= 1 && y <= nodes[1] - 2 && (Dim == 2 || (z >= 1 && z <= nodes[2] - 2));
}

template <int Dim>
kernels::RowRange RandomState<Dim>::bin_rows() const {
  const std::ptrdiff_t first = 1 + (Dim == 2 ? 0 : grid.extent().nodes[1]);
  return {first, grid.rows() - first};
}

template <int Dim>
void RandomState<Dim>::fill_lane(std::size_t index, const Filling& filling) {
  for (int a = 0; a < Dim; ++a) {
    const double reach = (1.0 - grid.particle_half_size()) * grid.extent().spacing[a];
    particles.position[a][index] += uniform(-reach, reach);
    particles.velocity[a][index] = uniform(-1.0, 1.0);
  }
  for (auto& stress : particles.stress) {
    stress[index] = uniform(-filling.initial_stress, filling.initial_stress);
  }
  particles.volume[index] = uniform(0.5, 1.5) * 0.25 * kCell * kCell * kThickness<Dim>;
  particles.mass[index] = 2600.0 * particles.volume[index];
  particles.viscous_energy[index] = uniform(0.0, 1e5) * particles.volume[index];
  const double draw = uniform(0.0, 1.0);
  particles.failure_mode[index] = draw < 0.8   ? kernels::kIntact
                                  : draw < 0.9 ? kernels::kFailedInTension
                                               : kernels::kFailedInShear;
  if (filling.softens) {
    set_damage(index);
  }
  particles.id[index] = static_cast<std::uint32_t>(particles.count++);
}

/// Half of the intact ones are on the way to failure.
template <int Dim>
void RandomState<Dim>::set_damage(std::size_t index) {
  double& mode = particles.failure_mode[index];
  const double draw = uniform(0.0, 1.0);
  if (mode != kernels::kIntact) {
    particles.damage[index] = 1.0;
  } else if (draw < 0.5) {
    const bool sheared = draw < 0.25 || particles.slot_material[index / 8] == 1;
    mode = sheared ? kernels::kSofteningInShear : kernels::kSofteningInTension;
    particles.damage[index] = uniform(0.0, 0.9);
  }
}

template <int Dim>
void RandomState<Dim>::randomise_nodes() {
  kernels::GridView<Dim> view = grid.view();
  for (std::ptrdiff_t n = 0; n < static_cast<std::ptrdiff_t>(nodes()); ++n) {
    const bool empty = uniform(0.0, 1.0) < 0.1;
    view.mass[n] = empty ? 0.0 : uniform(1e-6, 6e-4) * kThickness<Dim>;
    for (int a = 0; a < Dim; ++a) {
      view.momentum[a][n] = empty ? 0.0 : uniform(-1.0, 1.0) * view.mass[n];
      view.force[a][n] = empty ? 0.0 : uniform(-1e3, 1e3) * kThickness<Dim>;
      view.second_field[a][n] = empty ? 0.0 : uniform(-1.0, 1.0);
    }
    if (uniform(0.0, 1.0) < 0.1) {
      grid.clear_damping(n);
    }
  }
}

template <int Dim>
double RandomState<Dim>::uniform(double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random_);
}

template struct RandomState<2>;
template struct RandomState<3>;

}  // namespace rgimp::tests
