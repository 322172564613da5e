#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "rgimp/case.hpp"
#include "rgimp/columns.hpp"
#include "rgimp/extension.hpp"

namespace rgimp {

/// One row of history.csv, at the end of a step.
struct HistoryRow {
  /// Steps done.
  std::int64_t step = 0;
  double time = 0.0;     ///< s
  double closure = 0.0;  ///< m, sum of the platens' displacements towards the specimen
  /// Pa, compression > 0; reaction / bounding width (in 3D the bounding rectangle across the load,
  /// or the circle of one cylinder loaded along its axis)
  double axial_stress = 0.0;
  double reaction = 0.0;        ///< N (2D: per metre), mean of the opposed platens, compr. > 0
  double kinetic_energy = 0.0;  ///< J, here and below in 2D per metre of thickness
  /// J, sum of V sigma : C^-1 : s / 2; s is sigma, or the effective stress where points soften
  double strain_energy = 0.0;
  double external_work = 0.0;       ///< J, of platens and body force
  double damping_work = 0.0;        ///< J, taken by local damping, never falls
  double viscous_work = 0.0;        ///< J, taken by bulk viscosity
  double released_energy = 0.0;     ///< J, strain energy dropped by failure and damage
  std::int64_t failed_tension = 0;  ///< of all particles, those that were taken out too
  std::int64_t failed_shear = 0;    ///< likewise
  double removed_energy = 0.0;      ///< J, see RemovedParticles; no column of history.csv
};

/// What left the grid and was taken out, see OnExit.
struct RemovedParticles {
  /// How many.
  std::int64_t particles = 0;
  double mass = 0.0;    ///< kg (2D: kg per metre of thickness)
  double energy = 0.0;  ///< J, kinetic and strain, that they held when they were taken out
};

/// The first particle to fail, damage 1; ties go to the lowest id.
struct FirstFailure {
  /// At whose end it had failed.
  std::int64_t step = 0;
  double closure = 0.0;       ///< m
  double axial_stress = 0.0;  ///< Pa
  /// m, at that time.
  Vector position = Vector::Zero();
  /// Tension or shear.
  FailureMode mode = FailureMode::tension;
};

/// A copy of the particles, in order of id; columns of equal length. Ids are those of step 0: one
/// that was taken out is missing.
struct ParticleTable {
  /// Of step 0, rising.
  std::vector<std::uint32_t> id;
  std::vector<std::array<double, 3>> position;  ///< m
  std::vector<std::array<double, 3>> velocity;  ///< m/s
  std::vector<std::array<double, 6>> stress;    ///< Pa; xx, yy, zz, xy, yz, xz; tension > 0
  std::vector<double> max_principal_stress;     ///< Pa, of the three-dimensional tensor
  /// How, if it did.
  std::vector<FailureMode> failed;
  std::vector<double> damage;              ///< 1, share of the strength lost; 1 where failed
  std::vector<std::int32_t> failure_step;  ///< -1 while intact

  /// Particles.
  std::size_t size() const { return id.size(); }
};

/// Time spent so far in one part of the steps.
struct StageTime {
  /// "first pass" and so on, see theory.md.
  std::string_view name;
  /// s, on the clock, of all steps so far.
  double seconds = 0.0;
};

/// Figures of the prepared simulation, for people and for `rgimp check`.
struct Facts {
  std::size_t particles = 0;            ///< now, without those that were taken out
  std::array<std::int64_t, 3> nodes{};  ///< per axis; 1 along z in 2D
  double dt = 0.0;                      ///< s, Eq. 24
  /// Of the case.
  std::int64_t total_steps = 0;
  std::size_t memory_bytes = 0;       ///< particles and grid
  std::size_t peak_memory_bytes = 0;  ///< of a run's process: it writes a snapshot, or resumes
  std::string isa;                    ///< reference, baseline, avx2 or avx512
  /// That steps use.
  int threads = 0;
};

/// A running simulation. Errors are exceptions (see error.hpp); after a PhysicsError the state is
/// that of the step that the error names and can still be read. Simulations share nothing: each may
/// be used by one thread at a time, any, while others use theirs. One that was moved from may only
/// be assigned to or destroyed. Nothing is read from the environment but RGIMP_ISA, and that once,
/// when a simulation is built.
class Simulation {
 public:
  /// Throws CaseError for what check_case refuses, and for an RGIMP_ISA the machine lacks.
  explicit Simulation(Case settings);
  ~Simulation();
  /// Takes over all of the other.
  Simulation(Simulation&&) noexcept;
  /// Likewise; what this one was is gone.
  Simulation& operator=(Simulation&&) noexcept;

  /// What is called while a simulation runs; it reads, and cannot change a result.
  using Observer = std::function<void(const Simulation&)>;

  /// One step. Throws PhysicsError, and what own functions throw (set_acceleration, set_criterion):
  /// then the step is half done, and every further one an Error, until restore().
  void step();
  /// Steps until `step` steps are done; nothing happens when they are. Throws PhysicsError.
  void run_until(std::int64_t step);
  /// From now on calls `observer` after every step whose number is a multiple of `steps`, in the
  /// order in which observers were added, on the thread that steps. What it throws ends the
  /// stepping between two steps and comes out of step() or run_until(), which may be called again.
  /// It must add no observer. Throws CaseError for `steps` below 1 and for an empty function.
  void every(std::int64_t steps, Observer observer);
  /// Sets velocity and stress of every particle, in place of the bodies' velocities and no stress.
  /// Before the first step only: CaseError after it, for values that are not finite, a stress that
  /// is not symmetric, and components out of the plane in 2D. Stresses need not be in equilibrium.
  void set_initial_state(const InitialField& field);
  /// From now on accelerates the nodes by `field` beside Case::body_acceleration, which it is like
  /// in all else: local damping sees it, and its work is part of HistoryRow::external_work. An
  /// empty function ends it. No checkpoint holds it, only that there was one: set it again before
  /// restore(). What it throws comes out of step(), which is then half done: see step().
  void set_acceleration(AccelerationField field);
  /// From now on particles fail by `criterion` too, at the end of the step, beside the criterion of
  /// their material where that has one, and are treated as their material says, by default as those
  /// of the paper: no deviator, no tension. Points with a fracture energy fail at once where it
  /// says so. Forces follow from the next step on, with USF a step later than with the material's
  /// own; the released energy of such failures counts some 3 % too high. An empty function ends it.
  /// Checkpoints and exceptions: as with set_acceleration.
  void set_criterion(FailureCriterion criterion);
  /// Throws the PhysicsError of a state that must not be gone on from: a value that is not finite,
  /// a volume that is not positive, a time step beyond the critical one. Steps look at most of this
  /// every step, and at all of it every 500 steps and whenever particles change bins.
  void verify() const;

  /// Writes a checkpoint: the whole state, from which a simulation of the same case goes on to the
  /// same bits. The file is there whole, and on disk, or not at all. `note` comes back with it.
  /// Throws FileError, and PhysicsError for a state that verify() refuses.
  void save(const std::filesystem::path& path, std::string_view note = {}) const;
  /// Takes the state of a checkpoint and returns its note. Throws FileError for a file that cannot
  /// be read, is damaged or of another format, CaseError for one of another case (its output,
  /// tuning, grid.on_exit and number of steps may differ) and for one of a simulation with an own
  /// acceleration or criterion where this one has none; then this simulation is as it was.
  std::string restore(const std::filesystem::path& path);

  /// Steps since the start of the case, those before a restored checkpoint too.
  std::int64_t steps_done() const;
  double time() const;  ///< s
  /// dt over the critical step of Eq. 22 with the fastest particle of the last step, or
  /// of the start.
  double critical_step_ratio() const;
  /// The row of history.csv that belongs here.
  HistoryRow history() const;
  /// A copy in order of id; columns() copies nothing.
  ParticleTable particles() const;
  /// Nothing is copied; see there for their order and how long they are valid.
  ParticleColumns columns() const;
  /// Writes the particles as `rgimp run` does, for ParaView and HDF5 readers. The file is there
  /// whole or not at all. Throws FileError.
  void write_snapshot(const std::filesystem::path& path) const;
  /// None while nothing has failed.
  std::optional<FirstFailure> first_failure() const;
  /// What has left the grid so far.
  RemovedParticles removed() const;
  double peak_axial_stress() const;  ///< Pa, largest over all steps, at least 0
  /// A hash of every particle's id and state in order of id: equal for equal bits.
  std::uint64_t state_hash() const;
  /// Figures that do not change from step to step, but for `particles`.
  Facts facts() const;
  /// Where the time of the steps went, in the order of a step.
  std::vector<StageTime> stage_times() const;
  /// The case it was built from.
  const Case& settings() const;

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace rgimp
