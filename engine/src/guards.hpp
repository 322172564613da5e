#pragma once

#include <cstdint>
#include <vector>

#include "particles.hpp"
#include "workers.hpp"

/// Guards against physics gone wrong: they look, and stop with a PhysicsError that names the
/// particle with the lowest id, so that the message does not depend on threads.
namespace rgimp {

/// The step whose state is looked at.
struct GuardedStep {
  std::int64_t number = 0;
  double dt = 0.0;                   ///< s
  double critical_step_ratio = 0.0;  ///< dt/dt_cr
  double max_speed = 0.0;            ///< m/s, of a particle's move
};

/// The full check reads 12 columns of every particle, 96 bytes, where a MUSL step moves 216: done
/// every so many steps it costs 0.1 % of their memory traffic. Re-binning alone would be too
/// late: in example 1 no particle ever drifts far enough for one in 222,440 steps.
inline constexpr std::int64_t kFullCheckEvery = 500;  // steps

/// Stops where a value of a particle is not finite or a volume not positive.
template <int Dim>
void stop_if_broken(Particles<Dim>& particles, const GuardedStep& step, Workers& workers);

/// Stops where the time step has become longer than the critical one, Eq. 22.
template <int Dim>
void stop_if_too_fast(const Particles<Dim>& particles, const GuardedStep& step);

/// Stops for sums over particles or nodes that are not finite while every particle is.
template <int Dim>
[[noreturn]] void stop_at_lost_energies(const Particles<Dim>& particles, const GuardedStep& step);

/// Stops for particles that are not inside the grid; `lanes` in order of id.
template <int Dim>
[[noreturn]] void stop_outside(const Particles<Dim>& particles,
                               const std::vector<std::size_t>& lanes, const GuardedStep& step);

}  // namespace rgimp
