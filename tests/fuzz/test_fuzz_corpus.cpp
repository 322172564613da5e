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

void replay(const std::string& target, void (*try_input)(std::string_view)) {
  const std::vector<fs::path> inputs = inputs_in(fs::path(RGIMP_FUZZ_CORPUS) / target);
  REQUIRE_FALSE(inputs.empty());
  for (const fs::path& input : inputs) {
    INFO(input.string());
    CHECK_NOTHROW(try_input(bytes_of(input)));
  }
}

}  // namespace

TEST_CASE("every case file of the corpus is refused or runs") {
  replay("case", rgimp::fuzz::try_case);
}
