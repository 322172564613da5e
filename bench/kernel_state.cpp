#include "kernel_state.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine.hpp"
#include "failure_limits.hpp"

namespace rgimp::bench {
namespace {

using kernels::kGroupWidth;

const Setting kSetting{};  // 80,000 particles: in cache

/// Of the largest value of a column: sums of some ten terms in another order.
constexpr double kTolerance = 1e-12;

/// Even, so that the first layer of the grid is the one that the next step gathers from.
constexpr std::int64_t kStepsBefore = 20;

Engine<2>& engine_in_motion() {
  static Engine<2> engine(kSetting, case_of(kSetting));
  static const bool moved = (engine.steps(kStepsBefore), true);
  static_cast<void>(moved);
  return engine;
}

/// Zeroes what particles gather from nodes that they but touch (1e-21 to 1e-16 of the heaviest).
/// There accelerations reach 5e9 m/s2, which the round-off of a weight lets through to the
/// particle: kernels that round otherwise differ by 1e-9 of the largest value gathered, and are
/// both right.
void quieten_touched_nodes(const kernels::GridView<2>& grid, std::size_t nodes) {
  constexpr double kTouched = 1e-9;  // of the heaviest
  const double least = kTouched * *std::max_element(grid.mass, grid.mass + nodes);
  for (std::size_t node = 0; node < nodes; ++node) {
    for (int a = 0; a < 2 && grid.mass[node] < least; ++a) {
      grid.momentum[a][node] = grid.force[a][node] = grid.second_field[a][node] = 0.0;
    }
  }
}

/// Largest difference as a share of the largest value expected.
class Comparison {
 public:
  void add(double got, double expected) {
    const double difference = std::abs(got - expected);
    worst_ = std::isfinite(difference) ? std::max(worst_, difference)
                                       : std::numeric_limits<double>::infinity();
    largest_ = std::max(largest_, std::abs(expected));
  }
  std::string result(const std::string& what) const {
    return worst_ <= kTolerance * largest_
               ? ""
               : fmt::format("{} differs from the scalar reference by {:.3g} of {:.3g}", what,
                             worst_, largest_);
  }

 private:
  double worst_ = 0.0;
  double largest_ = 0.0;
};

std::string difference_of_particles(KernelState& got, KernelState& expected) {
  std::vector<std::vector<double>> values;
  const auto collect = [&values](Particles<2>& particles) {
    particles.for_each_column([&](const auto& column, auto) {
      values.emplace_back();
      for (std::size_t i = 0; i < column.size(); ++i) {
        if (!particles.is_padding(i)) {
          values.back().push_back(static_cast<double>(column[i]));
        }
      }
    });
  };
  collect(got.particles);
  const std::size_t columns = values.size();
  collect(expected.particles);
  std::string found;
  for (std::size_t column = 0; column < columns && found.empty(); ++column) {
    Comparison comparison;
    for (std::size_t i = 0; i < values[column].size(); ++i) {
      comparison.add(values[column][i], values[columns + column][i]);
    }
    found = comparison.result(fmt::format("particle column {}", column));
  }
  return found;
}

std::string difference_of_nodes(KernelState& got, KernelState& expected) {
  std::string found;
  const auto compare = [&](const char* what, const double* one, const double* other) {
    Comparison comparison;
    for (std::size_t n = 0; n < got.node_count(); ++n) {
      comparison.add(one[n], other[n]);
    }
    found = found.empty() ? comparison.result(what) : found;
  };
  for (const int layer : {0, 1}) {
    const kernels::GridView<2> one = got.grid.view(layer);
    const kernels::GridView<2> other = expected.grid.view(layer);
    compare("node mass", one.mass, other.mass);
    for (int a = 0; a < 2; ++a) {
      compare("node momentum", one.momentum[a], other.momentum[a]);
      compare("node force", one.force[a], other.force[a]);
      compare("second field", one.second_field[a], other.second_field[a]);
    }
  }
  return found;
}

}  // namespace

KernelState::KernelState()
    : particles(engine_in_motion().solver().particles()),
      grid(engine_in_motion().solver().grid()),
      node_update{.dt = engine_in_motion().solver().dt(),
                  .least_mass = 1e-24,
                  .body_acceleration = {3.0, -9.81}},
      node_sums(static_cast<std::size_t>(grid.rows())),
      sums_(node_sums.size()),
      reach_(node_sums.size()) {
  const Case settings = case_of(kSetting);
  for (const auto& [name, material] : settings.materials) {
    materials.push_back(material_constants(material, settings));
  }
  quieten_touched_nodes(grid.view(), node_count());
}

void KernelState::hold_still() {
  constexpr double kInstant = 1e-20;       // s; by 0 bulk viscosity would divide
  constexpr double kUnit = 1.0 + 0x1p-30;  // kg; all bits of 1 / m are used
  node_update = {.dt = kInstant, .least_mass = 0.0, .body_acceleration = {0.0, 0.0}};
  double* const mass = grid.view().mass;
  std::fill(mass, mass + node_count(), kUnit);
  for (std::size_t node = 0; node < node_count(); ++node) {
    grid.clear_damping(static_cast<std::ptrdiff_t>(node));
  }
}

void KernelState::load_to_failure() {
  const PartInput input = part_input();
  Column<double> fails(particles.lanes(), 0.0);
  while (std::count(fails.begin(), fails.end(), 1.0) <
         static_cast<std::ptrdiff_t>(particles.count / 4)) {
    for (auto& component : particles.stress) {
      std::transform(component.begin(), component.end(), component.begin(),
                     [](double stress) { return 2.0 * stress; });
    }
    kReferenceParts.failure(input, fails.data(), ~std::size_t{0});
  }
}

std::size_t KernelState::node_count() const {
  return static_cast<std::size_t>(grid.rows() * grid.row_stride());
}

kernels::ParticleUpdate KernelState::update() {
  return {.dt = node_update.dt,
          .step = 1,
          .materials = materials.data(),
          .sums = sums_.data(),
          .reach = reach_.data()};
}

PartInput KernelState::part_input() {
  return {.particles = particles.view(),
          .grid = grid.view(),
          .material = materials.data(),
          .strain_per_velocity = node_update.dt / grid.view().spacing[0],
          .bins = bins()};
}

const KernelState& initial_state() {
  static const KernelState state;
  return state;
}

std::string difference(KernelState& got, KernelState& expected) {
  const std::string particles = difference_of_particles(got, expected);
  return particles.empty() ? difference_of_nodes(got, expected) : particles;
}

std::string difference(const KernelState& state, const Column<double>& got,
                       const Column<double>& expected, std::size_t columns) {
  std::string found;
  for (std::size_t column = 0; column < columns && found.empty(); ++column) {
    Comparison comparison;
    for (std::size_t i = 0; i < state.particles.lanes(); ++i) {
      const std::size_t place =
          (i / kGroupWidth * columns + column) * kGroupWidth + i % kGroupWidth;
      if (!state.particles.is_padding(i)) {
        comparison.add(got[place], expected[place]);
      }
    }
    found = comparison.result(fmt::format("column {}", column));
  }
  return found;
}

}  // namespace rgimp::bench
