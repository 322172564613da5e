#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "rgimp/case.hpp"
#include "rgimp/simulation.hpp"

/// The failed particles of a state, as the measuring of cracks needs them.
namespace rgimp {

struct FailedParticle {
  std::int64_t step = 0;
  Vector position = Vector::Zero();         ///< m, at step 0
  double distance = 0.0;                    ///< m, from the nearest flaw; infinite without flaws
  std::optional<std::size_t> nearest_flaw;  ///< none without flaws
  std::optional<std::size_t> flaw;          ///< that one, if it is within one cell
  std::optional<std::size_t> source;        ///< the nearest CrackSource of that flaw
};

/// In the order in which they failed, ties by id, without their sources. Throws CaseError where the
/// particles are not those of the case.
std::vector<FailedParticle> failed_particles(const Case& settings, const ParticleTable& particles);

/// m, the finest of the particles' lattices.
double finest_pitch(const Case& settings);

}  // namespace rgimp
