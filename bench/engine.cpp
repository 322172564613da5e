#include "engine.hpp"

#include <array>
#include <chrono>
#include <random>
#include <vector>

namespace rgimp::bench {

template <int Dim>
Engine<Dim>::Engine(const Setting& setting, const Case& settings) : workers_(setting.threads) {
  const auto start = std::chrono::steady_clock::now();
  solver_.emplace(settings, setting.isa, workers_);
  const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
  startup_seconds_ = spent.count();
  const Body& body = settings.bodies.front();
  if (setting.arrangement == Arrangement::random) {
    place_at_random(settings.grid.cell_size / body.particles_per_cell);
  }
  squeeze_and_shear(settings.platens.front().speed, 0.5 * body.size.y());
}

template <int Dim>
void Engine<Dim>::steps(std::int64_t count) {
  workers_.region([&] {
    for (std::int64_t i = 0; i < count; ++i) {
      solver_->step();
    }
  });
}

/// Each particle anywhere in the square or cube of a seed drawn at random: uniform over the
/// specimen, and never in a flaw.
template <int Dim>
void Engine<Dim>::place_at_random(double pitch) {
  Particles<Dim>& particles = solver_->particles();
  std::vector<std::array<double, Dim>> seeds;
  for (std::size_t i = 0; i < particles.lanes(); ++i) {
    if (!particles.is_padding(i)) {
      std::array<double, Dim>& seed = seeds.emplace_back();
      for (int a = 0; a < Dim; ++a) {
        seed[a] = particles.position[a][i];
      }
    }
  }
  std::mt19937_64 random(1);
  std::uniform_int_distribution<std::size_t> draw(0, seeds.size() - 1);
  std::uniform_real_distribution<double> within(-0.5 * pitch, 0.5 * pitch);
  for (std::size_t i = 0; i < particles.lanes(); ++i) {
    if (!particles.is_padding(i)) {
      const std::array<double, Dim>& seed = seeds[draw(random)];
      for (std::size_t a = 0; a < seed.size(); ++a) {
        particles.position[a][i] = seed[a] + within(random);
      }
    }
  }
  solver_->rebin();
}

template <int Dim>
void Engine<Dim>::squeeze_and_shear(double speed, double half_height) {
  Particles<Dim>& particles = solver_->particles();
  for (std::size_t i = 0; i < particles.lanes(); ++i) {
    if (!particles.is_padding(i)) {
      const double share = particles.position[1][i] / half_height;
      particles.velocity[0][i] = speed * share;
      particles.velocity[1][i] = -speed * share;
    }
  }
}

template class Engine<2>;
template class Engine<3>;

}  // namespace rgimp::bench
