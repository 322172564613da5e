#pragma once

#include "rgimp/kernels/views.hpp"

namespace rgimp::kernels {

/// What a kernel is compiled for; `reference` are the scalar twins.
enum class Isa { reference, baseline, avx2, avx512 };

/// The kernels of one ISA. A pass reads and writes each particle of its bins once: it gathers from
/// `from`, updates the particle and scatters what it has become to `to`, whose fields of that kind
/// must be others than those gathered; the two grids may differ in origin and spacing. Scatters add
/// to node rows one below to one above their bin rows. Weights are those of the positions at the
/// time: gathers before, scatters after the move.
template <int Dim>
struct KernelTable {
  using Particles = ParticleView<Dim>;
  using Grid = GridView<Dim>;
  using Scatter = void (*)(const Particles&, const Grid& to, RowRange bins);
  using Pass = void (*)(const Particles&, const Grid& from, const Grid& to, const ParticleUpdate&,
                        RowRange bins);

  /// particle mass, velocity, stress, viscous energy -> node mass, momentum, force [Eq. 8-10]
  Scatter scatter_all;
  /// particle mass, velocity -> node mass, momentum [Eq. 8, 9]
  Scatter scatter_mass_momentum;

  /// MUSL, first pass: acceleration -> particle velocity += dt S a -> second field, as momentum
  /// [Eq. 6, 8]
  Pass accelerate;
  /// MUSL, second pass: second field (velocity) -> particle stress, volume, viscous energy,
  /// failure; velocity -> particle position += dt S v; then as scatter_all [Eq. 20, 21, 6, 8-10]
  Pass strain_and_move;
  /// USL: accelerate, strain with the velocity at the end of the step, move, then as scatter_all
  Pass accelerate_strain_and_move;
  /// USF, first pass: second field (velocity) -> particle stress, volume, viscous energy, failure
  /// -> force [Eq. 20, 21, 10]
  Pass strain;
  /// USF, second pass: accelerate, move, then as scatter_mass_momentum [Eq. 6, 8, 9]
  Pass accelerate_and_move;

  /// node mass, momentum, force -> acceleration (in force), velocity (in momentum), with body
  /// force and local damping [Eq. 7, 11]; one NodeSums per row of the grid
  void (*update_nodes)(const Grid&, const NodeUpdate<Dim>&, RowRange nodes, NodeSums* by_row);
  /// node mass, `momentum` -> second field = momentum / mass [Eq. 8]; in place is allowed
  void (*divide_by_mass)(const Grid&, const double* const* momentum, double least_mass,
                         RowRange nodes);
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
