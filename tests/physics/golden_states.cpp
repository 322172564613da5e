#include <fmt/format.h>

#include <cstdio>
#include <functional>
#include <initializer_list>

#include "history_file.hpp"
#include "models.hpp"
#include "state_hash.hpp"

// The states that golden_hashes.toml holds the hashes of, one line for each case and instruction
// set: case, instruction set, hash of the particles, last row of the history. golden_hashes.py runs
// it.
namespace rgimp::tests {
namespace {

Case with_integrator(Integrator integrator) {
  Case settings = cracking_block();
  settings.time.integrator = integrator;
  return settings;
}

/// A disk with a slot off its loaded diameter, split by narrow platens.
Case split_disk() {
  Case settings = compressed_block(20.0, 20.0, 0.4);
  settings.bodies.front().shape = BodyShape::disk;
  settings.materials["rock"].failure = rock_failure();
  Flaw slot;
  slot.center = Vector(1e-3, 3e-3, 0.0);
  slot.length = 6e-3;
  slot.width = 1.5e-3;
  slot.angle = 70.0;
  slot.ends = SlotEnds::round;
  settings.flaws = {slot};
  for (Platen& platen : settings.platens) {
    platen.half_width = 1e-3;
  }
  settings.local_damping = 0.7;
  return settings;
}

/// Rock with a hole on a softer, weaker layer, under a load and a weight of its own.
Case heavy_layers() {
  Case settings = compressed_block(12.0, 12.0, 0.4);
  settings.materials["rock"].failure = rock_failure();
  Body layer = settings.bodies.front();
  layer.center.y() -= 12e-3;
  layer.material = "layer";
  settings.bodies.push_back(layer);
  Material& soft = settings.materials["layer"] = {
      .density = 1900.0, .youngs_modulus = 6e9, .poisson_ratio = 0.25, .failure = Failure{}};
  soft.failure->criterion = Criterion::shear_stress;
  soft.failure->shear_strength = 4e6;
  soft.failure->treatment = Treatment::stress_free;
  Flaw hole;
  hole.shape = FlawShape::circle;
  hole.length = 4e-3;
  settings.flaws = {hole};
  settings.platens.front().lateral = Lateral::stick;
  settings.body_acceleration = Vector(2e3, -2e4, 0.0);
  settings.local_damping = 0.3;
  return settings;
}

struct GoldenCase {
  const char* name;
  std::function<Case()> make;
};

/// Ends with an exception where a case no longer cracks: it would prove little.
template <int Dim>
void print_state(const GoldenCase& golden, kernels::Isa isa) {
  constexpr int kParts = Dim == 2 ? 8 : 4;
  constexpr int kStepsOfPart = 200;
  ModelIn<Dim> model(golden.make(), 2, isa);
  for (int part = 0; part < kParts; ++part) {
    model.steps(kStepsOfPart);
    model.solver.rebin();
  }
  const HistoryRow row = model.solver.history();
  if (row.failed_tension + row.failed_shear < 20) {
    throw std::runtime_error(fmt::format("fewer than 20 particles of {} failed", golden.name));
  }
  fmt::print("{} {} {:016x} {}\n", golden.name, kernels::name(isa),
             state_hash(model.solver.particles()), format_history_row(row));
}

template <int Dim>
void print_states(std::initializer_list<GoldenCase> cases) {
  for (const GoldenCase& golden : cases) {
    for (const kernels::Isa isa : kernels::kAllIsas) {
      if (kernels::available(isa)) {
        print_state<Dim>(golden, isa);
      }
    }
  }
}

void print_states() {
  print_states<2>({{"block-musl", [] { return with_integrator(Integrator::musl); }},
                   {"block-usl", [] { return with_integrator(Integrator::usl); }},
                   {"block-usf", [] { return with_integrator(Integrator::usf); }},
                   {"softening", softening_block},
                   {"disk", split_disk},
                   {"layers", heavy_layers}});
  print_states<3>(
      {{"penny", cracking_block_in_space}, {"softening-penny", softening_block_in_space}});
}

}  // namespace
}  // namespace rgimp::tests

int main() {
  try {
    rgimp::tests::print_states();
  } catch (const std::exception& error) {
    fmt::print(stderr, "golden_states: error: {}\n", error.what());
    return 1;
  }
  return 0;
}
