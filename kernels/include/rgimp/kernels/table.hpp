#pragma once

#include "rgimp/kernels/views.hpp"

namespace rgimp::kernels {

/// What a kernel is compiled for; `reference` are the scalar twins.
enum class Isa { reference, baseline, avx2, avx512 };

/// The kernels of one ISA. Scatters add to node rows one below to one above their bin rows; the
/// others touch only their own rows. Weights are those of the particles' present positions.
template <int Dim>
struct KernelTable {
  using Particles = ParticleView<Dim>;
  using Grid = GridView<Dim>;

  /// particle mass, velocity, stress, viscous energy -> node mass, momentum, force [Eq. 8-10]
  void (*scatter_all)(const Particles&, const Grid&, RowRange bins);
  /// particle mass, velocity -> node mass, momentum [Eq. 8, 9]
  void (*scatter_mass_momentum)(const Particles&, const Grid&, RowRange bins);
  /// particle stress, viscous energy -> node force [Eq. 10]
  void (*scatter_force)(const Particles&, const Grid&, RowRange bins);
  /// particle mass, velocity -> second field, as momentum [Eq. 8]
  void (*scatter_second_momentum)(const Particles&, const Grid&, RowRange bins);

  /// node mass, momentum, force -> acceleration (in force), velocity (in momentum), with body
  /// force and local damping [Eq. 7, 11]; one NodeSums per row of the grid
  void (*update_nodes)(const Grid&, const NodeUpdate<Dim>&, RowRange nodes, NodeSums* by_row);
  /// node mass, `momentum` -> second field = momentum / mass [Eq. 8]; in place is allowed
  void (*divide_by_mass)(const Grid&, const double* const* momentum, double least_mass,
                         RowRange nodes);

  /// acceleration -> particle velocity += dt S a [Eq. 6]
  void (*gather_velocity)(const Particles&, const Grid&, double dt, RowRange bins);
  /// velocity at the end of the step -> particle position += dt S v [Eq. 6]
  void (*gather_position)(const Particles&, const Grid&, double dt, RowRange bins);
  /// `field` (node velocity) -> particle stress, volume, viscous energy, failure [Eq. 20, 21];
  /// one ParticleSums per row of the grid
  void (*update_stress)(const Particles&, const Grid&, const double* const* field,
                        const MaterialConstants* materials, double dt, std::int32_t step,
                        RowRange bins, ParticleSums* by_row);
};

inline constexpr Isa kAllIsas[] = {Isa::reference, Isa::baseline, Isa::avx2, Isa::avx512};

/// Whether this machine, and its operating system, run it.
bool available(Isa isa);
/// The fastest that this machine has.
Isa best_isa();
const char* name(Isa isa);

template <int Dim>
const KernelTable<Dim>& kernels_for(Isa isa);

}  // namespace rgimp::kernels
