#pragma once

#include <cstdint>
#include <vector>

#include "particles.hpp"
#include "workers.hpp"

namespace rgimp {

/// What entered and left the specimen since the first step, J (2D: per metre of thickness).
struct EnergyBudget {
  double external_work = 0.0;    ///< by platens and body force
  double damping_work = 0.0;     ///< taken by local damping
  double viscous_work = 0.0;     ///< taken by bulk viscosity
  double released_energy = 0.0;  ///< strain energy dropped by failure and damage
};

/// Energies the particles hold now, J.
struct StoredEnergy {
  double kinetic = 0.0;
  double strain = 0.0;  ///< sum of V sigma : C^-1 : s / 2, s the effective stress
};

/// Summed row by row in a fixed order, so that it does not depend on threads.
template <int Dim>
StoredEnergy stored_energy(Particles<Dim>& particles, std::ptrdiff_t groups_in_row,
                           std::ptrdiff_t rows,
                           const std::vector<kernels::MaterialConstants>& materials,
                           Workers& workers);

/// What the particle of one lane holds.
template <int Dim>
StoredEnergy energy_of_lane(Particles<Dim>& particles, std::size_t lane,
                            const std::vector<kernels::MaterialConstants>& materials);

}  // namespace rgimp
