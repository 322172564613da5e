#pragma once

#include <unistd.h>

#include <atomic>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "rgimp/case_file.hpp"

/// A small case file that is right, and ways to put a text on disk.
namespace rgimp::testing {

inline const std::filesystem::path kExamples = RGIMP_EXAMPLES;

/// Line numbers in the tests count from "title".
inline const std::string kRightCase = R"(title = "small"
dimension = 2
[grid]
cell_size = 0.5e-3
[[body]]
shape = "box"
center = [0.0, 0.0]
size = [20e-3, 40e-3]
material = "rock"
[[flaw]]
shape = "slot"
center = [0.0, 0.0]
length = 6e-3
width = 1.5e-3
angle = 45.0
[material.rock]
density = 2600.0
youngs_modulus = 17e9
poisson_ratio = 0.14
[material.rock.failure]
criterion = "mohr-coulomb"
cohesion = 5.95e6
friction_angle = 40.0
tensile_strength = 2e6
[[platen]]
side = "top"
speed = 0.005
[[platen]]
side = "bottom"
speed = 0.005
[time]
steps = 1000
)";

/// The same in three dimensions.
inline const std::string kRightSolid = R"(title = "solid"
dimension = 3
[grid]
cell_size = 1e-3
[[body]]
shape = "box"
center = [0.0, 0.0, 0.0]
size = [20e-3, 40e-3, 20e-3]
material = "rock"
[[flaw]]
shape = "slot"
center = [0.0, 0.0, 0.0]
length = 8e-3
width = 3e-3
depth = 10e-3
direction = [1.0, 1.0, 0.0]
normal = [-1.0, 1.0, 0.0]
[[flaw]]
shape = "penny"
center = [0.0, 10e-3, 0.0]
length = 8e-3
width = 3e-3
normal = [0.0, 1.0, 1.0]
[material.rock]
density = 2600.0
youngs_modulus = 17e9
poisson_ratio = 0.14
[[platen]]
side = "top"
speed = 0.005
[[platen]]
side = "front"
speed = 0.0
half_width = 5e-3
[time]
steps = 100
)";

/// A directory of its own for one test, removed with everything in it.
class ScratchDirectory {
 public:
  ScratchDirectory() {
    static std::atomic<int> count{0};
    path_ = std::filesystem::temp_directory_path() /
            ("rgimp_test_" + std::to_string(::getpid()) + "_" + std::to_string(count++));
    std::filesystem::create_directories(path_);
  }
  ~ScratchDirectory() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  ScratchDirectory(const ScratchDirectory&) = delete;
  ScratchDirectory& operator=(const ScratchDirectory&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path write(const std::string& text,
                              const std::string& name = "case.toml") const {
    std::ofstream(path_ / name, std::ios::binary) << text;
    return path_ / name;
  }

 private:
  std::filesystem::path path_;
};

inline Case read_text(const std::string& text, const std::vector<std::string>& overrides = {}) {
  const ScratchDirectory scratch;
  return read_case(scratch.write(text), overrides);
}

/// A right case with its first `from` replaced.
inline std::string with(const std::string& from, const std::string& to,
                        std::string text = kRightCase) {
  const std::size_t place = text.find(from);
  return place == std::string::npos ? "test asks for text that is not there: " + from
                                    : text.replace(place, from.size(), to);
}

}  // namespace rgimp::testing
