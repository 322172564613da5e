#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "rgimp/case.hpp"
#include "workers.hpp"

/// From the shapes of a case to its grid and particles.
namespace rgimp {

/// An axis-aligned box, m.
struct Box {
  Vector min = Vector::Zero();
  Vector max = Vector::Zero();
};

Box bounds(const Body& body);
/// Of all bodies together.
Box bounds(const Case& settings);

/// Where the grid lies: node (i, j, k) is at origin + (i, j, k) * spacing, axis by axis.
struct GridExtent {
  Vector origin = Vector::Zero();       ///< m
  Vector spacing = Vector::Zero();      ///< m, edges of a cell
  std::array<std::int64_t, 3> nodes{};  ///< per axis; 1 along z in 2D
};

GridExtent grid_extent(const Case& settings);

/// A particle before the first step.
struct ParticleSeed {
  Vector position = Vector::Zero();  ///< m
  Vector velocity = Vector::Zero();  ///< m/s
  double volume = 0.0;               ///< m3 (2D: m2, unit thickness)
  double mass = 0.0;                 ///< kg (2D: per metre)
  std::uint8_t material = 0;         ///< index in the order of Case::materials
};

/// Particles on a lattice centred in the cells that start at each body's lower corner, those
/// inside a flaw left out. Body by body, rows of rising x within rising y within rising z; ids are
/// indices.
///
/// All are whole. Fitting volume and centre of those along a face to the rock nearest them was
/// tried: 9 to 11 % of the compliance of example 1's flaw, two cells wide, were missing instead of
/// 26 %, but first failure scattered more with the place of the flaw in the grid (26 % for 22 %)
/// and came at a still lower load (0.687 MPa for 0.781, where finite elements say 1.155 or more).
std::vector<ParticleSeed> seed_particles(const Case& settings);

/// Seeds in parts, each of which goes on where the one before ends.
using SeedParts = std::vector<std::vector<ParticleSeed>>;

/// The same, found by all threads.
SeedParts seed_particles(const Case& settings, Workers& workers);

}  // namespace rgimp
