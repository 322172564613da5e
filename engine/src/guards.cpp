#include "guards.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "lane_chunks.hpp"
#include "rgimp/error.hpp"

namespace rgimp {
namespace {

constexpr std::string_view kCalmer =
    "lower time.step_factor, or raise damping.local or viscosity.linear if the specimen bursts";

template <int Dim>
bool is_finite(Particles<Dim>& particles, std::size_t lane) {
  bool finite = true;
  particles.for_each_column([&](const auto& column, auto) {
    if constexpr (std::is_floating_point_v<std::decay_t<decltype(column[lane])>>) {
      finite &= std::isfinite(column[lane]);
    }
  });
  return finite;
}

template <int Dim>
bool is_before(const Particles<Dim>& particles, std::size_t lane,
               const std::optional<std::size_t>& other) {
  return !other || particles.id[lane] < particles.id[*other];
}

/// The broken particle of the lowest id among some lanes.
template <int Dim>
std::optional<std::size_t> find_broken(Particles<Dim>& particles, LaneRange lanes) {
  std::optional<std::size_t> found;
  for (std::size_t lane = lanes.first; lane < lanes.last; ++lane) {
    const bool sound = is_finite(particles, lane) && particles.volume[lane] > 0.0;
    if (!sound && !particles.is_padding(lane) && is_before(particles, lane, found)) {
      found = lane;
    }
  }
  return found;
}

template <int Dim>
std::optional<std::size_t> find_broken(Particles<Dim>& particles, Workers& workers) {
  std::vector<std::optional<std::size_t>> by_chunk(chunks_of(particles.lanes()));
  for_each_chunk(particles.lanes(), workers, [&](std::size_t chunk, LaneRange lanes) {
    by_chunk[chunk] = find_broken(particles, lanes);
  });
  std::optional<std::size_t> found;
  for (const std::optional<std::size_t>& lane : by_chunk) {
    if (lane && is_before(particles, *lane, found)) {
      found = lane;
    }
  }
  return found;
}

template <int Dim>
std::size_t find_fastest(const Particles<Dim>& particles) {
  std::optional<std::size_t> fastest;
  double most = 0.0;
  for (std::size_t lane = 0; lane < particles.lanes(); ++lane) {
    if (particles.is_padding(lane)) {
      continue;
    }
    double speed = 0.0;
    for (const auto& component : particles.velocity) {
      speed = std::hypot(speed, component[lane]);
    }
    if (!fastest || speed > most || (speed == most && is_before(particles, lane, fastest))) {
      fastest = lane;
      most = speed;
    }
  }
  return *fastest;
}

/// One of the columns that are not finite, for people.
template <int Dim>
std::string_view lost_quantity(const Particles<Dim>& particles, std::size_t lane) {
  const auto lost = [lane](const auto& columns) {
    return std::any_of(columns.begin(), columns.end(),
                       [lane](const auto& column) { return !std::isfinite(column[lane]); });
  };
  if (lost(particles.position)) {
    return "position";
  }
  if (lost(particles.velocity)) {
    return "velocity";
  }
  if (lost(particles.stress)) {
    return "stress";
  }
  return std::isfinite(particles.volume[lane]) ? "viscous stress or damage" : "volume";
}

template <int Dim>
std::string text_of(const std::array<double, 3>& vector) {
  std::string text = fmt::format("({:.6g}, {:.6g}", vector[0], vector[1]);
  return text + (Dim == 3 ? fmt::format(", {:.6g})", vector[2]) : ")");
}

/// "step 7: WHAT: position (x, y) m, velocity (x, y) m/s, dt/dt_cr 0.4; ADVICE".
template <int Dim>
[[noreturn]] void stop(const Particles<Dim>& particles, std::size_t lane, const GuardedStep& step,
                       std::string_view what, std::string_view advice) {
  PhysicsReport report;
  report.step = step.number;
  report.particle = particles.id[lane];
  report.critical_step_ratio = step.critical_step_ratio;
  for (int a = 0; a < Dim; ++a) {
    report.position[a] = particles.position[a][lane];
    report.velocity[a] = particles.velocity[a][lane];
  }
  throw PhysicsError(fmt::format("step {}: {}: position {} m, velocity {} m/s, dt/dt_cr {:.4g}; {}",
                                 step.number, what, text_of<Dim>(report.position),
                                 text_of<Dim>(report.velocity), step.critical_step_ratio, advice),
                     report);
}

}  // namespace

template <int Dim>
void stop_if_broken(Particles<Dim>& particles, const GuardedStep& step, Workers& workers) {
  const std::optional<std::size_t> lane = find_broken(particles, workers);
  if (!lane) {
    return;
  }
  const std::uint32_t id = particles.id[*lane];
  if (!is_finite(particles, *lane)) {
    stop(particles, *lane, step,
         fmt::format("the {} of particle {} is not a finite number",
                     lost_quantity(particles, *lane), id),
         kCalmer);
  }
  stop(particles, *lane, step,
       fmt::format("particle {} is turned inside out, its volume is {:.6g} m{}", id,
                   particles.volume[*lane], Dim),
       "lower time.step_factor, or load more slowly");
}

template <int Dim>
void stop_if_too_fast(const Particles<Dim>& particles, const GuardedStep& step) {
  if (step.critical_step_ratio > 1.0) {
    const std::size_t fastest = find_fastest(particles);
    stop(particles, fastest, step,
         fmt::format("the time step {:.6g} s is {:.4g} times the critical one (Eq. 22) at {:.4g} "
                     "m/s, and particle {} is the fastest",
                     step.dt, step.critical_step_ratio, step.max_speed, particles.id[fastest]),
         kCalmer);
  }
}

template <int Dim>
void stop_at_lost_energies(const Particles<Dim>& particles, const GuardedStep& step) {
  const std::size_t fastest = find_fastest(particles);
  stop(particles, fastest, step,
       fmt::format("works and energies are not finite, and particle {} is the fastest",
                   particles.id[fastest]),
       kCalmer);
}

template <int Dim>
void stop_outside(const Particles<Dim>& particles, const std::vector<std::size_t>& lanes,
                  const GuardedStep& step) {
  constexpr std::string_view larger =
      "enlarge the grid with grid.min and grid.max (it follows the platens), or see whether the "
      "specimen has burst (smaller time.step_factor, more damping.local)";
  const std::uint32_t id = particles.id[lanes.front()];
  if (lanes.size() == particles.count) {
    stop(particles, lanes.front(), step,
         fmt::format("none of the particles is in the grid any more, nor is particle {}", id),
         larger);
  }
  stop(particles, lanes.front(), step, fmt::format("particle {} left the grid", id),
       fmt::format("{}, or go on without such particles: grid.on_exit = \"remove\"", larger));
}

template void stop_if_broken<2>(Particles<2>&, const GuardedStep&, Workers&);
template void stop_if_too_fast<2>(const Particles<2>&, const GuardedStep&);
template void stop_at_lost_energies<2>(const Particles<2>&, const GuardedStep&);
template void stop_outside<2>(const Particles<2>&, const std::vector<std::size_t>&,
                              const GuardedStep&);
template void stop_if_broken<3>(Particles<3>&, const GuardedStep&, Workers&);
template void stop_if_too_fast<3>(const Particles<3>&, const GuardedStep&);
template void stop_at_lost_energies<3>(const Particles<3>&, const GuardedStep&);
template void stop_outside<3>(const Particles<3>&, const std::vector<std::size_t>&,
                              const GuardedStep&);

}  // namespace rgimp
