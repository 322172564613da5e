// The kernels alone, on one thread and in cache: each as the engine calls it, over all rows, and
// the parts that passes are made of.

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <map>

#include "kernel_state.hpp"
#include "main.hpp"
#include "traffic.hpp"

namespace rgimp::bench {
namespace {

using kernels::Isa;
using Table = kernels::KernelTable<2>;

/// Slots that a part's results are kept of while it is timed: of one round of a pass.
constexpr std::size_t kSlotsKept = 16;

/// A call, and the doubles that it reads and writes: of particle columns per lane, or of node
/// fields per node. Node fields of a pass are left out, as in bytes_of_step().
struct Kernel {
  const char* name;
  void (*run)(const Table&, KernelState&);
  int doubles;
  bool on_nodes = false;
};

/// As Kernel; what it writes stays in the first cache.
struct NamedPart {
  const char* name;
  Part KernelParts::*part;
  std::size_t columns;
  int doubles;
};

template <Table::Scatter Table::*Entry>
void scatter(const Table& table, KernelState& state) {
  (table.*Entry)(state.particles.view(), state.grid.view(1), state.bins());
}

template <Table::Pass Table::*Entry>
void pass(const Table& table, KernelState& state) {
  (table.*Entry)(state.particles.view(), state.grid.view(0), state.grid.view(1), state.update(),
                 state.bins());
}

void update_nodes(const Table& table, KernelState& state) {
  table.update_nodes(state.grid.view(), state.node_update, state.nodes(), state.node_sums.data());
}

void divide_by_mass(const Table& table, KernelState& state) {
  const kernels::GridView<2> grid = state.grid.view();
  table.divide_by_mass(grid, grid.momentum, state.node_update.least_mass, state.nodes());
}

using Of = Columns<2>;

const Kernel kKernels[] = {
    {"scatter_all", scatter<&Table::scatter_all>, Of::kAll - Of::kFailureMode},
    {"scatter_mass_momentum", scatter<&Table::scatter_mass_momentum>, Of::kMotion},
    {"accelerate", pass<&Table::accelerate>, Of::kMotion + Of::kVelocity},
    {"strain_and_move", pass<&Table::strain_and_move>, Of::kAll + Of::kPosition + Of::kStrained},
    {"accelerate_strain_and_move", pass<&Table::accelerate_strain_and_move>,
     Of::kAll + Of::kVelocity + Of::kPosition + Of::kStrained},
    {"strain", pass<&Table::strain>, Of::kAll - Of::kVelocity + Of::kStrained},
    {"accelerate_and_move", pass<&Table::accelerate_and_move>,
     Of::kMotion + Of::kPosition + Of::kVelocity},
    {"update_nodes", update_nodes, 1 + 1 + 2 * 4, true},  // mass, damping; two fields updated
    {"divide_by_mass", divide_by_mass, 1 + 2 * 2, true},
};

const NamedPart kParts[] = {
    {"weights", &KernelParts::weights, kWeightColumns, Of::kPosition},
    {"G2P", &KernelParts::gather, kGatherColumns, Of::kPosition},
    {"stress", &KernelParts::stress, kStressColumns, Of::kVelocity + Of::kStress},
    {"failure", &KernelParts::failure, kFailureColumns, Of::kStress},
};

const KernelParts& parts_for(Isa isa) {
  switch (isa) {
    case Isa::reference:
      return kReferenceParts;
    case Isa::baseline:
      return kBaselineParts;
    case Isa::avx2:
      return kAvx2Parts;
    case Isa::avx512:
      return kAvx512Parts;
  }
  return kReferenceParts;
}

std::string compare(const Kernel& kernel, Isa isa) {
  KernelState got = initial_state();
  KernelState expected = initial_state();
  kernel.run(kernels::kernels_for<2>(isa), got);
  kernel.run(kernels::kernels_for<2>(Isa::reference), expected);
  return difference(got, expected);
}

std::string compare(const NamedPart& named, Isa isa) {
  KernelState state = initial_state();
  state.load_to_failure();
  Column<double> got(state.slots() * kernels::kGroupWidth * named.columns, 0.0);
  Column<double> expected(got.size(), 0.0);
  const std::size_t all = ~std::size_t{0};
  (parts_for(isa).*named.part)(state.part_input(), got.data(), all);
  (kReferenceParts.*named.part)(state.part_input(), expected.data(), all);
  return difference(state, got, expected, named.columns);
}

/// What of a kernel or part differs from its scalar twin; each is compared once a run.
template <typename What>
bool is_verified(benchmark::State& state, const What& what, Isa isa) {
  static std::map<std::pair<std::string, Isa>, std::string> differences;
  const std::pair<std::string, Isa> key{what.name, isa};
  auto found = differences.find(key);
  if (found == differences.end()) {
    found = differences.emplace(key, compare(what, isa)).first;
  }
  if (!found->second.empty()) {
    state.SkipWithError(found->second.c_str());
  }
  return found->second.empty();
}

/// `doubles` of one run.
void count(benchmark::State& state, const KernelState& on, double doubles) {
  using benchmark::Counter;
  const auto runs = static_cast<double>(state.iterations());
  const auto particles = static_cast<double>(on.particles.count);
  state.counters["particles"] = particles;
  state.counters["particles_per_second"] = Counter(runs * particles, Counter::kIsRate);
  state.counters["ns_per_particle"] =
      Counter(runs * particles * 1e-9, Counter::kIsRate | Counter::kInvert);
  state.counters["model_bytes_per_second"] =
      Counter(runs * doubles * sizeof(double), Counter::kIsRate);
}

void time_kernel(benchmark::State& state, const Kernel& kernel, Isa isa) {
  if (!is_verified(state, kernel, isa)) {
    return;
  }
  KernelState on = initial_state();
  on.hold_still();
  const Table& table = kernels::kernels_for<2>(isa);
  for ([[maybe_unused]] auto _ : state) {
    kernel.run(table, on);
  }
  const std::size_t places = kernel.on_nodes ? on.node_count() : on.particles.lanes();
  count(state, on, kernel.doubles * static_cast<double>(places));
}

void time_part(benchmark::State& state, const NamedPart& named, Isa isa) {
  if (!is_verified(state, named, isa)) {
    return;
  }
  KernelState on = initial_state();
  const PartInput input = on.part_input();
  Column<double> out(kSlotsKept * kernels::kGroupWidth * named.columns, 0.0);
  const Part part = parts_for(isa).*named.part;
  for ([[maybe_unused]] auto _ : state) {
    part(input, out.data(), kSlotsKept - 1);
  }
  count(state, on, named.doubles * static_cast<double>(on.particles.lanes()));
}

template <typename What, typename Run>
void add(const What& what, Run run) {
  for (const Isa isa : kernels::kAllIsas) {
    if (kernels::available(isa)) {
      const std::string name = fmt::format("kernel/name:{}/isa:{}", what.name, kernels::name(isa));
      benchmark::RegisterBenchmark(name.c_str(), run, what, isa)
          ->UseRealTime()
          ->Unit(benchmark::kMicrosecond);
    }
  }
}

}  // namespace

void add_benchmarks() {
  for (const Kernel& kernel : kKernels) {
    add(kernel, time_kernel);
  }
  for (const NamedPart& part : kParts) {
    add(part, time_part);
  }
}

}  // namespace rgimp::bench
