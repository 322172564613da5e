#include <algorithm>
#include <catch2/catch.hpp>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <vector>

#include "floating_point_traps.hpp"
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
  const rgimp::tests::WithoutTraps numbers_at_the_edge;
  REQUIRE_FALSE(inputs.empty());
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

// Found by the fuzzer: the next step looked for the first failure among particles all intact.
TEST_CASE("a checkpoint that counts failures without a first one is refused") {
  std::string bytes = rgimp::fuzz::tiny_checkpoint(0);
  std::uint64_t length = 0;
  std::memcpy(&length, bytes.data() + bytes.size() - 16, sizeof length);
  const auto index = nlohmann::json::parse(bytes.substr(bytes.size() - 16 - length, length));
  std::size_t place = 32;  // after the head
  for (const auto& column : index.at("columns")) {
    if (column.at("name") == "failed in tension") {
      break;
    }
    const std::string type = column.at("type");
    const std::size_t size = type == "uint8" ? 1 : type.ends_with("32") ? 4 : 8;
    place += size * column.at("length").get<std::size_t>();
  }
  REQUIRE(bytes.at(place) == 0);
  bytes[place] = 1;
  CHECK(rgimp::fuzz::try_checkpoint(bytes) == rgimp::fuzz::Outcome::refused);
}

// Those of an older format are refused, so that these need not be used.
TEST_CASE("every checkpoint of the corpus is refused or goes on") {
  replay("checkpoint", rgimp::fuzz::try_checkpoint);
}

TEST_CASE("checkpoints are used as they are, and refused or used with any byte changed") {
  const rgimp::tests::WithoutTraps numbers_at_the_edge;
  std::minstd_rand random(6);
  for (const std::int64_t steps : {0, 1, 60}) {
    const std::string whole = rgimp::fuzz::tiny_checkpoint(steps);
    CHECK(rgimp::fuzz::try_checkpoint(whole) == rgimp::fuzz::Outcome::used);
    for (int i = 0; i < 500; ++i) {
      std::string changed = whole;
      changed[random() % changed.size()] = static_cast<char>(random());
      CHECK_NOTHROW(rgimp::fuzz::try_checkpoint(changed));
    }
  }
}
