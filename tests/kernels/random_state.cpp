#include "random_state.hpp"

#include "failure_limits.hpp"

namespace rgimp::tests {
namespace {

constexpr double kCell = 0.5e-3;
constexpr std::int64_t kNodesX = 37;
constexpr std::int64_t kNodesY = 14;

GridExtent extent() {
  return {Vector(-3e-3, 2e-3, 0.0), Vector(kCell, 0.93 * kCell, kCell), {kNodesX, kNodesY, 1}};
}

/// Where a step of platens on both axes would take the grid, were it that long.
GridExtent moved_extent() {
  GridExtent moved = extent();
  moved.origin += Vector(0.02 * kCell, -0.03 * kCell, 0.0);
  moved.spacing = moved.spacing.cwiseProduct(Vector(0.998, 1.001, 1.0));
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

RandomState::RandomState(unsigned seed, int particles_per_cell, const Filling& filling)
    : grid(extent(), particles_per_cell, 0.7), materials(two_materials(filling)), random_(seed) {
  grid.move(1, moved_extent());
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
      if (wanted && column >= 1 && column <= kNodesX - 2) {
        fill_lane(index, filling);
      }
    }
  }
}

void RandomState::place_slots(const Filling& filling) {
  particles.group_begin = {0};
  for (std::ptrdiff_t row = 0; row < grid.rows(); ++row) {
    for (std::ptrdiff_t column = 0; column < grid.groups_in_row(); ++column) {
      const bool inside = row >= 1 && row <= kNodesY - 2;
      const auto slots = static_cast<std::uint32_t>(
          inside ? uniform(0.0, static_cast<double>(filling.most_slots) + 0.999) : 0.0);
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
      particles.position[0][i] = node.x();
      particles.position[1][i] = node.y();
    }
  }
}

void RandomState::fill_lane(std::size_t index, const Filling& filling) {
  for (int a = 0; a < 2; ++a) {
    const double reach = (1.0 - grid.particle_half_size()) * grid.extent().spacing[a];
    particles.position[a][index] += uniform(-reach, reach);
    particles.velocity[a][index] = uniform(-1.0, 1.0);
  }
  for (auto& stress : particles.stress) {
    stress[index] = uniform(-filling.initial_stress, filling.initial_stress);
  }
  particles.volume[index] = uniform(0.5, 1.5) * 0.25 * kCell * kCell;
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
void RandomState::set_damage(std::size_t index) {
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

void RandomState::randomise_nodes() {
  kernels::GridView<2> view = grid.view();
  for (std::ptrdiff_t n = 0; n < grid.rows() * grid.row_stride(); ++n) {
    const bool empty = uniform(0.0, 1.0) < 0.1;
    view.mass[n] = empty ? 0.0 : uniform(1e-6, 6e-4);
    for (int a = 0; a < 2; ++a) {
      view.momentum[a][n] = empty ? 0.0 : uniform(-1.0, 1.0) * view.mass[n];
      view.force[a][n] = empty ? 0.0 : uniform(-1e3, 1e3);
      view.second_field[a][n] = empty ? 0.0 : uniform(-1.0, 1.0);
    }
    if (uniform(0.0, 1.0) < 0.1) {
      grid.clear_damping(n);
    }
  }
}

double RandomState::uniform(double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random_);
}

}  // namespace rgimp::tests
