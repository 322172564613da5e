#pragma once

#include <cstdint>
#include <vector>

#include "energy.hpp"
#include "own_failure.hpp"
#include "platens.hpp"
#include "rgimp/case.hpp"
#include "rgimp/kernels/views.hpp"
#include "rgimp/simulation.hpp"

namespace rgimp {

/// What the rows of grid and bins report of each step, summed over steps: energies, reactions,
/// failures. Rows are added in rising order, so that nothing depends on threads.
class Ledger {
 public:
  Ledger(const Case& settings, std::size_t rows);

  // Written by the phases of a step, an entry a row.
  kernels::NodeSums* nodes() { return nodes_.data(); }
  kernels::ParticleSums* particles() { return particles_.data(); }
  kernels::Reach* reach() { return reach_.data(); }
  std::vector<PlatenSums>& platens() { return platen_sums_; }

  /// The fastest particle before the first step, m/s.
  void set_initial_speed(double speed) { max_speed_ = speed; }
  /// Adds what the rows of nodes report of a step: works and reactions.
  void add_nodes();
  /// Adds what the rows of bins report of a step of `dt` seconds: works, failures, reach.
  void add_particles(double dt);
  /// Adds what an own criterion did in a step.
  void add_failures(const OwnFailures& failures);

  const EnergyBudget& budget() const { return budget_; }
  std::int64_t failed_tension() const { return failed_tension_; }
  std::int64_t failed_shear() const { return failed_shear_; }
  /// Mean over the platens on the axis of the load, N (2D: per metre), compression > 0.
  double reaction() const;
  double axial_stress() const { return reaction() / area_; }       ///< Pa, compression > 0
  double peak_axial_stress() const { return peak_axial_stress_; }  ///< Pa, of all steps, at least 0
  /// Sum of the displacements towards the specimen of the platens on the axis of the load, m.
  double closure(double time) const;
  double farthest() const { return farthest_; }    ///< cells, of a particle from its bin's node
  double max_speed() const { return max_speed_; }  ///< m/s, of a particle in the last step
  const RemovedParticles& removed() const { return removed_; }
  /// Books a particle that is taken out: its mass, kg, and the energy it holds, J.
  void remove(double mass, double energy);
  /// Whether all sums are numbers. A node's velocity that is none reaches the damping work.
  bool is_finite() const;

  /// Calls visit(name, number) for all that is summed over steps, and of the last step.
  template <typename Visit>
  void for_each_total(Visit visit) {
    visit("external work", budget_.external_work);
    visit("damping work", budget_.damping_work);
    visit("viscous work", budget_.viscous_work);
    visit("released energy", budget_.released_energy);
    visit("reactions", reaction_of_platen_);
    visit("peak axial stress", peak_axial_stress_);
    visit("failed in tension", failed_tension_);
    visit("failed in shear", failed_shear_);
    visit("farthest", farthest_);
    visit("largest speed", max_speed_);
    visit("particles removed", removed_.particles);
    visit("mass removed", removed_.mass);
    visit("energy removed", removed_.energy);
  }
  /// What the rows of nodes have reported and add_nodes() has not added yet, for a checkpoint; a
  /// row after the other: the works, then the reactions.
  std::vector<double> pending() const;
  /// Takes what pending() gave; false where that, or a total taken before, is of another case.
  bool set_pending(const std::vector<double>& values);

 private:
  bool is_on_load_axis(const Platen& platen) const;

  std::vector<Platen> platens_;
  int load_axis_;
  double area_;  // m2 (2D: m, unit thickness), of the specimen across the load

  std::vector<kernels::NodeSums> nodes_;
  std::vector<kernels::ParticleSums> particles_;
  std::vector<kernels::Reach> reach_;
  std::vector<PlatenSums> platen_sums_;

  EnergyBudget budget_;
  std::vector<double> reaction_of_platen_;  // N, of the last step
  double peak_axial_stress_ = 0.0;
  std::int64_t failed_tension_ = 0;
  std::int64_t failed_shear_ = 0;
  double farthest_ = 0.0;
  double max_speed_ = 0.0;
  RemovedParticles removed_;
};

}  // namespace rgimp
