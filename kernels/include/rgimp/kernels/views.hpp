#pragma once

#include <cstddef>
#include <cstdint>

/// Raw views of particles and grid that the kernels read and write. They own nothing, and hold
/// plain pointers only, so that translation units compiled for different ISAs share no code.
namespace rgimp::kernels {

/// Lanes of a group on every ISA, so that sums have one order everywhere.
inline constexpr int kGroupWidth = 8;

/// xx, yy, zz, xy in plane strain; xx, yy, zz, xy, yz, xz in three dimensions.
template <int Dim>
inline constexpr int kStressComponents = Dim == 2 ? 4 : 6;

/// Where the stress columns hold component (a, b). Internal to each unit, unlike an inline
/// variable.
constexpr int kStressColumn[3][3] = {{0, 3, 5}, {3, 1, 4}, {5, 4, 2}};

/// Values of ParticleView::failure_mode; a double so that a kernel loads it like any column.
inline constexpr double kIntact = 0.0;
/// Between intact and failed, so that one comparison finds what is not intact, or what has failed.
inline constexpr double kSofteningInTension = 0.25;
inline constexpr double kSofteningInShear = 0.5;
inline constexpr double kFailedInTension = 1.0;
inline constexpr double kFailedInShear = 2.0;
/// A lane without a particle: no mass, no volume, and it never fails.
inline constexpr double kPadding = -1.0;

/// Particles as columns, sorted by bin (nearest node) in groups of eight bins of a grid row.
/// Entry 8 * slot + lane of a column is one particle of bin 8 * group + lane of its row, for the
/// slots group_begin[group] to group_begin[group + 1]; empty lanes are padding.
template <int Dim>
struct ParticleView {
  double* position[Dim];                   ///< m
  double* velocity[Dim];                   ///< m/s
  double* stress[kStressComponents<Dim>];  ///< Pa, tension > 0
  double* volume;                          ///< m3 (2D: m2)
  double* mass;                            ///< kg (2D: kg/m)
  double* viscous_energy;                  ///< J, bulk viscous pressure times volume, >= 0
  double* failure_mode;                    ///< one of the modes above, or kPadding
  /// 1, share of the strength lost, 1 where failed; only materials that soften read or write it,
  /// and it is null where there are none.
  double* damage;
  std::int32_t* failure_step;         ///< step at whose end the point had failed
  const std::uint32_t* group_begin;   ///< first slot of each group, and one past the last
  const std::uint8_t* slot_material;  ///< index of the one material of a slot
};

/// Node fields, x fastest. A row is the nodes along x, padded to whole groups; rows follow each
/// other along y, then z. Eight readable doubles lie before and after each field.
template <int Dim>
struct GridView {
  double origin[Dim];         ///< m, node 0
  double spacing[Dim];        ///< m, edges of a cell, L of the paper
  double particle_half_size;  ///< cells, l of the paper over L
  std::ptrdiff_t groups_in_row;
  std::ptrdiff_t rows_in_plane;  ///< nodes along y
  double* mass;                  ///< kg
  double* momentum[Dim];         ///< kg m/s; velocity at the end of the step after update_nodes
  double* force[Dim];            ///< N; acceleration after update_nodes
  double* second_field[Dim];     ///< momentum, then velocity, of the field that strains come from
  const double* damping;         ///< 1, beta of local damping, 0 at platen nodes
};

/// Rows of nodes, or of the bins around them: first to one past the last.
struct RowRange {
  std::ptrdiff_t first;
  std::ptrdiff_t last;
};

/// Limits that every criterion of the paper's section 3.1 reduces to; infinite where a criterion
/// does not look. Failed in tension: s1 >= tension + tension_per_trace tr s, or
/// tr s >= trace. Else failed in shear: shear_major s1 - shear_minor s3 >= shear.
struct FailureLimits {
  double tension;            ///< Pa
  double tension_per_trace;  ///< 1
  double trace;              ///< Pa
  double shear_major;        ///< 1, > 0
  double shear_minor;        ///< 1, > 0
  double shear;              ///< Pa
};

/// Softening by fracture energy (a crack band). 1 / eta of a band one cell wide: the strain at the
/// limit over the one at which nothing is left. 1: fails at once, the paper's rule.
struct Softening {
  double tension;
  double shear;
};

struct MaterialConstants {
  double lambda;  ///< Pa, Lame's first
  double shear_modulus;
  double quadratic_viscosity;  ///< m2, c0 L^2
  double linear_viscosity;     ///< m2/s, c1 L c
  double energy_of_square;     ///< 1/Pa, (1 + nu) / (2 E): energy density per s : s
  double energy_of_trace;      ///< 1/Pa, nu / (2 E): energy density per -(tr s)^2
  FailureLimits limits;
  Softening softening;
  bool softens;                ///< whether either is less than 1
  double failed_pressure_min;  ///< Pa, what a failed point still carries: p clamped to these
  double failed_pressure_max;
};

/// What a row of nodes adds to the energy budget in a step.
struct NodeSums {
  double damping_work;     ///< J
  double body_force_work;  ///< J
};

/// The farthest and the fastest particle of a row of bins.
struct Reach {
  double distance;  ///< cells of the grid scattered to, from its bin's node along any axis
  double step;      ///< m, moved in this step
};

/// What a row of bins adds to the energy budget in a step.
struct ParticleSums {
  double viscous_work;     ///< J
  double released_energy;  ///< J
  std::int64_t failed_tension;
  std::int64_t failed_shear;
};

/// What a pass over the particles needs besides them and the grid; the rows of the two sums are
/// those of the grid, and a pass that does not find them leaves them alone.
struct ParticleUpdate {
  double dt = 0.0;                               ///< s
  std::int32_t step = 0;                         ///< at whose end particles fail
  const MaterialConstants* materials = nullptr;  ///< by slot_material
  ParticleSums* sums = nullptr;                  ///< one per row
  Reach* reach = nullptr;                        ///< one per row
};

/// What update_nodes needs besides the grid.
template <int Dim>
struct NodeUpdate {
  double dt;                      ///< s
  double least_mass;              ///< kg, lighter nodes are skipped
  double body_acceleration[Dim];  ///< m/s2
};

}  // namespace rgimp::kernels
