#include <unistd.h>

#include <cstring>
#include <filesystem>
#include <memory>
#include <sstream>
#include <string>

#include "checkpoint_file.hpp"
#include "checksum.hpp"
#include "input_file.hpp"
#include "models.hpp"
#include "rgimp/error.hpp"
#include "targets.hpp"

namespace rgimp::fuzz {
namespace {

/// Some 24 particles on the smallest grid around them; they soften within the first steps, so that
/// every kind of column is there.
Case tiny_case() {
  Case settings = tests::compressed_block(1.0, 1.5, -2.0);
  settings.grid.min = Vector(-2e-3, -2.25e-3, 0.0);
  settings.grid.max = Vector(2e-3, 2.25e-3, 0.0);
  Failure failure = tests::rock_failure();
  failure.fracture_energy = 0.5;
  failure.shear_fracture_energy = 20.0;
  settings.materials["rock"].failure = failure;
  settings.local_damping = 0.1;
  return settings;
}

std::string with_right_checksum(std::string_view bytes) {
  std::string text(bytes);
  if (text.size() >= sizeof(std::uint64_t)) {
    const std::size_t place = text.size() - sizeof(std::uint64_t);
    const std::uint64_t checksum = checksum_of(std::string_view(text).substr(0, place));
    std::memcpy(text.data() + place, &checksum, sizeof checksum);
  }
  return text;
}

}  // namespace

Outcome try_checkpoint(std::string_view bytes) {
  tests::Model model(tiny_case());
  try {
    model.solver.restore(
        CheckpointReader("fuzz", std::make_unique<std::istringstream>(with_right_checksum(bytes))));
  } catch (const FileError&) {
    return Outcome::refused;
  }
  try {
    model.steps(2);
    model.solver.history();
  } catch (const PhysicsError&) {  // numbers that no run would have left there
  }
  return Outcome::used;
}

std::string tiny_checkpoint(std::int64_t steps) {
  tests::Model model(tiny_case());
  model.steps(steps);
  const std::filesystem::path path =
      std::filesystem::temp_directory_path() / ("rgimp_fuzz_" + std::to_string(getpid()));
  CheckpointWriter checkpoint(path, steps);
  model.solver.save(checkpoint);
  checkpoint.finish({"the case", "the note"});
  std::string bytes = read_bytes(path);
  std::filesystem::remove(path);
  return bytes;
}

}  // namespace rgimp::fuzz
