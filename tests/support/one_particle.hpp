#pragma once

#include <array>
#include <catch2/catch.hpp>
#include <vector>

#include "binning.hpp"
#include "failure_limits.hpp"
#include "particles_of_seeds.hpp"
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
template <int Dim>
class OneParticle {
 public:
  using Stress = std::array<double, kernels::kStressComponents<Dim>>;

  explicit OneParticle(const Material& material,
                       const Vector& offset_cells = Vector(0.25, -0.25, 0.25),
                       int particles_per_cell = 2)
      : workers_(1),
        grid_({Vector::Zero(), Vector::Constant(kCell), {17, kRows, Dim == 2 ? 1 : 5}},
              particles_per_cell, 0.0) {
    Case settings;
    settings.grid.cell_size = kCell;
    constants_ = material_constants(material, settings);
    ParticleSeed seed;
    seed.position = kCell * (centre() + offset_cells);
    seed.volume = (Dim == 2 ? 0.25 : 0.125 * kCell) * kCell * kCell;
    seed.mass = material.density * seed.volume;
    particles_ = particles_from<Dim>({{seed}}, workers_);
    if (constants_.softens) {
      particles_.damage = {0.0};
    }
    static_cast<void>(bin_particles(particles_, {0}, grid_, workers_));  // it is inside
    while (particles_.is_padding(lane_)) {
      ++lane_;
    }
  }

  /// xx, yy, zz, xy; in three dimensions yz = xz = 0.
  void set_stress(const std::array<double, 4>& stress) {
    for (int c = 0; c < kernels::kStressComponents<Dim>; ++c) {
      particles_.stress[c][lane_] = c < 4 ? stress[c] : 0.0;
    }
  }
  void set_stress_in_space(const Stress& stress) {
    for (int c = 0; c < kernels::kStressComponents<Dim>; ++c) {
      particles_.stress[c][lane_] = stress[c];
    }
  }
  Stress stress() const {
    Stress s;
    for (std::size_t c = 0; c < s.size(); ++c) {
      s[c] = particles_.stress[c][lane_];
    }
    return s;
  }
  double mode() const { return particles_.failure_mode[lane_]; }
  double damage() const { return particles_.damage[lane_]; }
  double volume() const { return particles_.volume[lane_]; }
  double viscous_energy() const { return particles_.viscous_energy[lane_]; }
  double mass() const { return particles_.mass[lane_]; }

  kernels::ParticleSums strain(const PlaneGradient& gradient, double dt, kernels::Isa isa) {
    Eigen::Matrix3d in_space = Eigen::Matrix3d::Zero();
    in_space.topLeftCorner<2, 2>() << gradient.xx, gradient.xy, gradient.yx, gradient.yy;
    return strain_in_space(in_space, dt, isa);
  }

  /// `gradient` (a, b) is d v_a / d x_b, 1/s; in the plane its third row and column do not count.
  kernels::ParticleSums strain_in_space(const Eigen::Matrix3d& gradient, double dt,
                                        kernels::Isa isa) {
    const kernels::GridView<Dim> view = grid_.view();
    for_each_node_near([&](std::ptrdiff_t n) {
      const Vector velocity = gradient * grid_.position(n);
      for (int a = 0; a < Dim; ++a) {
        view.second_field[a][n] = velocity[a];
      }
    });
    std::vector<kernels::ParticleSums> sums(static_cast<std::size_t>(grid_.rows()));
    const kernels::ParticleUpdate update{
        .dt = dt, .step = 1, .materials = &constants_, .sums = sums.data(), .reach = nullptr};
    kernels::kernels_for<Dim>(isa).strain(particles_.view(), view, grid_.view(1), update, bins());
    return sums[static_cast<std::size_t>(Dim == 2 ? 8 : 2 * kRows + 8)];
  }

  const kernels::MaterialConstants& material() const { return constants_; }
  Particles<Dim>& particles() { return particles_; }
  Grid<Dim>& grid() { return grid_; }
  std::size_t lane() const { return lane_; }
  /// Rows of bins with neighbours on all sides.
  kernels::RowRange bins() const {
    const std::ptrdiff_t first = Dim == 2 ? 1 : kRows + 1;
    return {first, grid_.rows() - first};
  }
  /// The node that the particle is near, cells.
  static Vector centre() { return {8.0, 8.0, Dim == 2 ? 0.0 : 2.0}; }
  static constexpr double kCell = 0.5e-3;

 private:
  static constexpr std::int64_t kRows = 17;

  /// Calls visit(node) for all that the particle may reach. Over the whole grid, a sixteenth of
  /// which they are in space, the tests took many minutes under AddressSanitizer.
  template <typename Visit>
  void for_each_node_near(Visit visit) const {
    constexpr std::ptrdiff_t kNear = 2;
    const Vector middle = centre();
    for (std::ptrdiff_t z = Dim == 2 ? 0 : -kNear; z <= (Dim == 2 ? 0 : kNear); ++z) {
      for (std::ptrdiff_t y = -kNear; y <= kNear; ++y) {
        const auto row =
            static_cast<std::ptrdiff_t>(middle.z() * kRows + middle.y()) + z * kRows + y;
        for (std::ptrdiff_t x = -kNear; x <= kNear; ++x) {
          visit(row * grid_.row_stride() + static_cast<std::ptrdiff_t>(middle.x()) + x);
        }
      }
    }
  }

  Workers workers_;
  Grid<Dim> grid_;
  kernels::MaterialConstants constants_{};
  Particles<Dim> particles_;
  std::size_t lane_ = 0;
};

/// Calls test(isa) for every instruction set of this machine.
template <typename Test>
void on_each_isa(Test test) {
  for (const kernels::Isa isa : kernels::kAllIsas) {
    if (kernels::available(isa)) {
      INFO(kernels::name(isa));
      test(isa);
    }
  }
}

}  // namespace rgimp::tests
