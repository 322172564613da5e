#include "workers.hpp"

#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>
#include <oneapi/tbb/task_arena.h>
#include <oneapi/tbb/task_group.h>

#include <thread>
#include <utility>

#if defined(__x86_64__)
#include <immintrin.h>
#endif

// The one file that knows oneTBB.
namespace rgimp {
namespace {

constexpr int kIndexBits = 24;
constexpr std::uint64_t kIndexMask = (std::uint64_t{1} << kIndexBits) - 1;
constexpr int kSpinsBeforeYield = 2000;

std::uint64_t next_of(std::uint64_t tickets) {
  return tickets & kIndexMask;
}
std::uint64_t count_of(std::uint64_t tickets) {
  return (tickets >> kIndexBits) & kIndexMask;
}
std::uint64_t phase_of(std::uint64_t tickets) {
  return tickets >> (2 * kIndexBits);
}

/// The arithmetic of a step while this lives, on its thread, whatever the application's is (on one
/// of its threads only, the number of threads would change bits). Results are rounded to nearest.
/// Numbers below 1e-308 count as zero: ahead of a wave fields fade through such numbers, and a step
/// of USL there took 2.5 times as long.
class StepArithmetic {
 public:
#if defined(__x86_64__)
  StepArithmetic() {
    _mm_setcsr((before_ & ~kRounding) | kFlushResults | kFlushOperands);
  }
  ~StepArithmetic() {
    _mm_setcsr(before_);
  }
  StepArithmetic(const StepArithmetic&) = delete;
  StepArithmetic& operator=(const StepArithmetic&) = delete;

 private:
  static constexpr unsigned kRounding = 0x6000;
  static constexpr unsigned kFlushResults = 0x8000;
  static constexpr unsigned kFlushOperands = 0x0040;
  unsigned before_ = _mm_getcsr();
#endif
};

/// Waits a moment: a pause first, the rest of the time slice when it takes long.
class Backoff {
 public:
  void wait() {
    if (++spins_ < kSpinsBeforeYield) {
#if defined(__x86_64__)
      _mm_pause();
#endif
    } else {
      std::this_thread::yield();
    }
  }
  void reset() {
    spins_ = 0;
  }

 private:
  int spins_ = 0;
};

}  // namespace

class Workers::Arena {
 public:
  explicit Arena(int threads)
      : threads_(threads > 0 ? threads : tbb::info::default_concurrency()), arena_(threads_) {
    if (threads_ > tbb::info::default_concurrency()) {
      oversubscribe_ = std::make_unique<tbb::global_control>(
          tbb::global_control::max_allowed_parallelism, threads_);
    }
  }

  int threads() const { return threads_; }
  tbb::task_arena& arena() { return arena_; }

 private:
  int threads_;
  std::unique_ptr<tbb::global_control> oversubscribe_;
  tbb::task_arena arena_;
};

/// A task of its own name. Debian's oneTBB is not built for ThreadSanitizer, which cannot see that
/// the task is whole before another thread reads it; tests/tsan.supp lets this one read pass. What
/// the task runs is checked: its own atomics order it.
struct Workers::HelperTask {
  [[gnu::noinline]] void operator()() const { workers->help(); }
  Workers* workers;
};

Workers::Workers(int threads) : arena_(std::make_unique<Arena>(threads)) {}
Workers::~Workers() = default;

int Workers::threads() const {
  return arena_->threads();
}

void Workers::region(const std::function<void()>& body) {
  const StepArithmetic arithmetic;
  if (threads() == 1) {
    body();
    return;
  }
  // The caller may be moved to a thread of the arena.
  arena_->arena().execute([&] {
    const StepArithmetic arithmetic_here;
    open_.store(true, std::memory_order_release);
    tbb::task_group helpers;
    // Helpers must have left before an exception goes on.
    try {
      for (int t = 1; t < threads(); ++t) {
        helpers.run(HelperTask{this});
      }
      body();
    } catch (...) {
      open_.store(false, std::memory_order_release);
      helpers.wait();
      throw;
    }
    open_.store(false, std::memory_order_release);
    helpers.wait();
  });
}

void Workers::run(Phase phase, std::ptrdiff_t count) {
  if (!open_.load(std::memory_order_relaxed)) {
    for (std::ptrdiff_t index = 0; index < count; ++index) {
      phase.call(phase.context, index);
    }
    return;
  }
  phase_ = phase;
  done_.store(0, std::memory_order_relaxed);
  const std::uint64_t number = phase_of(tickets_.load(std::memory_order_relaxed)) + 1;
  tickets_.store((number << (2 * kIndexBits)) | (static_cast<std::uint64_t>(count) << kIndexBits),
                 std::memory_order_release);
  while (take_one()) {
  }
  Backoff backoff;
  while (done_.load(std::memory_order_acquire) != count) {
    backoff.wait();
  }
  if (error_) {
    std::rethrow_exception(std::exchange(error_, nullptr));
  }
}

bool Workers::take_one() {
  const std::uint64_t seen = tickets_.load(std::memory_order_relaxed);
  if (next_of(seen) >= count_of(seen)) {
    return false;
  }
  const std::uint64_t ticket = tickets_.fetch_add(1, std::memory_order_acq_rel);
  if (next_of(ticket) >= count_of(ticket)) {
    return false;
  }
  // The phase cannot end, so phase_ cannot change, before this index is counted as done.
  visit(static_cast<std::ptrdiff_t>(next_of(ticket)));
  done_.fetch_add(1, std::memory_order_release);
  return true;
}

void Workers::visit(std::ptrdiff_t index) {
  try {
    phase_.call(phase_.context, index);
  } catch (...) {
    const std::lock_guard<std::mutex> alone(error_mutex_);
    if (!error_ || index < error_index_) {
      error_ = std::current_exception();
      error_index_ = index;
    }
  }
}

void Workers::help() {
  const StepArithmetic arithmetic;
  Backoff backoff;
  while (open_.load(std::memory_order_acquire)) {
    if (take_one()) {
      backoff.reset();
    } else {
      backoff.wait();
    }
  }
}

}  // namespace rgimp
