#include <catch2/catch.hpp>
#include <filesystem>

#include "case_size.hpp"
#include "case_text.hpp"
#include "machine_memory.hpp"
#include "rgimp/rgimp.hpp"

namespace {

using rgimp::testing::kRightCase;
using rgimp::testing::kRightSolid;
using rgimp::testing::read_text;
using rgimp::testing::ScratchDirectory;

void check_estimate(const rgimp::Case& settings) {
  const rgimp::CaseSize size = rgimp::estimate_size(settings);
  const rgimp::Facts facts = rgimp::Simulation(settings).facts();
  CHECK(size.nodes == static_cast<double>(facts.nodes[0] * facts.nodes[1] * facts.nodes[2]));
  // Flaws and the rounding of a curved face to whole particles are left out.
  CHECK(size.particles / static_cast<double>(facts.particles) == Approx(1.0).epsilon(0.02));
  CHECK(size.state_bytes / static_cast<double>(facts.memory_bytes) == Approx(1.0).epsilon(0.05));
  CHECK(facts.peak_memory_bytes > facts.memory_bytes);
}

void write(const std::filesystem::path& file, const std::string& text) {
  std::filesystem::create_directories(file.parent_path());
  std::ofstream(file) << text;
}

}  // namespace

TEST_CASE("the size of a case is estimated from its shapes") {
  rgimp::Case plane = read_text(kRightCase);
  plane.flaws.clear();
  check_estimate(plane);
  plane.bodies[0].shape = rgimp::BodyShape::disk;
  plane.bodies[0].size.x() = 40e-3;
  plane.platens.clear();
  check_estimate(plane);

  rgimp::Case solid = read_text(kRightSolid);
  solid.flaws.clear();
  solid.platens.clear();
  check_estimate(solid);
  solid.bodies[0].size.x() = 24e-3;  // whole groups: the last bin begins one
  check_estimate(solid);
  solid.bodies[0].shape = rgimp::BodyShape::sphere;
  solid.bodies[0].size.x() = 40e-3;
  check_estimate(solid);
  solid.bodies[0].shape = rgimp::BodyShape::cylinder;
  for (const rgimp::Vector& axis : {rgimp::Vector(0, 1, 0), rgimp::Vector(1, 1, 1)}) {
    solid.bodies[0].axis = axis;
    solid.bodies[0].size = {30e-3, 40e-3, 0.0};
    check_estimate(solid);
  }
}

TEST_CASE("softening materials take a column more") {
  rgimp::Case settings = read_text(kRightSolid);
  const double before = rgimp::estimate_size(settings).state_bytes;
  rgimp::Failure& failure = settings.materials.at("rock").failure.emplace();
  failure.fracture_energy = 10.0;
  const rgimp::CaseSize size = rgimp::estimate_size(settings);
  CHECK(size.state_bytes - before == Approx(8.0 * size.lanes));
}

TEST_CASE("free memory is what the machine has, or what a control group leaves") {
  const ScratchDirectory scratch;
  const std::filesystem::path& root = scratch.path();
  CHECK_FALSE(rgimp::available_memory(root).has_value());
  write(root / "proc/meminfo", "MemTotal:  100 kB\nMemFree: 20 kB\nMemAvailable:   64 kB\n");
  CHECK(rgimp::available_memory(root) == 64.0 * 1024.0);

  // Version 2: the group around the process's own has the limit.
  write(root / "proc/self/cgroup", "1:cpu:/\n0::/outer/inner\n");
  CHECK(rgimp::available_memory(root) == 64.0 * 1024.0);
  write(root / "sys/fs/cgroup/outer/inner/memory.max", "max\n");
  CHECK(rgimp::available_memory(root) == 64.0 * 1024.0);
  write(root / "sys/fs/cgroup/outer/memory.max", "10000\n");
  CHECK(rgimp::available_memory(root) == 10000.0);
  write(root / "sys/fs/cgroup/outer/memory.stat", "file 7000\nanon 4000\n");
  CHECK(rgimp::available_memory(root) == 6000.0);

  // Version 1, from a container that sees its own group as the root.
  write(root / "proc/self/cgroup", "4:memory:/lost/from/here\n3:cpu:/\n");
  write(root / "sys/fs/cgroup/memory/memory.limit_in_bytes", "5000\n");
  write(root / "sys/fs/cgroup/memory/memory.stat", "total_rss 1000\n");
  CHECK(rgimp::available_memory(root) == 4000.0);
}

TEST_CASE("this machine says how much memory it has free") {
  CHECK(rgimp::available_memory().value() > 1e6);
}
