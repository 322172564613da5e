#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "bands.hpp"
#include "energy.hpp"
#include "grid.hpp"
#include "ledger.hpp"
#include "particles.hpp"
#include "platens.hpp"
#include "rgimp/kernels/table.hpp"
#include "rgimp/simulation.hpp"
#include "workers.hpp"

namespace rgimp {

/// Parts of a step whose time is kept apart.
enum class Stage { scatter, nodes, second_scatter, second_nodes, particles };
inline constexpr std::array kStageNames = {"P2G", "nodes", "second P2G", "second nodes",
                                           "G2P and stress"};

/// The state of a simulation and its step.
template <int Dim>
class Solver {
 public:
  Solver(const Case& settings, kernels::Isa isa, Workers& workers);

  /// One step; the integrators differ in where strains come from (Case::time).
  void step();
  /// Sorts the particles into bins anew; step() does it when one has drifted too far from its bin.
  void rebin();

  std::int64_t steps_done() const { return steps_done_; }
  double time() const { return dt_ * static_cast<double>(steps_done_); }
  double dt() const { return dt_; }
  double critical_step_ratio() const;
  std::int64_t rebins() const { return rebins_; }
  double peak_axial_stress() const { return ledger_.peak_axial_stress(); }
  const std::optional<FirstFailure>& first_failure() const { return first_failure_; }
  /// In the order of kStageNames.
  const std::array<double, kStageNames.size()>& stage_seconds() const { return stage_seconds_; }

  HistoryRow history();
  Particles<Dim>& particles() { return particles_; }
  Grid<Dim>& grid() { return grid_; }
  std::size_t memory_bytes() const;

 private:
  using Range = kernels::RowRange;

  // Phases of a step; each returns when all bands are done.
  void scatter_all();
  void scatter_mass_momentum();
  void scatter_force();
  void advance_nodes();
  void scatter_new_momentum();
  void find_strain_velocity(const double* const* momentum);
  template <typename Work>
  void on_particles(Work work);

  // Parts of a phase, on one band's bins.
  void accelerate(Range bins);
  void strain(Range bins, const double* const* velocity);
  void move(Range bins);

  template <typename Work>
  void timed(Stage stage, Work work);
  template <typename Work>
  void over_bands(Stage stage, Work work);
  template <typename Work>
  void over_colours(Stage stage, Work work);

  void finish_step();
  void note_first_failure();
  void stop_if_unphysical() const;

  Workers& workers_;
  const kernels::KernelTable<Dim>& kernels_;
  Integrator integrator_;
  std::vector<kernels::MaterialConstants> materials_;
  std::vector<std::uint8_t> material_of_id_;
  Particles<Dim> particles_;
  Grid<Dim> grid_;
  Bands bands_;
  Platens<Dim> platens_;
  Ledger ledger_;
  double sound_speed_;
  double dt_;
  kernels::NodeUpdate<Dim> node_update_{};
  kernels::ParticleView<Dim> p_{};
  kernels::GridView<Dim> g_{};

  std::int64_t steps_done_ = 0;
  std::int64_t rebins_ = 0;
  std::optional<FirstFailure> first_failure_;
  std::array<double, kStageNames.size()> stage_seconds_{};
};

}  // namespace rgimp
