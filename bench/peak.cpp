#include "peak.hpp"

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "peak_loops.hpp"
#include "setting.hpp"
#include "workers.hpp"

namespace rgimp::bench {
namespace {

using kernels::Isa;

/// The reference is compiled with the baseline's flags.
const PeakLoops& loops_for(Isa isa) {
  switch (isa) {
    case Isa::reference:
    case Isa::baseline:
      return kBaselineLoops;
    case Isa::avx2:
      return kAvx2Loops;
    case Isa::avx512:
      return kAvx512Loops;
  }
  return kBaselineLoops;
}

void fma(benchmark::State& state, Isa isa, int threads) {
  constexpr std::ptrdiff_t kChunks = 256;
  constexpr std::int64_t kRounds = 20'000;
  const PeakLoops& loops = loops_for(isa);
  Workers workers(threads);
  std::vector<double> sums(kChunks);
  workers.region([&] {
    for ([[maybe_unused]] auto _ : state) {
      workers.for_each(kChunks, [&](std::ptrdiff_t i) { sums[i] = loops.fma(kRounds); });
      benchmark::DoNotOptimize(sums.data());
      benchmark::ClobberMemory();
    }
  });
  state.counters["flops"] = benchmark::Counter(
      loops.flops_per_round * static_cast<double>(kRounds * kChunks * state.iterations()),
      benchmark::Counter::kIsRate);
}

/// Doubles of an array of the triad: four times the last-level cache, as STREAM asks for.
std::ptrdiff_t triad_length() {
  constexpr std::ptrdiff_t kAtLeast = std::ptrdiff_t{1} << 25;  // bytes, where no cache is known
  std::ptrdiff_t cache = kAtLeast;
  for (const auto& info : benchmark::CPUInfo::Get().caches) {
    cache = std::max<std::ptrdiff_t>(cache, info.size);
  }
  return 4 * cache / static_cast<std::ptrdiff_t>(sizeof(double));
}

/// Counts 24 bytes an element, two reads and a write. Where the machine reads a cache line before
/// it writes one whole (write-allocate), it moves 32.
void triad(benchmark::State& state, int threads) {
  constexpr std::ptrdiff_t kChunk = 1 << 15;
  constexpr double kBytes = 3.0 * sizeof(double);
  const PeakLoops& loops = loops_for(kernels::best_isa());
  const std::ptrdiff_t chunks = triad_length() / kChunk;
  const auto length = static_cast<std::size_t>(chunks * kChunk);
  std::vector<double> a(length);
  const std::vector<double> b(length, 1.0);
  const std::vector<double> c(length, 2.0);
  Workers workers(threads);
  workers.region([&] {
    for ([[maybe_unused]] auto _ : state) {
      workers.for_each(chunks, [&](std::ptrdiff_t i) {
        loops.triad(a.data(), b.data(), c.data(), i * kChunk, (i + 1) * kChunk);
      });
      benchmark::ClobberMemory();
    }
  });
  state.counters["bytes_per_second"] = benchmark::Counter(
      kBytes * static_cast<double>(length) * static_cast<double>(state.iterations()),
      benchmark::Counter::kIsRate);
}

template <typename Run, typename... Arguments>
void add(const std::string& name, Run run, Arguments... arguments) {
  benchmark::RegisterBenchmark(name.c_str(), run, arguments...)
      ->UseRealTime()
      ->Unit(benchmark::kMillisecond);
}

}  // namespace

void add_peak_benchmarks() {
  for (const int threads : kThreadCounts) {
    for (const Isa isa : {Isa::baseline, Isa::avx2, Isa::avx512}) {
      if (kernels::available(isa)) {
        add(fmt::format("fma/isa:{}/threads:{}", kernels::name(isa), threads), fma, isa, threads);
      }
    }
    add(fmt::format("triad/threads:{}", threads), triad, threads);
  }
}

}  // namespace rgimp::bench
