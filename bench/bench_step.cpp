// Whole steps of example 1, and of a cube with a penny, with everything on (failure check, damping,
// platens, drift bound) in every way they can be computed, and the machine's peaks to hold them
// against.

#include <benchmark/benchmark.h>

#include "main.hpp"
#include "peak.hpp"
#include "step_timing.hpp"

namespace rgimp::bench {
namespace {

constexpr int kInCache = 100;      // the paper's resolution, 80,000 particles
constexpr int kOutOfCache = 1000;  // 8 million
constexpr int kSmallCube = 24;     // 110,000 particles, in the last cache
constexpr int kLargeCube = 64;     // 2.1 million, out of it

/// The scalar reference has one thread.
template <typename Isas>
void add_engines(Setting setting, const Isas& isas) {
  for (const kernels::Isa isa : isas) {
    for (const int threads : kThreadCounts) {
      if (kernels::available(isa) && (isa != kernels::Isa::reference || threads == 1)) {
        setting.isa = isa;
        setting.threads = threads;
        add_step_benchmark(setting.dimension == 3 ? "cube" : "step", setting);
      }
    }
  }
}

void add_cubes(Integrator integrator) {
  Setting setting;
  setting.dimension = 3;
  setting.integrator = integrator;
  setting.cells_across = kSmallCube;
  add_engines(setting, kernels::kAllIsas);
  setting.cells_across = kLargeCube;
  add_engines(setting,
              std::array{kernels::Isa::reference, kernels::Isa::avx2, kernels::best_isa()});
}

}  // namespace

void add_benchmarks() {
  add_peak_benchmarks();
  for (const Integrator integrator : kAllIntegrators) {
    for (const Arrangement arrangement : {Arrangement::lattice, Arrangement::random}) {
      Setting setting;
      setting.integrator = integrator;
      setting.arrangement = arrangement;
      setting.cells_across = kInCache;
      add_engines(setting, kernels::kAllIsas);
      setting.cells_across = kOutOfCache;
      add_engines(setting, std::array{kernels::Isa::reference, kernels::best_isa()});
    }
    add_cubes(integrator);
  }
}

}  // namespace rgimp::bench
