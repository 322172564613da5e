#pragma once

#include <cstdint>
#include <vector>

#include "particles.hpp"
#include "rgimp/extension.hpp"
#include "workers.hpp"

namespace rgimp {

/// What an own criterion did in a step.
struct OwnFailures {
  std::int64_t tension = 0;      ///< particles that failed
  std::int64_t shear = 0;        ///< likewise
  double released_energy = 0.0;  ///< J
};

/// Asks `criterion` about every particle that has not failed, and treats those that fail as the
/// kernels do. Whatever the threads, sums are the same bits.
template <int Dim>
OwnFailures fail_by(const FailureCriterion& criterion, Particles<Dim>& particles,
                    const std::vector<kernels::MaterialConstants>& materials, std::int32_t step,
                    Workers& workers);

}  // namespace rgimp
