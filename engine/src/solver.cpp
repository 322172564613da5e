#include "solver.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "binning.hpp"
#include "failure_limits.hpp"
#include "particles_of_seeds.hpp"
#include "time_step.hpp"

namespace rgimp {
namespace {

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
double fastest(const std::vector<Body>& bodies) {
  double most = 0.0;
  for (const Body& body : bodies) {
    most = std::max(most, body.velocity.norm());
  }
  return most;
}

}  // namespace

template <int Dim>
Solver<Dim>::Solver(const Case& settings, kernels::Isa isa, Workers& workers)
    : workers_(workers),
      kernels_(kernels::kernels_for<Dim>(isa)),
      integrator_(settings.time.integrator),
      on_exit_(settings.grid.on_exit),
      grid_(grid_extent(settings), settings.bodies.front().particles_per_cell,
            settings.local_damping),
      grid_motion_(settings, grid_.extent()),
      bands_(grid_.extent().nodes[Dim - 1], grid_.rows() / grid_.extent().nodes[Dim - 1],
             settings.numerics.band_height),
      bands_per_task_(settings.tuning.bands_per_task),
      platens_(settings, grid_),
      ledger_(settings, static_cast<std::size_t>(grid_.rows())),
      sound_speed_(fastest_sound(settings)),
      dt_(time_step(settings)) {
  for (const auto& [name, material] : settings.materials) {
    materials_.push_back(material_constants(material, settings));
  }
  node_update_.dt = dt_;
  node_update_.least_mass = least_node_mass<Dim>(settings);
  for (int a = 0; a < Dim; ++a) {
    node_update_.body_acceleration[a] = settings.body_acceleration[a];
  }
  for (int layer = 0; layer < 2; ++layer) {
    place_layer(layer, 0);
  }
  update_.dt = dt_;
  update_.materials = materials_.data();
  ledger_.set_initial_speed(fastest(settings.bodies));
  workers_.region([&] {
    take_seeds(seed_particles(settings, workers_));
    rebin();
  });
  rebins_ = 0;
}

template <int Dim>
void Solver<Dim>::take_seeds(const SeedParts& seeds) {
  material_of_id_ = materials_of(seeds, workers_);
  particles_ = particles_from<Dim>(seeds, workers_);
  if (std::any_of(materials_.begin(), materials_.end(),
                  [](const kernels::MaterialConstants& material) { return material.softens; })) {
    particles_.damage.assign(particles_.count, 0.0);
  }
}

// ---- the step -------------------------------------------------------------------------------
// m mass, p momentum, f force, v velocity, a acceleration, s stress, x position, V volume; S the
// GIMP weights [Eq. 18, 19] of the positions at the time. A pass reads the particles once: what it
// gathers lies on `now()`, what it scatters goes to `next()`, the grid of the step after.

template <int Dim>
void Solver<Dim>::step() {
  place_layer(1 - layer_, steps_done_ + 1);  // travel of the platens -> origin, spacing of next()
  prepare();  // where the step before could not: m_p v_p s_p V_p -> m_i p_i f_i -> a_i v_i
  update_.step = static_cast<std::int32_t>(steps_done_ + 1);
  switch (integrator_) {
    case Integrator::musl:
      accelerate();       // a_i -> v_p += dt sum S a_i; m_p v_p -> p_i -> strain v_i      [6, 8]
      strain_and_move();  // v_i -> s_p V_p, failure; new v_i -> x_p += dt sum S v_i  [20, 21, 6]
      break;              // next step: m_p v_p s_p -> m_i p_i f_i -> a_i v_i      [8-10, 7, 11, 4]
    case Integrator::usl:
      accelerate_strain_and_move();  // a_i v_i -> v_p s_p V_p x_p, failure            [6, 20, 21]
      break;                         // next step: as above                      [8-10, 7, 11, 4]
    case Integrator::usf:
      strain();               // strain v_i -> s_p V_p, failure -> f_i -> a_i v_i    [20, 21, 10, 7]
      accelerate_and_move();  // a_i v_i -> v_p x_p                                           [6]
      break;                  // next step: m_p v_p -> m_i p_i -> strain v_i               [8, 9]
  }
  finish_step();  // row sums -> energy budget, reaction, failures; guards; bins
}

template <int Dim>
template <typename Work>
void Solver<Dim>::over_bands(Stage stage, Work work) {
  const auto start = std::chrono::steady_clock::now();
  for (int colour = 0; colour < 2; ++colour) {
    const std::ptrdiff_t bands = bands_.count_of(colour);
    const std::ptrdiff_t tasks = (bands + bands_per_task_ - 1) / bands_per_task_;
    workers_.for_each(tasks, [&](std::ptrdiff_t task) {
      const std::ptrdiff_t last = std::min(bands, (task + 1) * bands_per_task_);
      for (std::ptrdiff_t index = task * bands_per_task_; index < last; ++index) {
        work(Bands::band_of(colour, index));
      }
    });
  }
  const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
  stage_seconds_[static_cast<std::size_t>(stage)] += spent.count();
}

template <int Dim>
void Solver<Dim>::prepare() {
  if (is_prepared_) {
    return;
  }
  const bool strains_first = integrator_ == Integrator::usf;
  platens_.set_time(strains_first ? time() : end_of_step(steps_done_));
  over_bands(Stage::prepare, [&](std::ptrdiff_t band) {
    grid_.clear(bands_.cleared_rows(band), layer_);
    if (strains_first) {
      kernels_.scatter_mass_momentum(p_, now(), bands_.rows(band));
      find_strain_velocity(now().momentum, bands_.completed_rows(band));
    } else {
      kernels_.scatter_all(p_, now(), bands_.rows(band));
      advance_nodes(now(), time(), bands_.completed_rows(band));
    }
  });
  is_prepared_ = true;
}

template <int Dim>
void Solver<Dim>::accelerate() {
  ledger_.add_nodes();
  platens_.set_time(end_of_step(steps_done_));
  over_bands(Stage::first_pass, [&](std::ptrdiff_t band) {
    grid_.clear_second_field(bands_.cleared_rows(band));
    kernels_.accelerate(p_, now(), now(), update_, bands_.rows(band));
    find_strain_velocity(now().second_field, bands_.completed_rows(band));
  });
}

template <int Dim>
void Solver<Dim>::strain_and_move() {
  platens_.set_time(end_of_step(steps_done_ + 1));
  over_bands(Stage::second_pass, [&](std::ptrdiff_t band) {
    grid_.clear(bands_.cleared_rows(band), 1 - layer_);
    kernels_.strain_and_move(p_, now(), next(), update_, bands_.rows(band));
    advance_nodes(next(), end_of_step(steps_done_), bands_.completed_rows(band));
  });
}

template <int Dim>
void Solver<Dim>::accelerate_strain_and_move() {
  ledger_.add_nodes();
  platens_.set_time(end_of_step(steps_done_ + 1));
  over_bands(Stage::first_pass, [&](std::ptrdiff_t band) {
    grid_.clear(bands_.cleared_rows(band), 1 - layer_);
    kernels_.accelerate_strain_and_move(p_, now(), next(), update_, bands_.rows(band));
    advance_nodes(next(), end_of_step(steps_done_), bands_.completed_rows(band));
  });
}

template <int Dim>
void Solver<Dim>::strain() {
  platens_.set_time(end_of_step(steps_done_));
  over_bands(Stage::first_pass, [&](std::ptrdiff_t band) {
    grid_.clear_force(bands_.cleared_rows(band), layer_);
    kernels_.strain(p_, now(), now(), update_, bands_.rows(band));
    advance_nodes(now(), time(), bands_.completed_rows(band));
  });
  ledger_.add_nodes();
}

template <int Dim>
void Solver<Dim>::accelerate_and_move() {
  over_bands(Stage::second_pass, [&](std::ptrdiff_t band) {
    grid_.clear_mass_momentum(bands_.cleared_rows(band), 1 - layer_);
    kernels_.accelerate_and_move(p_, now(), next(), update_, bands_.rows(band));
    find_strain_velocity(next().momentum, bands_.completed_rows(band));
  });
}

// On rows that no band adds to any more, while they are in cache.

template <int Dim>
void Solver<Dim>::advance_nodes(const View& grid, double time, Range rows) {
  loading_.add_forces(grid, time, node_update_.least_mass, rows);
  kernels_.update_nodes(grid, node_update_, rows, ledger_.nodes());
  platens_.impose(grid, node_update_, rows, ledger_.platens());
  loading_.add_works(grid, dt_, node_update_.least_mass, rows, ledger_.nodes());
}

template <int Dim>
void Solver<Dim>::find_strain_velocity(const double* const* momentum, Range rows) {
  kernels_.divide_by_mass(now(), momentum, node_update_.least_mass, rows);
  platens_.impose_on_second_field(now(), rows);
}

// ---- after the step -------------------------------------------------------------------------

template <int Dim>
void Solver<Dim>::place_layer(int layer, std::int64_t step) {
  grid_.move(layer, grid_motion_.at(dt_ * static_cast<double>(step)));
  layers_[layer] = grid_.view(layer);
}

template <int Dim>
void Solver<Dim>::finish_step() {
  ++steps_done_;
  layer_ = 1 - layer_;
  ledger_.add_particles(dt_);
  fail_by_own_criterion();
  if (!first_failure_ && ledger_.failed_tension() + ledger_.failed_shear() > 0) {
    note_first_failure();
  }
  guard();
  // Three nodes per axis carry all weights up to here, from the node a particle was binned to.
  // What was scattered beyond is not used: the next step prepares its grid from the new bins.
  if (ledger_.farthest() > 1.0 - grid_.particle_half_size()) {
    rebin();
  }
}

template <int Dim>
void Solver<Dim>::attach_particles() {
  p_ = particles_.view();
  update_.sums = ledger_.particles();
  update_.reach = ledger_.reach();
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
  row.removed_energy = ledger_.removed().energy;
  return row;
}

template <int Dim>
std::size_t Solver<Dim>::memory_bytes() const {
  return particles_.lanes() * Particles<Dim>::kLaneBytes +
         particles_.damage.size() * sizeof(double) + particles_.slot_material.size() +
         particles_.group_begin.size() * sizeof(std::uint32_t) + material_of_id_.size() +
         grid_.memory_bytes();
}

template class Solver<2>;
template class Solver<3>;

}  // namespace rgimp
