#pragma once

#include <string>

#include "rgimp/case.hpp"
#include "rgimp/kernels/table.hpp"

namespace rgimp::bench {

/// Where the particles lie: as the case seeds them, or each in the place of one drawn at random,
/// so that bins hold a Poisson number of them.
enum class Arrangement { lattice, random };

/// One way to compute steps of example 1, everything on.
struct Setting {
  kernels::Isa isa = kernels::Isa::reference;
  int threads = 1;
  Integrator integrator = Integrator::musl;
  Arrangement arrangement = Arrangement::lattice;
  int cells_across = 100;  ///< of the specimen's width; about 8 particles per square of it
};

inline constexpr int kThreadCounts[] = {1, 2};
inline constexpr Integrator kAllIntegrators[] = {Integrator::musl, Integrator::usl,
                                                 Integrator::usf};

/// "cells:100/particles:lattice/integrator:musl/isa:avx2/threads:2", as report.py reads it.
std::string name(const Setting& setting);

/// Example 1 at the setting's resolution, so slow that nothing fails however long it is timed.
Case example_1(const Setting& setting);

}  // namespace rgimp::bench
