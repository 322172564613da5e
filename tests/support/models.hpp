#pragma once

#include <cmath>

#include "rgimp/case.hpp"
#include "solver.hpp"

namespace rgimp::tests {

/// A solver with what it needs around it.
template <int Dim>
struct ModelIn {
  explicit ModelIn(Case given, int threads = 1, kernels::Isa isa = kernels::best_isa())
      : settings(std::move(given)), workers(threads), solver(settings, isa, workers) {}

  void steps(std::int64_t count) {
    workers.region([&] {
      for (std::int64_t i = 0; i < count; ++i) {
        solver.step();
      }
    });
  }

  Case settings;
  Workers workers;
  Solver<Dim> solver;
};
using Model = ModelIn<2>;

/// What the books miss of the work put in, as a share of it.
inline double missing(const HistoryRow& row) {
  return (row.external_work - row.kinetic_energy - row.strain_energy - row.damping_work -
          row.viscous_work - row.released_energy) /
         row.external_work;
}

inline Material rock() {
  return {.density = 2600.0, .youngs_modulus = 17e9, .poisson_ratio = 0.14, .failure = {}};
}

inline Failure rock_failure() {
  Failure failure;
  failure.cohesion = 5.95e6;
  failure.friction_angle = 40.0;
  failure.tensile_strength = 2e6;
  return failure;
}

/// An elastic block of the given size in mm, cells of 0.5 mm, nothing holding it.
inline Case free_block(double width_mm, double height_mm) {
  Case settings;
  settings.grid.cell_size = 0.5e-3;
  Body body;
  body.size = Vector(width_mm * 1e-3, height_mm * 1e-3, 0.0);
  body.material = "rock";
  settings.bodies = {body};
  settings.materials["rock"] = rock();
  settings.time.steps = 1000;
  settings.time.step_factor = 0.4;
  return settings;
}

/// The same in three dimensions, bodies `depth_mm` deep about z = 0.
inline Case in_space(Case settings, double depth_mm) {
  settings.dimension = 3;
  for (Body& body : settings.bodies) {
    body.size.z() = depth_mm * 1e-3;
  }
  return settings;
}

/// A platen that stands still and lets slip.
inline Platen holding(Side side) {
  Platen platen;
  platen.side = side;
  return platen;
}

/// A block between two closing platens.
inline Case compressed_block(double width_mm, double height_mm, double closing_speed) {
  Case settings = free_block(width_mm, height_mm);
  for (const Side side : {Side::top, Side::bottom}) {
    Platen platen;
    platen.side = side;
    platen.speed = 0.5 * closing_speed;
    platen.ramp = 2e-5;
    settings.platens.push_back(platen);
  }
  return settings;
}

/// A block with an oblique slot that grows wing cracks within 2,000 steps.
inline Case cracking_block() {
  Case settings = compressed_block(12.0, 24.0, 0.2);
  settings.materials["rock"].failure = rock_failure();
  Flaw slot;
  slot.length = 5e-3;
  slot.width = 1.5e-3;
  slot.angle = 45.0;
  settings.flaws = {slot};
  settings.local_damping = 0.7;
  return settings;
}

/// The same with fracture energies.
inline Case softening_block() {
  Case settings = cracking_block();
  settings.materials["rock"].failure->fracture_energy = 0.5;
  settings.materials["rock"].failure->shear_fracture_energy = 20.0;
  settings.local_damping = 0.1;
  return settings;
}

/// An elastic block of the given size in mm, cells of 0.5 mm, nothing holding it.
inline Case free_block_in_space(const Vector& size_mm) {
  Case settings = free_block(1.0, 1.0);
  settings.dimension = 3;
  settings.bodies.front().size = size_mm * 1e-3;
  return settings;
}

/// A block of 9 x 13 x 8 cells of 1 mm with an oblique penny that cracks within 600 steps.
inline Case cracking_block_in_space() {
  Case settings = cracking_block();
  settings.dimension = 3;
  settings.grid.cell_size = 1e-3;
  settings.bodies.front().size = Vector(9e-3, 13e-3, 8e-3);
  Flaw penny;
  penny.shape = FlawShape::penny;
  penny.length = 5e-3;
  penny.width = 2e-3;
  penny.normal = Vector(-1.0, 1.0, 0.3);
  settings.flaws = {penny};
  for (Platen& platen : settings.platens) {
    platen.speed = 0.03;
  }
  return settings;
}

inline Case softening_block_in_space() {
  Case settings = cracking_block_in_space();
  settings.materials["rock"].failure = softening_block().materials["rock"].failure;
  settings.local_damping = 0.1;
  return settings;
}

/// Mean of a stress component over the volume of all particles, Pa.
template <int Dim>
double mean_stress(const Particles<Dim>& p, int component) {
  double sum = 0.0;
  double volume = 0.0;
  for (std::size_t i = 0; i < p.lanes(); ++i) {
    sum += p.volume[i] * p.stress[component][i];
    volume += p.volume[i];
  }
  return sum / volume;
}

}  // namespace rgimp::tests
