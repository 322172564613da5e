#pragma once

#include <cfenv>

/// Traps: SIGFPE at the operation that makes a NaN out of numbers, an infinity out of finite ones,
/// or divides by zero. Traps belong to a thread; threads that it starts and oneTBB's workers take
/// them over, which a test of test_parallel holds.
namespace rgimp::tests {

inline constexpr int kFloatingPointTraps = FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW;

inline void trap_floating_point_errors() {
  feenableexcept(kFloatingPointTraps);
}

/// No traps on this thread while this lives, for tests that make NaNs on purpose. Workers made
/// meanwhile have none either.
class WithoutTraps {
 public:
  WithoutTraps() { std::feholdexcept(&before_); }
  ~WithoutTraps() { std::fesetenv(&before_); }
  WithoutTraps(const WithoutTraps&) = delete;
  WithoutTraps& operator=(const WithoutTraps&) = delete;

 private:
  std::fenv_t before_;
};

}  // namespace rgimp::tests
