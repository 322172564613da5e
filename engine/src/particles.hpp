#pragma once

#include <array>
#include <cstdint>
#include <limits>

#include "column.hpp"
#include "rgimp/kernels/views.hpp"

namespace rgimp {

/// All particles, struct-of-arrays; layout and units as in kernels::ParticleView.
template <int Dim>
struct Particles {
  static constexpr int kStress = kernels::kStressComponents<Dim>;
  static constexpr std::uint32_t kNoId = std::numeric_limits<std::uint32_t>::max();

  /// Of a lane in all columns but `damage`.
  static constexpr std::size_t kLaneBytes =
      (2 * Dim + kStress + 4) * sizeof(double) + sizeof(std::int32_t) + sizeof(std::uint32_t);

  std::array<Column<double>, Dim> position;
  std::array<Column<double>, Dim> velocity;
  std::array<Column<double>, kStress> stress;
  Column<double> volume;
  Column<double> mass;
  Column<double> viscous_energy;
  Column<double> failure_mode;
  Column<double> damage;  ///< empty where no material softens
  Column<std::int32_t> failure_step;
  Column<std::uint32_t> id;  ///< kNoId in padding

  Column<std::uint32_t> group_begin;
  Column<std::uint8_t> slot_material;
  std::size_t count = 0;  ///< without padding

  bool is_padding(std::size_t index) const { return id[index] == kNoId; }
  std::size_t lanes() const { return id.size(); }

  /// Calls visit(column, value in padding) for every column that travels with a particle. Padding
  /// positions are set by the binning, which knows the lanes' nodes.
  template <typename Visit>
  void for_each_column(Visit visit) {
    for (auto& column : position) {
      visit(column, 0.0);
    }
    for (auto& column : velocity) {
      visit(column, 0.0);
    }
    for (auto& column : stress) {
      visit(column, 0.0);
    }
    visit(volume, 0.0);
    visit(mass, 0.0);
    visit(viscous_energy, 0.0);
    visit(failure_mode, kernels::kPadding);
    if (!damage.empty()) {
      visit(damage, 0.0);
    }
    visit(failure_step, std::int32_t{-1});
    visit(id, kNoId);
  }

  /// Leaves padding in the particle's lane.
  void remove(std::size_t lane) {
    for_each_column([lane](auto& column, auto padding) { column[lane] = padding; });
    --count;
  }

  kernels::ParticleView<Dim> view() {
    kernels::ParticleView<Dim> v{};
    for (int a = 0; a < Dim; ++a) {
      v.position[a] = position[a].data();
      v.velocity[a] = velocity[a].data();
    }
    for (int c = 0; c < kStress; ++c) {
      v.stress[c] = stress[c].data();
    }
    v.volume = volume.data();
    v.mass = mass.data();
    v.viscous_energy = viscous_energy.data();
    v.failure_mode = failure_mode.data();
    v.damage = damage.data();
    v.failure_step = failure_step.data();
    v.group_begin = group_begin.data();
    v.slot_material = slot_material.data();
    return v;
  }
};

}  // namespace rgimp
