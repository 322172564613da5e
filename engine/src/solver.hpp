#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "bands.hpp"
#include "checkpoint_file.hpp"
#include "grid.hpp"
#include "grid_motion.hpp"
#include "guards.hpp"
#include "ledger.hpp"
#include "loading.hpp"
#include "particles.hpp"
#include "platens.hpp"
#include "rgimp/kernels/table.hpp"
#include "rgimp/simulation.hpp"
#include "workers.hpp"

namespace rgimp {

/// Parts of a step whose time is kept apart.
enum class Stage { prepare, first_pass, second_pass };
inline constexpr std::array kStageNames = {"P2G after binning", "first pass", "second pass"};

/// The state of a simulation and its step.
template <int Dim>
class Solver {
 public:
  Solver(const Case& settings, kernels::Isa isa, Workers& workers);

  /// One step; the integrators differ in where strains come from (Case::time).
  void step();
  /// What step() starts with where the step before could not do it: mass, acceleration and velocity
  /// of the nodes in now() (USF: mass and momentum). A caller who calls it may add to these what
  /// a case cannot express, such as a body force that varies in space; step() takes them as they
  /// are.
  void prepare();
  /// Sorts the particles into bins anew; step() does it when one has drifted too far from its bin.
  /// Particles out of the grid are taken out, or stop the run as broken ones do: PhysicsError.
  void rebin();
  /// All guards at once; step() calls it every kFullCheckEvery steps. Throws PhysicsError, else
  /// changes nothing.
  void verify();

  // See Simulation for these.
  void set_initial_state(const InitialField& field);
  void set_acceleration(AccelerationField field);
  void set_criterion(FailureCriterion criterion);
  /// Names of those of the two functions above that have set one.
  std::vector<std::string> own_functions() const;

  std::int64_t steps_done() const { return steps_done_; }
  double time() const { return dt_ * static_cast<double>(steps_done_); }
  double dt() const { return dt_; }
  double critical_step_ratio() const;
  std::int64_t rebins() const { return rebins_; }
  double peak_axial_stress() const { return ledger_.peak_axial_stress(); }
  const RemovedParticles& removed() const { return ledger_.removed(); }
  const std::optional<FirstFailure>& first_failure() const { return first_failure_; }
  /// In the order of kStageNames.
  const std::array<double, kStageNames.size()>& stage_seconds() const { return stage_seconds_; }

  HistoryRow history();
  /// To read, and to change before rebin().
  Particles<Dim>& particles() { return particles_; }
  Grid<Dim>& grid() { return grid_; }
  /// The layer of the grid that the next step starts from.
  const kernels::GridView<Dim>& now() const { return layers_[layer_]; }
  std::size_t memory_bytes() const;

  /// Writes all that the steps after this one depend on.
  void save(CheckpointWriter& checkpoint);
  /// Takes what save() wrote, of a solver of the same case. Throws FileError where it cannot be
  /// such a state; then this one is as it was.
  void restore(const CheckpointReader& checkpoint);

 private:
  using Range = kernels::RowRange;
  using View = kernels::GridView<Dim>;

  void take_seeds(const SeedParts& seeds);

  // Phases of a step; each returns when all bands are done.
  void accelerate();
  void strain_and_move();
  void accelerate_strain_and_move();
  void strain();
  void accelerate_and_move();

  // Parts of a phase, on rows of nodes.
  /// From `time` on, for one step.
  void advance_nodes(const View& grid, double time, Range rows);
  void find_strain_velocity(const double* const* momentum, Range rows);

  template <typename Work>
  void over_bands(Stage stage, Work work);

  const View& next() const { return layers_[1 - layer_]; }
  double end_of_step(std::int64_t step) const { return dt_ * static_cast<double>(step) + dt_; }

  /// Puts a layer where the grid is after `step` steps.
  void place_layer(int layer, std::int64_t step);
  // Parts of restore().
  Particles<Dim> read_particles(const CheckpointReader& checkpoint) const;
  Ledger read_ledger(const CheckpointReader& checkpoint) const;
  Grid<Dim> read_grid(const CheckpointReader& checkpoint) const;

  /// Points the views at the columns that there are now.
  void attach_particles();
  void finish_step();
  void fail_by_own_criterion();
  void note_first_failure();
  /// Takes out the particles in these lanes, or stops; see OnExit.
  void take_out(const std::vector<std::size_t>& lanes);
  GuardedStep guarded_step() const;
  /// After every step.
  void guard();

  Workers& workers_;
  const kernels::KernelTable<Dim>& kernels_;
  Integrator integrator_;
  OnExit on_exit_;
  std::vector<kernels::MaterialConstants> materials_;
  std::vector<std::uint8_t> material_of_id_;
  Particles<Dim> particles_;
  Grid<Dim> grid_;
  GridMotion grid_motion_;
  Bands bands_;
  std::ptrdiff_t bands_per_task_;
  Platens<Dim> platens_;
  Loading<Dim> loading_;
  FailureCriterion criterion_;  // empty: the materials' alone
  Ledger ledger_;
  double sound_speed_;
  double dt_;
  kernels::NodeUpdate<Dim> node_update_{};
  kernels::ParticleView<Dim> p_{};
  std::array<View, 2> layers_{};
  int layer_ = 0;
  kernels::ParticleUpdate update_{};
  bool is_prepared_ = false;  // the grid holds what the next step starts from

  std::int64_t steps_done_ = 0;
  std::int64_t rebins_ = 0;
  std::optional<FirstFailure> first_failure_;
  std::array<double, kStageNames.size()> stage_seconds_{};
};

}  // namespace rgimp
