#include <algorithm>
#include <atomic>
#include <catch2/catch.hpp>
#include <filesystem>
#include <future>
#include <locale>
#include <map>
#include <string>

#include "models.hpp"
#include "rgimp/rgimp.hpp"
#include "temporary_directory.hpp"

// Several simulations in one process do not disturb each other, nor does what else the process
// does.
namespace rgimp::tests {
namespace {

namespace fs = std::filesystem;

constexpr std::int64_t kSteps = 600;

Case first_case() {
  Case settings = cracking_block();
  settings.time.steps = kSteps;
  settings.output.history_every = 50;
  settings.output.snapshot_every = 100;
  settings.tuning.threads = 2;
  return settings;
}

Case second_case() {
  Case settings = first_case();
  settings.flaws.front().angle = 60.0;
  settings.time.integrator = Integrator::usl;
  settings.tuning.threads = 3;
  return settings;
}

/// So fast that the time step is soon past the critical one.
Case bursting_case() {
  Case settings = first_case();
  settings.platens.front().speed = -1e5;
  return settings;
}

std::uint64_t hash_after(Simulation simulation, std::int64_t steps) {
  simulation.run_until(steps);
  return simulation.state_hash();
}

std::uint64_t hash_of(const Case& settings) {
  return hash_after(Simulation(settings), kSteps);
}

template <typename Expected>
bool throws(const Case& settings) {
  try {
    hash_of(settings);
  } catch (const Expected&) {
    return true;
  }
  return false;
}

/// The files of a run, without the times in its summary.
std::map<std::string, std::string> files_of(const fs::path& directory) {
  std::map<std::string, std::string> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(directory)) {
    if (entry.is_regular_file() && entry.path().filename() != "summary.json") {
      files[fs::relative(entry.path(), directory).string()] = read_text(entry.path());
    }
  }
  return files;
}

fs::path cracks_file(const fs::path& directory) {
  return directory.string() + ".json";
}

void trace(const fs::path& directory) {
  write_cracks(cracks_file(directory), trace_cracks(directory));
}

std::string cracks_of(const fs::path& directory) {
  trace(directory);
  return read_text(cracks_file(directory));
}

void run(const Case& settings, const fs::path& directory) {
  Simulation simulation(settings);
  RunOptions options;
  options.directory = directory;
  run_case(simulation, options);
}

/// Numbers as 1.234,5: what an application may choose for its own texts.
class CommaNumbers : public std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

class GlobalLocale {
 public:
  explicit GlobalLocale(const std::locale& locale) : before_(std::locale::global(locale)) {}
  ~GlobalLocale() { std::locale::global(before_); }
  GlobalLocale(const GlobalLocale&) = delete;
  GlobalLocale& operator=(const GlobalLocale&) = delete;

 private:
  std::locale before_;
};

}  // namespace

TEST_CASE("a case built twice in one process gives the same bits") {
  REQUIRE(hash_of(first_case()) == hash_of(first_case()));
}

TEST_CASE("two simulations step on two threads to the bits that they have alone") {
  const std::uint64_t first = hash_of(first_case());
  const std::uint64_t second = hash_of(second_case());
  REQUIRE(first != second);
  auto other = std::async(std::launch::async, [] { return hash_of(second_case()); });
  CHECK(hash_of(first_case()) == first);
  CHECK(other.get() == second);
}

TEST_CASE("two simulations step in turn on one thread to the bits that they have alone") {
  Simulation first(first_case());
  Simulation second(second_case());
  for (std::int64_t step = 0; step <= kSteps; step += 60) {
    first.run_until(step);
    second.run_until(step);
  }
  CHECK(first.state_hash() == hash_of(first_case()));
  CHECK(second.state_hash() == hash_of(second_case()));
}

TEST_CASE("a simulation goes from thread to thread, and others come and go, without a trace") {
  const std::uint64_t expected = hash_of(first_case());
  std::atomic<bool> done{false};
  auto others = std::async(std::launch::async, [&] {  // Catch's checks are for one thread
    while (!done) {
      Simulation(second_case()).run_until(3);
      if (!throws<CaseError>(Case{}) || !throws<PhysicsError>(bursting_case())) {
        return false;
      }
    }
    return true;
  });
  Simulation simulation(first_case());
  simulation.run_until(kSteps / 3);
  std::async(std::launch::async, [&] { simulation.run_until(kSteps / 2); }).get();
  Simulation moved = std::move(simulation);
  simulation = Simulation(second_case());
  simulation = std::move(moved);
  const auto hash = hash_after(std::move(simulation), kSteps);
  CHECK(hash == expected);
  done = true;
  CHECK(others.get());
}

TEST_CASE("runs write and read, side by side, the files that they write alone") {
  const TemporaryDirectory place;
  run(first_case(), place / "alone" / "first");
  run(second_case(), place / "alone" / "second");
  const auto run_both = [&](const Case& settings, const std::string& name) {
    run(settings, place / "together" / name);
    trace(place / "together" / name);
  };
  fs::create_directory(place / "together");
  auto other = std::async(std::launch::async, [&] { return run_both(second_case(), "second"); });
  run_both(first_case(), "first");
  other.get();
  for (const std::string name : {"first", "second"}) {
    CHECK(read_text(cracks_file(place / "together" / name)) == cracks_of(place / "alone" / name));
    const auto files = files_of(place / "together" / name);
    CHECK(files.size() >= 10);
    CHECK((files == files_of(place / "alone" / name)));  // no binary output
  }
}

TEST_CASE("a locale of the application changes nothing that is written or read") {
  const TemporaryDirectory place;
  run(first_case(), place / "plain");
  const std::string cracks = cracks_of(place / "plain");
  const GlobalLocale commas(std::locale(std::locale(), new CommaNumbers));
  run(read_case(place / "plain" / "case.toml"), place / "commas");
  CHECK((files_of(place / "commas") == files_of(place / "plain")));
  CHECK(cracks_of(place / "commas") == cracks);
  CHECK_THROWS_WITH(read_case(place / "plain" / "case.toml", std::array<std::string, 1>{"a=1"}),
                    Catch::Contains("a: unknown key"));
}

TEST_CASE("errors are of the type that says who can help") {
  const TemporaryDirectory place;
  write_text(place / "wrong.toml", "dimension = 2\n");
  CHECK_THROWS_AS(read_case(place / "wrong.toml"), CaseError);
  CHECK_THROWS_AS(read_case(place / "missing.toml"), FileError);
  CHECK_THROWS_AS(trace_cracks(place / "missing"), CaseError);
  CHECK_THROWS_AS(hash_of(bursting_case()), PhysicsError);
  CHECK_THROWS_AS(run(bursting_case(), place / "burst"), PhysicsError);
  write_text(place / "file", "");
  CHECK_THROWS_AS(run(first_case(), place / "file" / "below"), FileError);
  CHECK_THROWS_AS(trace_cracks(place / "file" / "below"), CaseError);
  CHECK_THROWS_AS(trace_cracks(place / std::string(300, 'x')), CaseError);
}

TEST_CASE("the version that a program is compiled with is that of the library") {
  CHECK(version() == std::to_string(RGIMP_VERSION_MAJOR) + "." +
                         std::to_string(RGIMP_VERSION_MINOR) + "." +
                         std::to_string(RGIMP_VERSION_PATCH));
}

}  // namespace rgimp::tests
