#pragma once

#include <array>

#include "binning.hpp"
#include "failure_limits.hpp"
#include "rgimp/kernels/table.hpp"

namespace rgimp::tests {

/// Velocity gradient in the plane, 1/s.
struct PlaneGradient {
  double xx = 0.0;
  double xy = 0.0;  ///< d vx / d y
  double yx = 0.0;
  double yy = 0.0;
};

/// One particle in the middle of a small grid, strained by a linear velocity field.
class OneParticle {
 public:
  explicit OneParticle(const Material& material,
                       const Vector& offset_cells = Vector(0.25, -0.25, 0.0),
                       int particles_per_cell = 2)
      : workers_(1),
        grid_({Vector::Zero(), Vector::Constant(kCell), {17, 17, 1}}, particles_per_cell, 0.0) {
    Case settings;
    settings.grid.cell_size = kCell;
    constants_ = material_constants(material, settings);
    ParticleSeed seed;
    seed.position = kCell * (Vector(8.0, 8.0, 0.0) + offset_cells);
    seed.volume = 0.25 * kCell * kCell;
    seed.mass = material.density * seed.volume;
    particles_ = particles_from<2>({seed});
    if (constants_.softens) {
      particles_.damage = {0.0};
    }
    static_cast<void>(bin_particles(particles_, {0}, grid_, workers_));  // it is inside
    while (particles_.is_padding(lane_)) {
      ++lane_;
    }
  }

  void set_stress(const std::array<double, 4>& stress) {
    for (int c = 0; c < 4; ++c) {
      particles_.stress[c][lane_] = stress[c];
    }
  }
  std::array<double, 4> stress() const {
    return {particles_.stress[0][lane_], particles_.stress[1][lane_], particles_.stress[2][lane_],
            particles_.stress[3][lane_]};
  }
  double mode() const { return particles_.failure_mode[lane_]; }
  double damage() const { return particles_.damage[lane_]; }
  double volume() const { return particles_.volume[lane_]; }
  double viscous_energy() const { return particles_.viscous_energy[lane_]; }
  double mass() const { return particles_.mass[lane_]; }

  kernels::ParticleSums strain(const PlaneGradient& gradient, double dt, kernels::Isa isa) {
    const kernels::GridView<2> view = grid_.view();
    for (std::ptrdiff_t n = 0; n < grid_.rows() * grid_.row_stride(); ++n) {
      const Vector x = grid_.position(n);
      view.second_field[0][n] = gradient.xx * x.x() + gradient.xy * x.y();
      view.second_field[1][n] = gradient.yx * x.x() + gradient.yy * x.y();
    }
    std::array<kernels::ParticleSums, 17> sums{};
    const kernels::ParticleUpdate update{
        .dt = dt, .step = 1, .materials = &constants_, .sums = sums.data(), .reach = nullptr};
    kernels::kernels_for<2>(isa).strain(particles_.view(), view, grid_.view(1), update, {1, 16});
    return sums[8];
  }

  const kernels::MaterialConstants& material() const { return constants_; }
  Particles<2>& particles() { return particles_; }
  Grid<2>& grid() { return grid_; }
  std::size_t lane() const { return lane_; }
  static constexpr double kCell = 0.5e-3;

 private:
  Workers workers_;
  Grid<2> grid_;
  kernels::MaterialConstants constants_{};
  Particles<2> particles_;
  std::size_t lane_ = 0;
};

}  // namespace rgimp::tests
