#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "bands.hpp"
#include "energy.hpp"
#include "grid.hpp"
#include "particles.hpp"
#include "platens.hpp"
#include "rgimp/kernels/table.hpp"
#include "rgimp/simulation.hpp"
#include "workers.hpp"

namespace rgimp {

/// Parts of a step whose time is kept apart.
enum class Stage { scatter, nodes, second_scatter, second_nodes, particles, count };

/// The state of a simulation and its step.
template <int Dim>
class Solver {
 public:
  Solver(const Case& settings, kernels::Isa isa, Workers& workers);

  /// One step; the integrators differ in where strains come from (Case::time).
  void step();
  /// Sorts the particles into bins anew; done by step() whenever the drift bound asks for it.
  void rebin();

  std::int64_t steps_done() const { return steps_done_; }
  double time() const { return dt_ * static_cast<double>(steps_done_); }
  double dt() const { return dt_; }
  double critical_step_ratio() const;
  std::int64_t rebins() const { return rebins_; }
  double peak_axial_stress() const { return peak_axial_stress_; }
  const std::optional<FirstFailure>& first_failure() const { return first_failure_; }
  const std::array<double, static_cast<std::size_t>(Stage::count)>& stage_seconds() const {
    return stage_seconds_;
  }

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
  void divide(const double* const* momentum);
  template <typename Work>
  void on_particles(Work work);

  // Parts of a phase, on one band's bins.
  void accelerate(Range bins);
  void strain(Range bins, const double* const* velocity);
  void move(Range bins);

  template <typename Work>
  void over_bands(Stage stage, Work work);
  template <typename Work>
  void over_colours(Stage stage, Work work);

  void finish_step();
  void add_row_sums();
  void note_first_failure();
  void stop_if_unphysical() const;
  double closure() const;
  double reaction() const;
  double axial_stress() const;

  Workers& workers_;
  const kernels::KernelTable<Dim>& kernels_;
  Integrator integrator_;
  std::vector<kernels::MaterialConstants> materials_;
  std::vector<std::uint8_t> material_of_id_;
  Particles<Dim> particles_;
  Grid<Dim> grid_;
  Bands bands_;
  Platens<Dim> platens_;
  std::vector<Platen> platen_settings_;
  int load_axis_;
  double width_;  ///< m, bounding width across the load
  double sound_speed_;
  double dt_;
  kernels::NodeUpdate<Dim> node_update_{};
  kernels::ParticleView<Dim> p_{};
  kernels::GridView<Dim> g_{};

  std::vector<kernels::NodeSums> node_sums_;          // by row
  std::vector<kernels::ParticleSums> particle_sums_;  // by row
  std::vector<PlatenSums> platen_sums_;               // by row

  std::int64_t steps_done_ = 0;
  std::int64_t rebins_ = 0;
  double margin_ = 0.0;     ///< cells a particle may drift from where it was binned
  double drift_ = 0.0;      ///< cells, bound of what any has drifted
  double max_speed_ = 0.0;  ///< m/s, fastest node component of the last step
  EnergyBudget budget_;
  std::vector<double> reaction_of_platen_;  ///< N, of the last step
  double peak_axial_stress_ = 0.0;
  std::int64_t failed_tension_ = 0;
  std::int64_t failed_shear_ = 0;
  std::optional<FirstFailure> first_failure_;
  std::array<double, static_cast<std::size_t>(Stage::count)> stage_seconds_{};
};

}  // namespace rgimp
