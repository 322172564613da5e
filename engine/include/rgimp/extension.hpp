#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>

#include "rgimp/case.hpp"

/// What a program can put into a simulation that a case cannot express; see Simulation's
/// set_initial_state, set_acceleration and set_criterion. Whatever is set, results are the same
/// bits for any number of threads, as long as these functions return the same for the same
/// arguments.
namespace rgimp {

/// How a particle failed, if it did.
enum class FailureMode : std::uint8_t { intact = 0, tension = 1, shear = 2 };

/// Motion and stress of a particle before the first step.
struct InitialState {
  Vector velocity = Vector::Zero();                  ///< m/s; in 2D z is 0
  Eigen::Matrix3d stress = Eigen::Matrix3d::Zero();  ///< Pa, symmetric, tension > 0; in 2D xz, yz 0
};

/// The initial state of the particle at a position, m.
using InitialField = std::function<InitialState(const Vector& position)>;

/// An acceleration, m/s2, at a position, m, and a time, s. Called for every node that has mass, in
/// every step, by the threads of the simulation at once: it must not write to what others read.
using AccelerationField = std::function<Vector(const Vector& position, double time)>;

/// A particle that has not failed, as a criterion sees it at the end of a step.
struct IntactParticle {
  std::uint32_t id = 0;                              ///< of step 0
  Vector position = Vector::Zero();                  ///< m
  Eigen::Matrix3d stress = Eigen::Matrix3d::Zero();  ///< Pa, tension > 0
};

/// How a particle fails now. Called for every intact particle after every step, by the threads of
/// the simulation at once: it must not write to what others read.
using FailureCriterion = std::function<FailureMode(const IntactParticle&)>;

}  // namespace rgimp
