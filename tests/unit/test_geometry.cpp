#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "case_text.hpp"
#include "geometry.hpp"
#include "platen_geometry.hpp"
#include "rgimp/rgimp.hpp"
#include "shapes.hpp"

namespace {

using rgimp::testing::kExamples;

/// A 20 mm x 10 mm block of cells of 1 mm, away from the origin.
rgimp::Case block() {
  rgimp::Case settings;
  settings.grid.cell_size = 1e-3;
  settings.materials["rock"] = {2600.0, 17e9, 0.14, std::nullopt};
  rgimp::Body body;
  body.center = {0.1, -0.2, 0.0};
  body.size = {20e-3, 10e-3, 0.0};
  body.material = "rock";
  body.velocity = {1.0, 2.0, 0.0};
  settings.bodies.push_back(body);
  settings.time.steps = 1;
  return settings;
}

rgimp::Flaw slot(double length, double width, double angle, rgimp::SlotEnds ends) {
  rgimp::Flaw flaw;
  flaw.center = {0.1, -0.2, 0.0};
  flaw.length = length;
  flaw.width = width;
  flaw.angle = angle;
  flaw.ends = ends;
  return flaw;
}

double total_volume(const std::vector<rgimp::ParticleSeed>& seeds) {
  double volume = 0.0;
  for (const rgimp::ParticleSeed& seed : seeds) {
    volume += seed.volume;
  }
  return volume;
}

}  // namespace

TEST_CASE("the paper's examples have their particles") {
  const auto count = [](const char* name) {
    return rgimp::seed_particles(rgimp::read_case(kExamples / name)).size();
  };
  CHECK(count("single_flaw.toml") == 79618);
  CHECK(count("double_flaw.toml") == 79488);
  CHECK(count("brazilian_disk.toml") == 19852);
}

TEST_CASE("particles sit at the centres of their parts of a cell") {
  const auto seeds = rgimp::seed_particles(block());
  REQUIRE(seeds.size() == 40 * 20);
  CHECK(seeds[0].position.x() == Approx(0.09 + 0.25e-3).epsilon(1e-12));
  CHECK(seeds[0].position.y() == Approx(-0.205 + 0.25e-3).epsilon(1e-12));
  CHECK(seeds[0].position.z() == 0.0);
  CHECK(seeds[1].position.x() == Approx(0.09 + 0.75e-3).epsilon(1e-12));  // x runs fastest
  CHECK(seeds[40].position.y() == Approx(-0.205 + 0.75e-3).epsilon(1e-12));
  CHECK(seeds.back().position.x() == Approx(0.11 - 0.25e-3).epsilon(1e-12));
  CHECK(seeds.back().position.y() == Approx(-0.195 - 0.25e-3).epsilon(1e-12));
  CHECK(seeds[7].volume == Approx(0.25e-6));
  CHECK(seeds[7].mass == Approx(2600.0 * 0.25e-6));
  CHECK(seeds[7].velocity == rgimp::Vector(1.0, 2.0, 0.0));
  CHECK(total_volume(seeds) == Approx(20e-3 * 10e-3).epsilon(1e-12));
}

TEST_CASE("all threads together find the particles that one finds") {
  rgimp::Case plane = block();
  plane.grid.cell_size = 0.1e-3;  // several parts
  plane.flaws.push_back(slot(5e-3, 0.4e-3, 30.0, rgimp::SlotEnds::round));
  plane.bodies.push_back(plane.bodies[0]);
  plane.bodies[1].center.x() += 20e-3;
  rgimp::Case solid = rgimp::read_case(kExamples / "brazilian_cylinder.toml");
  solid.grid.cell_size = 1e-3;
  for (const rgimp::Case& settings : {plane, solid}) {
    const auto expected = rgimp::seed_particles(settings);
    rgimp::Workers workers(3);
    std::vector<rgimp::ParticleSeed> seeds;
    workers.region([&] {
      const rgimp::SeedParts parts = rgimp::seed_particles(settings, workers);
      REQUIRE(parts.size() > settings.bodies.size());
      for (const auto& part : parts) {
        seeds.insert(seeds.end(), part.begin(), part.end());
      }
    });
    REQUIRE(seeds.size() == expected.size());
    for (std::size_t i = 0; i < seeds.size(); ++i) {
      REQUIRE(seeds[i].position == expected[i].position);
      REQUIRE(seeds[i].velocity == expected[i].velocity);
      REQUIRE(seeds[i].volume == expected[i].volume);
      REQUIRE(seeds[i].mass == expected[i].mass);
      REQUIRE(seeds[i].material == expected[i].material);
    }
  }
}

TEST_CASE("round-off in the sizes changes no count") {
  for (int cells = 1; cells <= 300; ++cells) {
    for (const double cell : {0.1, 0.7e-3, 1.0 / 3.0, 1e-5}) {
      rgimp::Case settings = block();
      settings.grid.cell_size = cell;
      settings.bodies[0].particles_per_cell = 3;
      settings.bodies[0].size = {cells * cell, cell, 0.0};
      settings.bodies[0].center = {17.3 * cell, 0.1 * cell, 0.0};
      const rgimp::Lattice lattice(settings, settings.bodies[0]);
      REQUIRE(lattice.columns() == 3 * cells);
      REQUIRE(lattice.rows() == 3);
    }
  }
}

TEST_CASE("every particle is inside its body and outside the flaws") {
  const rgimp::Case disk = rgimp::read_case(kExamples / "brazilian_disk.toml");
  std::size_t mirrored = 0;
  for (const rgimp::ParticleSeed& seed : rgimp::seed_particles(disk)) {
    REQUIRE(seed.position.norm() <= 20e-3);
    REQUIRE((std::abs(seed.position.x()) > 0.5e-3 ||
             std::abs(std::abs(seed.position.y()) - 7e-3) > 4e-3));
    mirrored += seed.position.x() > 0.0 ? 1 : 0;
  }
  CHECK(mirrored == 19852 / 2);
}

TEST_CASE("flaws take out the area they cover") {
  const double whole = 20e-3 * 10e-3;
  const auto left_out = [&](const rgimp::Flaw& flaw) {
    rgimp::Case settings = block();
    settings.grid.cell_size = 0.1e-3;
    settings.flaws = {flaw};
    return whole - total_volume(rgimp::seed_particles(settings));
  };
  const double length = 6e-3;
  const double width = 2e-3;
  const double round_loss = (1.0 - std::numbers::pi / 4.0) * width * width;
  for (const double angle : {0.0, 30.0, 90.0, 135.0}) {
    CHECK(left_out(slot(length, width, angle, rgimp::SlotEnds::square)) ==
          Approx(length * width).epsilon(0.005));
    CHECK(left_out(slot(length, width, angle, rgimp::SlotEnds::round)) ==
          Approx(length * width - round_loss).epsilon(0.005));
  }
  rgimp::Flaw circle = slot(4e-3, 0.0, 0.0, rgimp::SlotEnds::square);
  circle.shape = rgimp::FlawShape::circle;
  CHECK(left_out(circle) == Approx(std::numbers::pi * 4e-6).epsilon(0.005));
  rgimp::Flaw box = circle;
  box.shape = rgimp::FlawShape::box;
  box.size = {3e-3, 1e-3, 0.0};
  CHECK(left_out(box) == Approx(3e-6).epsilon(1e-9));
}

TEST_CASE("an angle turns a slot counterclockwise, and its tips are its length apart") {
  const rgimp::Flaw square = slot(10e-3, 2e-3, 30.0, rgimp::SlotEnds::square);
  const rgimp::Flaw round = slot(10e-3, 2e-3, 30.0, rgimp::SlotEnds::round);
  const double angle = std::numbers::pi / 6.0;
  const rgimp::Vector along(std::cos(angle), std::sin(angle), 0.0);
  const rgimp::Vector across(-along.y(), along.x(), 0.0);
  for (const rgimp::Flaw& flaw : {square, round}) {
    CHECK(rgimp::contains(flaw, flaw.center + 4.99e-3 * along, 0.0));
    CHECK_FALSE(rgimp::contains(flaw, flaw.center + 5.01e-3 * along, 0.0));
    CHECK(rgimp::contains(flaw, flaw.center - 0.99e-3 * across, 0.0));
    CHECK_FALSE(rgimp::contains(flaw, flaw.center - 1.01e-3 * across, 0.0));
  }
  const rgimp::Vector corner = square.center + 4.9e-3 * along + 0.9e-3 * across;
  CHECK(rgimp::contains(square, corner, 0.0));
  CHECK_FALSE(rgimp::contains(round, corner, 0.0));

  // The corners of the square end, and the far sides of the round one.
  const rgimp::Box box = rgimp::bounds(square);
  CHECK(box.max.x() - square.center.x() == Approx(5e-3 * along.x() + 1e-3 * along.y()));
  CHECK(box.max.y() - square.center.y() == Approx(5e-3 * along.y() + 1e-3 * along.x()));
  CHECK(rgimp::bounds(round).max.x() - round.center.x() == Approx(4e-3 * along.x() + 1e-3));
}

TEST_CASE("an edge belongs to the body and not to the flaw") {
  rgimp::Body body = block().bodies[0];
  const rgimp::Vector on_edge = body.center + rgimp::Vector(10e-3, 0.0, 0.0);
  CHECK(rgimp::contains(body, on_edge, 1e-12));
  rgimp::Flaw box;
  box.shape = rgimp::FlawShape::box;
  box.center = body.center;
  box.size = body.size;
  CHECK_FALSE(rgimp::contains(box, on_edge, 1e-12));
  body.shape = rgimp::BodyShape::disk;
  CHECK(rgimp::contains(body, on_edge, 1e-12));
  CHECK_FALSE(rgimp::contains(body, body.center + rgimp::Vector(8e-3, 8e-3, 0.0), 1e-12));
}

TEST_CASE("bounds are those of all bodies together") {
  rgimp::Case settings = block();
  rgimp::Body disk = settings.bodies[0];
  disk.shape = rgimp::BodyShape::disk;
  disk.size = {4e-3, 0.0, 0.0};
  disk.center = {0.13, -0.19, 0.0};
  settings.bodies.push_back(disk);
  const rgimp::Box box = rgimp::bounds(settings);
  CHECK(box.min.x() == Approx(0.09));
  CHECK(box.min.y() == Approx(-0.205));
  CHECK(box.max.x() == Approx(0.132));
  CHECK(box.max.y() == Approx(-0.188));
}

TEST_CASE("the grid reaches eight cells before the bodies along x, else five, unless told") {
  rgimp::Case settings = block();
  const rgimp::GridExtent automatic = rgimp::grid_extent(settings);
  CHECK(automatic.nodes == std::array<std::int64_t, 3>{34, 21, 1});
  CHECK(automatic.spacing == rgimp::Vector::Constant(1e-3));
  CHECK(automatic.origin.x() == Approx(0.082));
  CHECK(automatic.origin.y() == Approx(-0.21));

  settings.grid.min = rgimp::Vector(0.05, -0.25, 0.0);
  settings.grid.max = rgimp::Vector(0.1201, -0.19, 0.0);
  const rgimp::GridExtent given = rgimp::grid_extent(settings);
  CHECK(given.origin == *settings.grid.min);
  CHECK(given.nodes == std::array<std::int64_t, 3>{72, 61, 1});  // x rounded up to whole cells
}

TEST_CASE("materials are numbered in the order of their names") {
  rgimp::Case settings = block();
  settings.materials["clay"] = {2000.0, 1e9, 0.3, std::nullopt};
  rgimp::Body clay = settings.bodies[0];
  clay.material = "clay";
  clay.center.x() += 20e-3;
  settings.bodies.push_back(clay);
  const auto seeds = rgimp::seed_particles(settings);
  CHECK(seeds.front().material == 1);
  CHECK(seeds.back().material == 0);
  CHECK(seeds.back().mass == Approx(2000.0 * 0.25e-6));
}

TEST_CASE("a platen touches the end on its side, within its half width and no farther") {
  const rgimp::Box specimen{{-1.0, -2.0, 0.0}, {3.0, 6.0, 0.0}};
  const rgimp::PlatenContact top({.side = rgimp::Side::top, .half_width = 0.5}, specimen);
  CHECK(top.end == 6.0);
  CHECK(top.opposite == -2.0);
  CHECK(top.side.towards == -1.0);
  CHECK(top.center == 1.0);
  CHECK(top.holds(0.5));
  CHECK(top.holds(1.5 + 1e-10));  // round-off on the contact's edge
  CHECK_FALSE(top.holds(1.5 + 1e-8));

  const rgimp::PlatenContact left({.side = rgimp::Side::left}, specimen);
  CHECK(left.end == -1.0);
  CHECK(left.opposite == 3.0);
  CHECK(left.side.towards == 1.0);
  CHECK(left.across == 1);
  CHECK(left.center == 2.0);
  CHECK(left.holds(100.0));
}
