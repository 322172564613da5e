#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "rgimp/case.hpp"
#include "rgimp/simulation.hpp"

namespace rgimp {

/// What the particles are on the nodes of the background grid: smooth fields for contours, sections
/// and comparisons with other codes. Node (i, j, k) is at origin + (i, j, k) * spacing and at
/// i + nodes[0] * (j + nodes[1] * k) in each field. Nodes that no particle reaches hold zeros.
struct GridFields {
  /// At whose end.
  std::int64_t step = 0;
  double time = 0.0;                            ///< s
  Vector origin = Vector::Zero();               ///< m
  Vector spacing = Vector::Zero();              ///< m, edges of a cell; they follow platens
  std::array<std::int64_t, 3> nodes{};          ///< per axis; 1 along z in 2D
  std::vector<double> mass;                     ///< kg (2D: per metre of thickness)
  std::vector<std::array<double, 3>> velocity;  ///< m/s, momentum over mass
  std::vector<std::array<double, 6>> stress;    ///< Pa; xx, yy, zz, xy, yz, xz; tension > 0
  std::vector<double> damage;                   ///< 1, share of the strength lost
  /// Particles in no place that the grid reaches, such as one that stopped a run: they count in no
  /// field.
  std::size_t particles_outside = 0;
};

/// The fields of a case's particles after `step` steps, with the weights of Eq. 18 and 19: mass is
/// scattered as in a step, velocity averaged over mass, stress and damage over the volumes of step
/// 0. Throws CaseError for an id that the case does not have.
GridFields grid_fields(const Case& settings, const ParticleTable& particles, std::int64_t step);

/// Writes them as VTKHDF 1.0 image data, which VTK >= 9.1 opens, and any HDF5
/// reader: arrays of shape (z, y, x) or (z, y, x, component). Planes become slabs of two equal
/// layers of nodes, a cell apart: VTK 9.1 crashes at one. Throws FileError; then no file is left.
void write_grid_fields(const std::filesystem::path& path, const GridFields& fields);

/// What write_grids wrote.
struct WrittenGrids {
  /// In order of their steps.
  std::vector<std::filesystem::path> files;
  std::size_t particles_outside = 0;  ///< of the last file
};

/// Writes the fields of every snapshot of an output directory of run_case, or of the one of `step`,
/// to grid/step_*.vtkhdf in it, and a list with their times for ParaView beside them. Throws as
/// read_results does, and CaseError where there is no snapshot of that step.
WrittenGrids write_grids(const std::filesystem::path& directory,
                         std::optional<std::int64_t> step = std::nullopt);

}  // namespace rgimp
