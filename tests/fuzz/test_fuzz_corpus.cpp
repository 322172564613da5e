#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "targets.hpp"

namespace {

namespace fs = std::filesystem;

/// In the order of their names, so that a failure is met again.
std::vector<fs::path> inputs_in(const fs::path& directory) {
  std::vector<fs::path> inputs(fs::directory_iterator{directory}, fs::directory_iterator{});
  std::sort(inputs.begin(), inputs.end());
  return inputs;
}

std::string bytes_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  REQUIRE(file);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

/// How many of a target's inputs were used.
int replay(const std::string& target, rgimp::fuzz::Outcome (*try_input)(std::string_view)) {
  const std::vector<fs::path> inputs = inputs_in(fs::path(RGIMP_FUZZ_CORPUS) / target);
  int used = 0;
  for (const fs::path& input : inputs) {
    INFO(input.string());
    try {
      used += try_input(bytes_of(input)) == rgimp::fuzz::Outcome::used ? 1 : 0;
    } catch (const std::exception& error) {
      FAIL_CHECK(error.what());
    }
  }
  return used;
}

}  // namespace

TEST_CASE("every case file of the corpus is refused or runs") {
  CHECK(replay("case", rgimp::fuzz::try_case) > 0);
}

TEST_CASE("every checkpoint of the corpus is refused or goes on") {
  CHECK(replay("checkpoint", rgimp::fuzz::try_checkpoint) > 0);
}

TEST_CASE("the fuzzer of checkpoints starts from some that can be used") {
  for (const std::int64_t steps : {0, 1, 60}) {
    CHECK(rgimp::fuzz::try_checkpoint(rgimp::fuzz::tiny_checkpoint(steps)) ==
          rgimp::fuzz::Outcome::used);
  }
}
