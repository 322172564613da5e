#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <type_traits>

namespace rgimp {

/// The threads of one simulation. Inside a region helpers stay awake and take the next index of
/// whatever for_each runs; a phase of a step is too short (tens of microseconds) to wake a
/// sleeping thread for it. for_each returns when all indices are done. The caller works too, and
/// waits only for indices already taken, so more threads than cores cannot deadlock it.
class Workers {
 public:
  /// 0 threads: all that the machine has.
  explicit Workers(int threads);
  ~Workers();

  int threads() const;

  /// Runs `body` on the calling thread while the helpers are awake for its for_each calls.
  void region(const std::function<void()>& body);

  /// visit(index) for 0 <= index < count < 2^24, each once, on any thread; outside a region all on
  /// the caller. Throws what a visit threw, that of the lowest index where several did; the other
  /// indices may or may not have been visited.
  template <typename Visit>
  void for_each(std::ptrdiff_t count, Visit&& visit) {
    run({[](void* context, std::ptrdiff_t index) {
           (*static_cast<std::remove_reference_t<Visit>*>(context))(index);
         },
         const_cast<void*>(static_cast<const void*>(&visit))},
        count);
  }

 private:
  struct Phase {
    void (*call)(void* context, std::ptrdiff_t index);
    void* context;
  };
  class Arena;
  struct HelperTask;

  void run(Phase phase, std::ptrdiff_t count);
  bool take_one();
  void visit(std::ptrdiff_t index);
  void help();

  static constexpr std::size_t kCacheLine = 64;  // bytes

  std::unique_ptr<Arena> arena_;
  // What every ticket touches shares one line, whatever the object lies beside.
  alignas(kCacheLine) Phase phase_{};
  // Tickets of the running phase: phase number, count and next index in one word, so that a late
  // helper can never take an index of a phase it has not seen.
  std::atomic<std::uint64_t> tickets_{0};
  std::atomic<std::ptrdiff_t> done_{0};
  std::atomic<bool> open_{false};
  alignas(kCacheLine) std::mutex error_mutex_;
  std::exception_ptr error_;  // of the running phase
  std::ptrdiff_t error_index_ = 0;
};

}  // namespace rgimp
