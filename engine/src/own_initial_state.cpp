#include "own_initial_state.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "rgimp/error.hpp"

namespace rgimp {
namespace {

Vector position_at(const auto& columns, std::size_t lane) {
  Vector position = Vector::Zero();
  for (std::size_t a = 0; a < columns.size(); ++a) {
    position[static_cast<Eigen::Index>(a)] = columns[a][lane];
  }
  return position;
}

/// What is wrong with a state, if anything.
const char* fault_of(const InitialState& state, int dimension) {
  constexpr double kSymmetric = 1e-9;
  if (!state.velocity.allFinite() || !state.stress.allFinite()) {
    return "a value that is not finite";
  }
  if (!state.stress.isApprox(state.stress.transpose(), kSymmetric)) {
    return "a stress that is not symmetric";
  }
  if (dimension == 2 &&
      (state.velocity.z() != 0.0 || state.stress(0, 2) != 0.0 || state.stress(1, 2) != 0.0)) {
    return "a component out of the plane in two dimensions";
  }
  return nullptr;
}

}  // namespace

template <int Dim>
double set_initial_state(const InitialField& field, std::int64_t steps_done,
                         Particles<Dim>& particles) {
  if (steps_done > 0) {
    throw CaseError(fmt::format("initial state: {} steps are done, expected none", steps_done));
  }
  if (!field) {
    throw CaseError("initial state: an empty function, expected one of the position");
  }
  std::vector<InitialState> states(particles.lanes());
  for (std::size_t lane = 0; lane < states.size(); ++lane) {
    if (particles.is_padding(lane)) {
      continue;
    }
    const Vector position = position_at(particles.position, lane);
    states[lane] = field(position);
    if (const char* fault = fault_of(states[lane], Dim)) {
      throw CaseError(fmt::format("initial state: {} at ({:.6g}, {:.6g}, {:.6g}) m", fault,
                                  position.x(), position.y(), position.z()));
    }
  }
  double fastest = 0.0;
  for (std::size_t lane = 0; lane < states.size(); ++lane) {
    for (int a = 0; a < Dim; ++a) {
      particles.velocity[a][lane] = states[lane].velocity[a];
    }
    for (int a = 0; a < 3; ++a) {
      for (int b = a; b < 3; ++b) {
        const int column = kernels::kStressColumn[a][b];
        if (column < Particles<Dim>::kStress) {
          particles.stress[column][lane] = states[lane].stress(a, b);
        }
      }
    }
    fastest = std::max(fastest, states[lane].velocity.norm());
  }
  return fastest;
}

template double set_initial_state<2>(const InitialField&, std::int64_t, Particles<2>&);
template double set_initial_state<3>(const InitialField&, std::int64_t, Particles<3>&);

}  // namespace rgimp
