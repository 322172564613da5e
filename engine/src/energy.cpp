#include "energy.hpp"

#include <algorithm>

namespace rgimp {
namespace {

using kernels::kGroupWidth;

/// Lanes are summed side by side and only then together: the compiler may keep them in registers.
struct LaneSums {
  double kinetic[kGroupWidth] = {};
  double strain[kGroupWidth] = {};
};

/// What a softening point holds beyond sigma : C^-1 : sigma / 2 of its nominal stress, J/m3. It
/// gives back sigma : C^-1 : s / 2, s = sigma / (1 - D) but for pressure, which is not reduced.
template <int Dim>
double beyond_nominal(const kernels::ParticleView<Dim>& p, std::size_t i, double nominal,
                      double trace, const kernels::MaterialConstants& material) {
  const bool softening =
      p.failure_mode[i] > kernels::kIntact && p.failure_mode[i] < kernels::kFailedInTension;
  if (!softening) {
    return 0.0;
  }
  const double closing = std::min(trace, 0.0);
  const double pressure_part =
      (material.energy_of_square / 3.0 - material.energy_of_trace) * closing * closing;
  return (nominal - pressure_part) * p.damage[i] / (1.0 - p.damage[i]);
}

template <int Dim>
void add_slot(const kernels::ParticleView<Dim>& p, std::size_t slot,
              const kernels::MaterialConstants& material, LaneSums& sums) {
  for (int lane = 0; lane < kGroupWidth; ++lane) {
    const std::size_t i = slot * kGroupWidth + static_cast<std::size_t>(lane);
    double speed2 = 0.0;
    for (int a = 0; a < Dim; ++a) {
      speed2 += p.velocity[a][i] * p.velocity[a][i];
    }
    double square = 0.0;
    double trace = 0.0;
    for (int c = 0; c < kernels::kStressComponents<Dim>; ++c) {
      const double s = p.stress[c][i];
      square += (c < 3 ? 1.0 : 2.0) * s * s;
      trace += c < 3 ? s : 0.0;
    }
    sums.kinetic[lane] += 0.5 * p.mass[i] * speed2;
    const double nominal =
        material.energy_of_square * square - material.energy_of_trace * trace * trace;
    sums.strain[lane] += p.volume[i] * nominal;
    if (material.softens) {
      sums.strain[lane] += p.volume[i] * beyond_nominal(p, i, nominal, trace, material);
    }
  }
}

/// `group_begin` is that of the row's first group.
template <int Dim>
StoredEnergy energy_of_row(const kernels::ParticleView<Dim>& view, const std::uint32_t* group_begin,
                           std::ptrdiff_t groups,
                           const std::vector<kernels::MaterialConstants>& materials) {
  LaneSums sums;
  for (std::size_t slot = group_begin[0]; slot < group_begin[groups]; ++slot) {
    add_slot(view, slot, materials[view.slot_material[slot]], sums);
  }
  StoredEnergy energy;
  for (int lane = 0; lane < kGroupWidth; ++lane) {
    energy.kinetic += sums.kinetic[lane];
    energy.strain += sums.strain[lane];
  }
  return energy;
}

}  // namespace

template <int Dim>
StoredEnergy stored_energy(Particles<Dim>& particles, std::ptrdiff_t groups_in_row,
                           std::ptrdiff_t rows,
                           const std::vector<kernels::MaterialConstants>& materials,
                           Workers& workers) {
  const kernels::ParticleView<Dim> view = particles.view();
  std::vector<StoredEnergy> by_row(static_cast<std::size_t>(rows));
  constexpr std::ptrdiff_t kRowsAtATime = 64;
  workers.for_each((rows + kRowsAtATime - 1) / kRowsAtATime, [&](std::ptrdiff_t chunk) {
    const std::ptrdiff_t last = std::min(rows, (chunk + 1) * kRowsAtATime);
    for (std::ptrdiff_t row = chunk * kRowsAtATime; row < last; ++row) {
      by_row[row] =
          energy_of_row(view, view.group_begin + row * groups_in_row, groups_in_row, materials);
    }
  });
  StoredEnergy total;
  for (const StoredEnergy& row : by_row) {
    total.kinetic += row.kinetic;
    total.strain += row.strain;
  }
  return total;
}

template <int Dim>
StoredEnergy energy_of_lane(Particles<Dim>& particles, std::size_t lane,
                            const std::vector<kernels::MaterialConstants>& materials) {
  const std::size_t slot = lane / kGroupWidth;
  LaneSums sums;
  add_slot(particles.view(), slot, materials[particles.slot_material[slot]], sums);
  return {sums.kinetic[lane % kGroupWidth], sums.strain[lane % kGroupWidth]};
}

template StoredEnergy energy_of_lane<2>(Particles<2>&, std::size_t,
                                        const std::vector<kernels::MaterialConstants>&);
template StoredEnergy stored_energy<2>(Particles<2>&, std::ptrdiff_t, std::ptrdiff_t,
                                       const std::vector<kernels::MaterialConstants>&, Workers&);
template StoredEnergy energy_of_lane<3>(Particles<3>&, std::size_t,
                                        const std::vector<kernels::MaterialConstants>&);
template StoredEnergy stored_energy<3>(Particles<3>&, std::ptrdiff_t, std::ptrdiff_t,
                                       const std::vector<kernels::MaterialConstants>&, Workers&);

}  // namespace rgimp
