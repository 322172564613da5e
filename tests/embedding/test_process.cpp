#include <hdf5.h>
#include <sys/stat.h>

#include <catch2/catch.hpp>
#include <cfenv>
#include <clocale>
#include <csignal>
#include <filesystem>
#include <locale>

#if defined(__x86_64__)
#include <immintrin.h>
#endif

#include "models.hpp"
#include "rgimp/rgimp.hpp"
#include "temporary_directory.hpp"

// The library leaves the process as it finds it, whatever it does and however it ends.
namespace rgimp::tests {
namespace {

Case short_case() {
  Case settings = cracking_block();
  settings.time.steps = 300;
  settings.output.snapshot_every = 100;
  settings.tuning.threads = 2;
  return settings;
}

void run(Case settings, const std::filesystem::path& directory) {
  Simulation simulation(std::move(settings));
  RunOptions options;
  options.directory = directory;
  run_case(simulation, options);
}

mode_t file_mask() {
  const mode_t mask = umask(0);
  umask(mask);
  return mask;
}

void (*handler_of(int signal))(int) {
  struct sigaction action {};
  sigaction(signal, nullptr, &action);
  return action.sa_handler;
}

void (*hdf5_printer())() {
  H5E_auto2_t printer = nullptr;
  void* data = nullptr;
  H5Eget_auto2(H5E_DEFAULT, &printer, &data);
  return reinterpret_cast<void (*)()>(printer);
}

/// What a process has one of.
struct Process {
  std::filesystem::path directory = std::filesystem::current_path();
  std::string locale = std::setlocale(LC_ALL, nullptr);
  std::string stream_locale = std::locale().name();
  mode_t mask = file_mask();
  int rounding = std::fegetround();
  void (*interrupted)(int) = handler_of(SIGINT);
  void (*terminated)(int) = handler_of(SIGTERM);
  void (*too_large)(int) = handler_of(SIGXFSZ);
  void (*arithmetic)(int) = handler_of(SIGFPE);
  void (*printer)() = hdf5_printer();
#if defined(__x86_64__)
  unsigned control = _mm_getcsr() & ~0x3fU;  // without the flags of what has happened
#endif
  bool operator==(const Process&) const = default;
};

class Rounding {
 public:
  explicit Rounding(int mode) : before_(std::fegetround()) { std::fesetround(mode); }
  ~Rounding() { std::fesetround(before_); }
  Rounding(const Rounding&) = delete;
  Rounding& operator=(const Rounding&) = delete;

 private:
  int before_;
};

std::uint64_t hash_after(Simulation& simulation, std::int64_t step) {
  simulation.run_until(step);
  return simulation.state_hash();
}

}  // namespace

TEST_CASE("the process is after runs and errors what it was before") {
  const TemporaryDirectory place;
  const Process before;
  run(short_case(), place / "run");
  trace_cracks(place / "run");
  CHECK((Process() == before));
  Case bursting = short_case();
  bursting.platens.front().speed = -1e5;
  CHECK_THROWS_AS(run(bursting, place / "burst"), PhysicsError);
  CHECK((Process() == before));
  write_text(place / "run" / "snapshots" / "step_000000300.vtkhdf", "damaged");
  CHECK_THROWS_AS(trace_cracks(place / "run"), FileError);
  CHECK((Process() == before));
}

TEST_CASE("how the application rounds changes no bit of a step, on any number of threads") {
  for (const int threads : {1, 2}) {
    Case settings = short_case();
    settings.tuning.threads = threads;
    Simulation expected(settings);
    Simulation found(settings);
    const std::uint64_t hash = hash_after(expected, 300);
    const Rounding upward(FE_UPWARD);
    CHECK(hash_after(found, 300) == hash);
    CHECK(std::fegetround() == FE_UPWARD);
  }
}

#if defined(__x86_64__)
// As -ffast-math in any other library does to the whole process.
TEST_CASE("an application that flushes tiny numbers to zero changes no bit") {
  Simulation expected(short_case());
  const std::uint64_t hash = hash_after(expected, 300);
  const unsigned before = _mm_getcsr();
  _mm_setcsr(before | 0x8040U);
  Simulation found(short_case());
  const std::uint64_t flushed = hash_after(found, 300);
  _mm_setcsr(before);
  CHECK(flushed == hash);
}
#endif

}  // namespace rgimp::tests
