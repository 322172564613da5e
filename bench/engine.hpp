#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "setting.hpp"
#include "solver.hpp"
#include "workers.hpp"

namespace rgimp::bench {

/// A solver in the state that timing and comparison start from: in motion, so that the stresses of
/// all particles change from the first step on.
template <int Dim>
class Engine {
 public:
  Engine(const Setting& setting, const Case& settings);

  /// In one region of Workers, as the steps of a run between two outputs are.
  void steps(std::int64_t count);

  Solver<Dim>& solver() { return *solver_; }
  HistoryRow history() { return solver_->history(); }
  std::size_t particles() { return solver_->particles().count; }
  /// Particles and the padding among them.
  std::size_t lanes() { return solver_->particles().lanes(); }
  std::size_t memory_bytes() const { return solver_->memory_bytes(); }
  /// From the case to a solver ready for its first step.
  double startup_seconds() const { return startup_seconds_; }

 private:
  void place_at_random(double pitch);
  void squeeze_and_shear(double speed, double half_height);

  Workers workers_;
  std::optional<Solver<Dim>> solver_;
  double startup_seconds_ = 0.0;
};

/// visit(an engine of the setting's dimension).
template <typename Visit>
auto with_engine(const Setting& setting, const Case& settings, Visit visit) {
  if (setting.dimension == 3) {
    Engine<3> engine(setting, settings);
    return visit(engine);
  }
  Engine<2> engine(setting, settings);
  return visit(engine);
}

}  // namespace rgimp::bench
