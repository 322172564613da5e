#include "particle_table.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

#include "state_hash.hpp"

namespace rgimp {
namespace {

double max_principal_in_plane(const std::array<double, 6>& s) {
  const double centre = 0.5 * (s[0] + s[1]);
  const double radius = std::hypot(0.5 * (s[0] - s[1]), s[3]);
  return std::max(centre + radius, s[2]);
}

double max_principal(const std::array<double, 6>& s) {
  Eigen::Matrix3d tensor;
  tensor << s[0], s[3], s[5], s[3], s[1], s[4], s[5], s[4], s[2];
  // Its closed form would be faster, but loses half the digits where two are equal.
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(tensor, Eigen::EigenvaluesOnly);
  return solver.eigenvalues()[2];
}

FailureMode failure_mode(double mode) {
  if (mode == kernels::kFailedInTension) {
    return FailureMode::tension;
  }
  return mode == kernels::kFailedInShear ? FailureMode::shear : FailureMode::intact;
}

template <typename Value>
std::span<const Value> span_of(const Column<Value>& column) {
  return {column.data(), column.size()};
}

}  // namespace

template <int Dim>
ParticleTable table_of(const Particles<Dim>& p) {
  ParticleTable table;
  const auto reserve = [&](auto&... columns) { (columns.reserve(p.count), ...); };
  reserve(table.id, table.position, table.velocity, table.stress, table.max_principal_stress,
          table.failed, table.damage, table.failure_step);
  for (const std::size_t i : lanes_by_id(p)) {
    std::array<double, 3> position{};
    std::array<double, 3> velocity{};
    for (int a = 0; a < Dim; ++a) {
      position[a] = p.position[a][i];
      velocity[a] = p.velocity[a][i];
    }
    std::array<double, 6> stress{};
    for (int c = 0; c < Particles<Dim>::kStress; ++c) {
      stress[c] = p.stress[c][i];
    }
    table.id.push_back(p.id[i]);
    table.position.push_back(position);
    table.velocity.push_back(velocity);
    table.stress.push_back(stress);
    table.max_principal_stress.push_back(Dim == 2 ? max_principal_in_plane(stress)
                                                  : max_principal(stress));
    table.failed.push_back(failure_mode(p.failure_mode[i]));
    table.damage.push_back(p.failure_mode[i] >= kernels::kFailedInTension ? 1.0
                           : p.damage.empty()                             ? 0.0
                                                                          : p.damage[i]);
    table.failure_step.push_back(p.failure_step[i]);
  }
  return table;
}

template <int Dim>
ParticleColumns columns_of(const Particles<Dim>& p) {
  static_assert(ParticleColumns::no_id == Particles<Dim>::kNoId);
  ParticleColumns columns;
  for (int a = 0; a < Dim; ++a) {
    columns.position[a] = span_of(p.position[a]);
    columns.velocity[a] = span_of(p.velocity[a]);
  }
  for (int c = 0; c < Particles<Dim>::kStress; ++c) {
    columns.stress[c] = span_of(p.stress[c]);
  }
  columns.volume = span_of(p.volume);
  columns.mass = span_of(p.mass);
  columns.failed = span_of(p.failure_mode);
  columns.damage = span_of(p.damage);
  columns.failure_step = span_of(p.failure_step);
  columns.id = span_of(p.id);
  return columns;
}

template ParticleTable table_of<2>(const Particles<2>&);
template ParticleTable table_of<3>(const Particles<3>&);
template ParticleColumns columns_of<2>(const Particles<2>&);
template ParticleColumns columns_of<3>(const Particles<3>&);

}  // namespace rgimp
