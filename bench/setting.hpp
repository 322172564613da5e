#pragma once

#include <string>

#include "rgimp/case.hpp"
#include "rgimp/kernels/table.hpp"

namespace rgimp::bench {

/// Where the particles lie: as the case seeds them, or each in the place of one drawn at random,
/// so that bins hold a Poisson number of them.
enum class Arrangement { lattice, random };

/// One way to compute steps of example 1, or in three dimensions of a cube with a penny under the
/// same load; everything on.
struct Setting {
  int dimension = 2;
  kernels::Isa isa = kernels::Isa::reference;
  int threads = 1;
  Integrator integrator = Integrator::musl;
  Arrangement arrangement = Arrangement::lattice;
  /// Of the specimen's width; about 8 particles per square of it, in three dimensions per cube.
  int cells_across = 100;
};

inline constexpr int kThreadCounts[] = {1, 2};
inline constexpr Integrator kAllIntegrators[] = {Integrator::musl, Integrator::usl,
                                                 Integrator::usf};

/// "cells:100/particles:lattice/integrator:musl/isa:avx2/threads:2", as report.py reads it. The
/// dimension is in a benchmark's prefix.
std::string name(const Setting& setting);

/// The setting's case at its resolution, so slow that nothing fails however long it is timed.
Case case_of(const Setting& setting);

}  // namespace rgimp::bench
