#include <atomic>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <new>

#include "models.hpp"
#include "rgimp/rgimp.hpp"

// Every allocation of a simulation is refused once: std::bad_alloc must reach the caller, and
// nothing else may happen. Files are left out: libstdc++'s std::filesystem::is_empty and
// nlohmann-json end the process where they get no memory, toml++ takes a number it has no memory to
// read for a wrong one. oneTBB, which sets itself up once, would wait for ever: it is set up
// before.
namespace {

constexpr std::int64_t kNever = -1;
std::atomic<std::int64_t> allowed{kNever};  // allocations before the one that fails

void* allocate(std::size_t size, std::size_t alignment) {
  if (allowed.load() >= 0 && allowed.fetch_sub(1) == 0) {
    throw std::bad_alloc();  // with -1 allowed the ones after it succeed
  }
  const std::size_t whole = (size + alignment - 1) / alignment * alignment;
  void* memory = std::aligned_alloc(alignment, whole == 0 ? alignment : whole);
  if (memory == nullptr) {
    throw std::bad_alloc();
  }
  return memory;
}

}  // namespace

// GCC does not see that the operators below belong together once it has inlined one of them.
#pragma GCC diagnostic ignored "-Wmismatched-new-delete"

void* operator new(std::size_t size) {
  return allocate(size, alignof(std::max_align_t));
}
void* operator new(std::size_t size, std::align_val_t alignment) {
  return allocate(size, static_cast<std::size_t>(alignment));
}
// AddressSanitizer has one of its own, whose memory must not come to our delete.
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  try {
    return operator new(size);
  } catch (const std::bad_alloc&) {
    return nullptr;
  }
}
void operator delete(void* memory) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::align_val_t) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
  std::free(memory);
}

namespace rgimp::tests {
namespace {

/// How many allocations `work` makes, after it has failed at each of them. (The standard library
/// does without some: std::stable_sort.)
template <typename Work>
std::int64_t fail_everywhere(Work work) {
  work();
  std::int64_t allocations = 0;
  for (bool is_all = false; !is_all; ++allocations) {
    allowed = allocations;
    try {
      work();
      is_all = allowed >= 0;
    } catch (const std::bad_alloc&) {
    }
    allowed = kNever;
  }
  return allocations;
}

Case small_case(int threads) {
  Case settings = compressed_block(4.0, 8.0, 0.2);
  settings.materials["rock"].failure = rock_failure();
  settings.time.steps = 4;
  settings.tuning.threads = threads;
  return settings;
}

}  // namespace

TEST_CASE("a simulation that runs out of memory anywhere says so") {
  for (const int threads : {1, 2}) {
    const Case settings = small_case(threads);
    const std::int64_t allocations = fail_everywhere([&] {
      Simulation simulation(settings);
      simulation.run_until(4);
      simulation.history();
      trace_cracks(settings, simulation.particles());
    });
    INFO(allocations << " allocations");
    CHECK(allocations > 50);
  }
}

}  // namespace rgimp::tests
