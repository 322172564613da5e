#include "solver.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "binning.hpp"
#include "failure_limits.hpp"
#include "rgimp/error.hpp"
#include "time_step.hpp"

namespace rgimp {
namespace {

/// Layers of a band: 8 node rows in the plane, 4 planes in space.
template <int Dim>
constexpr std::ptrdiff_t kBandHeight = Dim == 2 ? 8 : 4;

/// Nodes lighter than this share of a quarter (2D) of a full cell are skipped. Momentum over mass
/// is exact however light a node is; at 1e-12 its gradient, which falls with the root of the mass,
/// was still 1e-6 of a full node's and free fall was off by 5e-6, at 1e-24 by 1e-14.
constexpr double kLeastMassShare = 1e-24;

template <int Dim>
double least_node_mass(const Case& settings) {
  double density = settings.materials.at(settings.bodies.front().material).density;
  for (const Body& body : settings.bodies) {
    density = std::min(density, settings.materials.at(body.material).density);
  }
  return kLeastMassShare * density * std::pow(0.5 * settings.grid.cell_size, Dim);
}

/// m/s.
double fastest(const std::vector<ParticleSeed>& seeds) {
  double most = 0.0;
  for (const ParticleSeed& seed : seeds) {
    most = std::max(most, seed.velocity.norm());
  }
  return most;
}

/// Row by row, so that what follows each other on a row's particles finds them in cache.
template <typename Work>
void for_each_row(kernels::RowRange rows, Work work) {
  for (std::ptrdiff_t row = rows.first; row < rows.last; ++row) {
    work(kernels::RowRange{row, row + 1});
  }
}

}  // namespace

template <int Dim>
Solver<Dim>::Solver(const Case& settings, kernels::Isa isa, Workers& workers)
    : workers_(workers),
      kernels_(kernels::kernels_for<Dim>(isa)),
      integrator_(settings.time.integrator),
      grid_(grid_extent(settings), settings.bodies.front().particles_per_cell,
            settings.local_damping),
      bands_(grid_.extent().nodes[Dim - 1], grid_.rows() / grid_.extent().nodes[Dim - 1],
             kBandHeight<Dim>),
      platens_(settings, grid_),
      ledger_(settings, static_cast<std::size_t>(grid_.rows())),
      sound_speed_(fastest_sound(settings)),
      dt_(time_step(settings)) {
  for (const auto& [name, material] : settings.materials) {
    materials_.push_back(material_constants(material, settings));
  }
  const std::vector<ParticleSeed> seeds = seed_particles(settings);
  for (const ParticleSeed& seed : seeds) {
    material_of_id_.push_back(seed.material);
  }
  particles_ = particles_from<Dim>(seeds);
  ledger_.set_initial_speed(fastest(seeds));
  node_update_.dt = dt_;
  node_update_.least_mass = least_node_mass<Dim>(settings);
  for (int a = 0; a < Dim; ++a) {
    node_update_.body_acceleration[a] = settings.body_acceleration[a];
  }
  g_ = grid_.view();
  rebin();
  rebins_ = 0;
}

// ---- the step -------------------------------------------------------------------------------
// m mass, p momentum, f force, v velocity, a acceleration, s stress, x position, V volume; S the
// GIMP weights [Eq. 18, 19] of the positions that the step starts from. The v_i of `new_velocity`
// is that at the end of the step; `strain_velocity` is the field that strains come from.

template <int Dim>
void Solver<Dim>::step() {
  double* const* const new_velocity = g_.momentum;
  double* const* const strain_velocity = g_.second_field;
  switch (integrator_) {
    case Integrator::musl:
      scatter_all();           // m_p v_p s_p V_p -> m_i p_i f_i = -sum V s grad S       [8-10]
      advance_nodes();         // m_i p_i f_i -> a_i v_i; body force, damping, platens [7, 11, 4]
      scatter_new_momentum();  // a_i -> v_p += dt sum S a_i -> p_i = sum S m_p v_p      [6, 8]
      find_strain_velocity(g_.second_field);  // p_i m_i -> v_i; platens                   [8, 4]
      on_particles([&](Range bins) {
        strain(bins, strain_velocity);  // v_i -> s_p V_p, failure                        [20, 21]
        move(bins);                     // new v_i -> x_p += dt sum S v_i                      [6]
      });
      break;
    case Integrator::usl:
      scatter_all();    // as above                                                         [8-10]
      advance_nodes();  // as above                                                   [7, 11, 4]
      on_particles([&](Range bins) {
        accelerate(bins);            // a_i -> v_p += dt sum S a_i                             [6]
        strain(bins, new_velocity);  // v_i -> s_p V_p, failure                           [20, 21]
        move(bins);                  // v_i -> x_p += dt sum S v_i                             [6]
      });
      break;
    case Integrator::usf:
      scatter_mass_momentum();  // m_p v_p -> m_i p_i                                       [8, 9]
      find_strain_velocity(g_.momentum);  // p_i m_i -> v_i of the start; platens           [8, 4]
      on_particles([&](Range bins) { strain(bins, strain_velocity); });  // as above      [20, 21]
      scatter_force();  // s_p V_p -> f_i                                                   [10]
      advance_nodes();  // as above                                                   [7, 11, 4]
      on_particles([&](Range bins) {
        accelerate(bins);  // as above                                                         [6]
        move(bins);        // as above                                                         [6]
      });
      break;
  }
  finish_step();  // row sums -> energy budget, reaction, failures; guards; bins
}

template <int Dim>
template <typename Work>
void Solver<Dim>::timed(Stage stage, Work work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
  stage_seconds_[static_cast<std::size_t>(stage)] += spent.count();
}

template <int Dim>
template <typename Work>
void Solver<Dim>::over_bands(Stage stage, Work work) {
  timed(stage, [&] { workers_.for_each(bands_.count(), work); });
}

template <int Dim>
template <typename Work>
void Solver<Dim>::over_colours(Stage stage, Work work) {
  timed(stage, [&] {
    for (int colour = 0; colour < 2; ++colour) {
      workers_.for_each(bands_.count_of(colour),
                        [&](std::ptrdiff_t index) { work(Bands::band_of(colour, index)); });
    }
  });
}

template <int Dim>
void Solver<Dim>::scatter_all() {
  over_colours(Stage::scatter, [&](std::ptrdiff_t band) {
    grid_.clear(bands_.cleared_rows(band));
    kernels_.scatter_all(p_, g_, bands_.rows(band));
  });
}

template <int Dim>
void Solver<Dim>::scatter_mass_momentum() {
  over_colours(Stage::scatter, [&](std::ptrdiff_t band) {
    grid_.clear(bands_.cleared_rows(band));
    kernels_.scatter_mass_momentum(p_, g_, bands_.rows(band));
  });
}

template <int Dim>
void Solver<Dim>::scatter_force() {
  over_colours(Stage::scatter,
               [&](std::ptrdiff_t band) { kernels_.scatter_force(p_, g_, bands_.rows(band)); });
}

template <int Dim>
void Solver<Dim>::advance_nodes() {
  platens_.set_time(time() + dt_);
  over_bands(Stage::nodes, [&](std::ptrdiff_t band) {
    const Range rows = bands_.rows(band);
    kernels_.update_nodes(g_, node_update_, rows, ledger_.nodes());
    platens_.impose(g_, dt_, node_update_.least_mass, rows, ledger_.platens());
  });
}

template <int Dim>
void Solver<Dim>::scatter_new_momentum() {
  over_colours(Stage::second_scatter, [&](std::ptrdiff_t band) {
    grid_.clear_second_field(bands_.cleared_rows(band));
    for_each_row(bands_.rows(band), [&](Range row) {
      accelerate(row);
      kernels_.scatter_second_momentum(p_, g_, row);
    });
  });
}

template <int Dim>
void Solver<Dim>::find_strain_velocity(const double* const* momentum) {
  over_bands(Stage::second_nodes, [&](std::ptrdiff_t band) {
    const Range rows = bands_.rows(band);
    kernels_.divide_by_mass(g_, momentum, node_update_.least_mass, rows);
    platens_.impose_on_second_field(g_, rows);
  });
}

template <int Dim>
template <typename Work>
void Solver<Dim>::on_particles(Work work) {
  over_bands(Stage::particles, [&](std::ptrdiff_t band) { for_each_row(bands_.rows(band), work); });
}

template <int Dim>
void Solver<Dim>::accelerate(Range bins) {
  kernels_.gather_velocity(p_, g_, dt_, bins);
}

template <int Dim>
void Solver<Dim>::strain(Range bins, const double* const* velocity) {
  kernels_.update_stress(p_, g_, velocity, materials_.data(), dt_,
                         static_cast<std::int32_t>(steps_done_ + 1), bins, ledger_.particles());
}

template <int Dim>
void Solver<Dim>::move(Range bins) {
  kernels_.gather_position(p_, g_, dt_, bins, ledger_.reach());
}

// ---- after the step -------------------------------------------------------------------------

template <int Dim>
void Solver<Dim>::finish_step() {
  ++steps_done_;
  ledger_.add_step(dt_);
  if (!first_failure_ && ledger_.failed_tension() + ledger_.failed_shear() > 0) {
    note_first_failure();
  }
  stop_if_unphysical();
  // Three nodes per axis carry all weights up to here, from the node a particle was binned to.
  if (ledger_.farthest() > 1.0 - grid_.particle_half_size()) {
    rebin();
  }
}

template <int Dim>
void Solver<Dim>::note_first_failure() {
  std::optional<std::size_t> first;
  for (std::size_t i = 0; i < particles_.lanes(); ++i) {
    const bool failed = !particles_.is_padding(i) && particles_.failure_mode[i] > kernels::kIntact;
    if (failed && (!first || particles_.id[i] < particles_.id[*first])) {
      first = i;
    }
  }
  FirstFailure failure;
  failure.step = steps_done_;
  failure.closure = ledger_.closure(time());
  failure.axial_stress = ledger_.axial_stress();
  for (int a = 0; a < Dim; ++a) {
    failure.position[a] = particles_.position[a][*first];
  }
  failure.mode = particles_.failure_mode[*first] == kernels::kFailedInTension ? FailureMode::tension
                                                                              : FailureMode::shear;
  first_failure_ = failure;
}

template <int Dim>
void Solver<Dim>::stop_if_unphysical() const {
  if (!ledger_.is_finite()) {
    throw PhysicsError(
        fmt::format("step {}: velocities are no longer numbers; lower time.step_factor, or raise "
                    "damping.local or viscosity if the specimen bursts",
                    steps_done_));
  }
  const double ratio = critical_step_ratio();
  if (ratio > 1.0) {
    throw PhysicsError(fmt::format(
        "step {}: the time step {:.6g} s is {:.4g} times the critical one (Eq. 22) at a speed of "
        "{:.4g} m/s; lower time.step_factor, or raise damping.local if the specimen bursts",
        steps_done_, dt_, ratio, ledger_.max_speed()));
  }
}

template <int Dim>
double Solver<Dim>::critical_step_ratio() const {
  return dt_ * (sound_speed_ + ledger_.max_speed()) / grid_.extent().cell_size;
}

template <int Dim>
void Solver<Dim>::rebin() {
  try {
    bin_particles(particles_, material_of_id_, grid_, workers_);
  } catch (const PhysicsError& error) {
    throw PhysicsError(fmt::format("step {}: {}", steps_done_, error.what()));
  }
  p_ = particles_.view();
  ++rebins_;
}

template <int Dim>
HistoryRow Solver<Dim>::history() {
  const StoredEnergy stored =
      stored_energy(particles_, grid_.groups_in_row(), grid_.rows(), materials_, workers_);
  const EnergyBudget& budget = ledger_.budget();
  HistoryRow row;
  row.step = steps_done_;
  row.time = time();
  row.closure = ledger_.closure(time());
  row.axial_stress = ledger_.axial_stress();
  row.reaction = ledger_.reaction();
  row.kinetic_energy = stored.kinetic;
  row.strain_energy = stored.strain;
  row.external_work = budget.external_work;
  row.damping_work = budget.damping_work;
  row.viscous_work = budget.viscous_work;
  row.released_energy = budget.released_energy;
  row.failed_tension = ledger_.failed_tension();
  row.failed_shear = ledger_.failed_shear();
  return row;
}

template <int Dim>
std::size_t Solver<Dim>::memory_bytes() const {
  constexpr std::size_t kDoubles = 2 * Dim + Particles<Dim>::kStress + 4;
  const std::size_t lane = kDoubles * sizeof(double) + sizeof(std::int32_t) + sizeof(std::uint32_t);
  return particles_.lanes() * lane + particles_.slot_material.size() +
         particles_.group_begin.size() * sizeof(std::uint32_t) + material_of_id_.size() +
         grid_.memory_bytes();
}

template class Solver<2>;

}  // namespace rgimp
