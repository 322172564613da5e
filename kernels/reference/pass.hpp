#pragma once

#include "p2g.hpp"
#include "stress.hpp"

/// The scalar twins of the passes: particle by particle, each written out for its integrator.
namespace rgimp::kernels::reference {

/// Calls visit(particle, its bin's node, its slot) row by row and keeps the rows' sums.
template <int Dim, typename Visit>
void for_each_row(const ParticleView<Dim>& particles, const GridView<Dim>& grid, RowRange bins,
                  Visit visit) {
  for (std::ptrdiff_t row = bins.first; row < bins.last; ++row) {
    for_each_particle(particles, grid, {row, row + 1},
                      [&](std::size_t p, const BinNode<Dim>& bin, std::size_t slot) {
                        visit(row, p, bin, slot);
                      });
  }
}

inline void clear_rows(RowRange bins, const ParticleUpdate& update) {
  for (std::ptrdiff_t row = bins.first; row < bins.last; ++row) {
    update.sums[row] = ParticleSums{};
    update.reach[row] = Reach{};
  }
}

template <int Dim>
void scatter_all(const ParticleView<Dim>& particles, const GridView<Dim>& to, RowRange bins) {
  const Shape<Dim> shape(to);
  for_each_particle(particles, to, bins, [&](std::size_t p, const BinNode<Dim>& bin, std::size_t) {
    scatter_all_of(particles, p, stencil_of(particles, p, bin, shape), shape, to);
  });
}

template <int Dim>
void scatter_mass_momentum(const ParticleView<Dim>& particles, const GridView<Dim>& to,
                           RowRange bins) {
  const Shape<Dim> shape(to);
  for_each_particle(particles, to, bins, [&](std::size_t p, const BinNode<Dim>& bin, std::size_t) {
    scatter_mass_momentum_of(particles, p, stencil_of(particles, p, bin, shape), shape, to);
  });
}

template <int Dim>
void accelerate_pass(const ParticleView<Dim>& particles, const GridView<Dim>& from,
                     const GridView<Dim>& to, const ParticleUpdate& update, RowRange bins) {
  const Shape<Dim> shape(from);
  const Shape<Dim> shape_to(to);
  for_each_particle(
      particles, from, bins, [&](std::size_t p, const BinNode<Dim>& bin, std::size_t) {
        const Stencil<Dim> stencil = stencil_of(particles, p, bin, shape);
        accelerate(particles, p, gather_acceleration(stencil, shape, from), update.dt);
        scatter_second_momentum_of(particles, p, stencil_of(particles, p, bin, shape_to), shape_to,
                                   to);
      });
}

template <int Dim>
void strain_and_move_pass(const ParticleView<Dim>& particles, const GridView<Dim>& from,
                          const GridView<Dim>& to, const ParticleUpdate& update, RowRange bins) {
  const Shape<Dim> shape(from);
  const Shape<Dim> shape_to(to);
  clear_rows(bins, update);
  for_each_row(particles, from, bins,
               [&](std::ptrdiff_t row, std::size_t p, const BinNode<Dim>& bin, std::size_t slot) {
                 const Stencil<Dim> before = stencil_of(particles, p, bin, shape);
                 const FromNodes<Dim> nodes = gather_velocity_and_strain(before, shape, from);
                 update_particle(particles, p, nodes.gradient,
                                 update.materials[particles.slot_material[slot]], update.dt,
                                 update.step, update.sums[row]);
                 move(particles, p, bin, nodes.velocity, shape_to, update.dt, update.reach[row]);
                 scatter_all_of(particles, p, stencil_of(particles, p, bin, shape_to), shape_to,
                                to);
               });
}

template <int Dim>
void accelerate_strain_and_move_pass(const ParticleView<Dim>& particles, const GridView<Dim>& from,
                                     const GridView<Dim>& to, const ParticleUpdate& update,
                                     RowRange bins) {
  const Shape<Dim> shape(from);
  const Shape<Dim> shape_to(to);
  clear_rows(bins, update);
  for_each_row(particles, from, bins,
               [&](std::ptrdiff_t row, std::size_t p, const BinNode<Dim>& bin, std::size_t slot) {
                 const Stencil<Dim> before = stencil_of(particles, p, bin, shape);
                 const FromNodes<Dim> nodes = gather_all(before, shape, from);
                 accelerate(particles, p, nodes.acceleration, update.dt);
                 update_particle(particles, p, nodes.gradient,
                                 update.materials[particles.slot_material[slot]], update.dt,
                                 update.step, update.sums[row]);
                 move(particles, p, bin, nodes.velocity, shape_to, update.dt, update.reach[row]);
                 scatter_all_of(particles, p, stencil_of(particles, p, bin, shape_to), shape_to,
                                to);
               });
}

template <int Dim>
void strain_pass(const ParticleView<Dim>& particles, const GridView<Dim>& from,
                 const GridView<Dim>& to, const ParticleUpdate& update, RowRange bins) {
  const Shape<Dim> shape(from);
  const Shape<Dim> shape_to(to);
  for (std::ptrdiff_t row = bins.first; row < bins.last; ++row) {
    update.sums[row] = ParticleSums{};
  }
  for_each_row(particles, from, bins,
               [&](std::ptrdiff_t row, std::size_t p, const BinNode<Dim>& bin, std::size_t slot) {
                 const Stencil<Dim> stencil = stencil_of(particles, p, bin, shape);
                 update_particle(particles, p, gather_strain(stencil, shape, from),
                                 update.materials[particles.slot_material[slot]], update.dt,
                                 update.step, update.sums[row]);
                 scatter_force_of(particles, p, stencil_of(particles, p, bin, shape_to), shape_to,
                                  to);
               });
}

template <int Dim>
void accelerate_and_move_pass(const ParticleView<Dim>& particles, const GridView<Dim>& from,
                              const GridView<Dim>& to, const ParticleUpdate& update,
                              RowRange bins) {
  const Shape<Dim> shape(from);
  const Shape<Dim> shape_to(to);
  for (std::ptrdiff_t row = bins.first; row < bins.last; ++row) {
    update.reach[row] = Reach{};
  }
  for_each_row(particles, from, bins,
               [&](std::ptrdiff_t row, std::size_t p, const BinNode<Dim>& bin, std::size_t) {
                 const Stencil<Dim> before = stencil_of(particles, p, bin, shape);
                 const FromNodes<Dim> nodes = gather_motion(before, shape, from);
                 accelerate(particles, p, nodes.acceleration, update.dt);
                 move(particles, p, bin, nodes.velocity, shape_to, update.dt, update.reach[row]);
                 scatter_mass_momentum_of(particles, p, stencil_of(particles, p, bin, shape_to),
                                          shape_to, to);
               });
}

}  // namespace rgimp::kernels::reference
