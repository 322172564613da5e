#pragma once

#include <cstdint>

#include "manufactured_solution.hpp"

namespace rgimp::verification {

/// How far a run was from a manufactured solution: root mean squares over the particles, the
/// largest of all steps, as parts of the solution's largest displacement and stress.
struct ManufacturedErrors {
  double displacement = 0.0;
  double stress = 0.0;
  std::int64_t particles = 0;
  std::int64_t steps = 0;
};

/// Runs the solution's case under its body force for its duration. Velocities start half a step
/// early, where a leapfrog has them: started at t = 0 they cost an order. Throws PhysicsError.
ManufacturedErrors run_manufactured(const ManufacturedSolution& solution,
                                    const Resolution& resolution);

}  // namespace rgimp::verification
