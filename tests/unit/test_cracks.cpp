#include <catch2/catch.hpp>

#include "models.hpp"
#include "rgimp/error.hpp"
#include "synthetic_cracks.hpp"

namespace rgimp::tests {

TEST_CASE("nothing failed: every tip is listed, none has a crack") {
  const Case settings = block_with({flat_slot(0.0, 5e-3), flat_slot(0.0, -5e-3)});
  const Cracks cracks = trace_cracks(settings, intact(settings));
  REQUIRE(cracks.wings.size() == 4);
  const std::vector<std::string> names{"A", "B", "C", "D"};
  for (std::size_t w = 0; w < 4; ++w) {
    CHECK(cracks.wings[w].name == names[w]);
    CHECK(cracks.wings[w].particles.empty());
  }
  CHECK(cracks.wings[0].tip.isApprox(Vector(3e-3, 5e-3, 0.0)));
  CHECK(cracks.wings[1].tip.isApprox(Vector(-3e-3, 5e-3, 0.0)));
  CHECK(cracks.wings[3].flaw == 1);
  CHECK(cracks.events.empty());
  CHECK(cracks.outline + cracks.elsewhere == 0);
}

TEST_CASE("a straight crack has its direction, length and history") {
  const Case settings = block_with({flat_slot(0.0, 0.0)});
  const double degrees = GENERATE(90.0, 70.0, 45.0, 20.0, -60.0, 110.0);
  ParticleTable table = intact(settings);
  const Vector from(2.9e-3, degrees > 0.0 ? 0.6e-3 : -0.6e-3, 0.0);
  add({from, degrees, 6e-3, 100}, table);
  const Cracks cracks = trace_cracks(settings, table);
  INFO(degrees << " degrees");
  const Wing& wing = cracks.wings[0];
  REQUIRE(wing.particles.size() == static_cast<std::size_t>(failed_count(table)));
  CHECK((wing.particles.front().position - from).norm() < 0.3e-3);
  CHECK(wing.particles.front().step == Approx(100).margin(30));
  CHECK(*wing_angle(wing, 2e-3) == Approx(degrees).margin(5.0));
  CHECK(*wing_angle(wing, 5e-3) == Approx(degrees).margin(2.0));
  CHECK_FALSE(wing_angle(wing, 8e-3));
  const double from_load = std::abs(90.0 - std::abs(degrees));
  CHECK(*angle_to_load(cracks, degrees) == Approx(from_load));
  const std::vector<CrackFront> front = trace_front(wing);
  CHECK(front.back().length == Approx(6e-3).margin(0.4e-3));
  for (const CrackFront& at : front) {
    CHECK(at.length == Approx(static_cast<double>(at.step - 100) * 1e-5).margin(0.4e-3));
  }
  REQUIRE(cracks.events.size() == 1);
  CHECK(describe(cracks.events[0]) == "first failure at A");
}

TEST_CASE("a state in between follows from the one at the end") {
  const Case settings = block_with({flat_slot(0.0, 0.0)});
  ParticleTable table = intact(settings);
  add({{2.9e-3, 0.6e-3, 0.0}, 75.0, 12e-3, 100}, table);
  const std::vector<CrackFront> all = trace_front(trace_cracks(settings, table).wings[0]);
  for (std::size_t i = 0; i < table.size(); ++i) {
    if (table.failure_step[i] > 600) {
      table.failed[i] = FailureMode::intact;
      table.failure_step[i] = -1;
    }
  }
  const std::vector<CrackFront> part = trace_front(trace_cracks(settings, table).wings[0]);
  REQUIRE(part.size() > 10);
  REQUIRE(part.size() < all.size());
  for (std::size_t i = 0; i < part.size(); ++i) {
    CHECK(part[i].step == all[i].step);
    CHECK(part[i].position == all[i].position);
  }
  CHECK(part.back().step <= 600);
}

TEST_CASE("cracks of two flaws meet at the step of the particle between them, not before") {
  // A and C are the right tips, of the lower and of the upper slot.
  const Case settings = block_with({flat_slot(0.0, -5e-3), flat_slot(0.0, 5e-3)});
  ParticleTable table = intact(settings);
  add({{2.9e-3, -4.4e-3, 0.0}, 90.0, 4e-3, 100}, table);
  add({{2.9e-3, 4.4e-3, 0.0}, -90.0, 4e-3, 200}, table);
  const Cracks apart = trace_cracks(settings, table);
  CHECK(apart.events.size() == 2);
  add({{2.9e-3, -0.5e-3, 0.0}, 90.0, 1e-3, 900}, table);
  const Cracks cracks = trace_cracks(settings, table);
  REQUIRE(cracks.events.size() == 3);
  CHECK(describe(cracks.events[0]) == "first failure at A");
  CHECK(describe(cracks.events[1]) == "first failure at C");
  CHECK(describe(cracks.events[2]) == "A and C meet");
  CHECK(cracks.events[2].step == Approx(985).margin(30));
  CHECK((cracks.events[2].position - Vector(2.9e-3, 0.0, 0.0)).norm() < 0.7e-3);
  CHECK(cracks.wings[0].particles.size() + cracks.wings[2].particles.size() ==
        static_cast<std::size_t>(failed_count(table)));
}

TEST_CASE("a crack that runs into the other flaw meets it there") {
  const Case settings = block_with({flat_slot(0.0, -5e-3), flat_slot(0.0, 5e-3)});
  ParticleTable table = intact(settings);
  add({{2.9e-3, -4.4e-3, 0.0}, 90.0, 9e-3, 100}, table);
  const Cracks cracks = trace_cracks(settings, table);
  REQUIRE(cracks.events.size() == 2);
  CHECK(describe(cracks.events[1]) == "A and C meet");
  CHECK(cracks.events[1].step == Approx(100 + 840).margin(60));
}

TEST_CASE("an island ahead of a crack belongs to it once it is connected") {
  const Case settings = block_with({flat_slot(0.0, 0.0)});
  ParticleTable table = intact(settings);
  add({{2.9e-3, 0.6e-3, 0.0}, 90.0, 2e-3, 500}, table);
  add({{2.9e-3, 4e-3, 0.0}, 90.0, 2e-3, 100}, table);
  const auto island = trace_cracks(settings, table).elsewhere;
  CHECK(island > 6);
  add({{2.9e-3, 2.5e-3, 0.0}, 90.0, 1.6e-3, 900}, table);
  const Cracks cracks = trace_cracks(settings, table);
  CHECK(cracks.elsewhere == 0);
  CHECK(cracks.wings[0].particles.front().step == Approx(500).margin(30));
  CHECK(cracks.wings[0].particles.back().step == Approx(1050).margin(30));
}

TEST_CASE("what fails along a slot's faces or away from flaws is no crack") {
  const Case settings = block_with({flat_slot(0.0, 0.0)});
  ParticleTable table = intact(settings);
  add({{-2.9e-3, 0.625e-3, 0.0}, 0.0, 5.8e-3, 100}, table);  // within a cell of the upper face
  add({{-2.9e-3, 0.875e-3, 0.0}, 0.0, 5.8e-3, 200}, table);  // the second row, still within
  const auto outline = static_cast<std::size_t>(failed_count(table));
  add({{-10e-3, 19.875e-3, 0.0}, 0.0, 3e-3, 300}, table);  // a corner at the platen
  const Cracks cracks = trace_cracks(settings, table);
  CHECK(outline > 40);
  CHECK(cracks.outline == outline);
  CHECK(cracks.elsewhere == static_cast<std::size_t>(failed_count(table)) - outline);
  CHECK(cracks.events.empty());
}

TEST_CASE("a step of an oblique face that sticks out of the layer is no crack") {
  const Case settings = block_with({flat_slot(0.0, 0.0)});
  ParticleTable table = intact(settings);
  add({{0.1e-3, 0.6e-3, 0.0}, 90.0, 0.7e-3, 100}, table);  // to 0.8 mm, 1.6 cells, from the face
  const Cracks cracks = trace_cracks(settings, table);
  CHECK(cracks.outline == static_cast<std::size_t>(failed_count(table)));
  CHECK(cracks.events.empty());
}

TEST_CASE("an outlined face does not join the wings of its tips") {
  const Case settings = block_with({flat_slot(0.0, 0.0)});
  ParticleTable table = intact(settings);
  add({{-2.9e-3, 0.625e-3, 0.0}, 0.0, 5.8e-3, 100}, table);
  add({{2.9e-3, 0.625e-3, 0.0}, 90.0, 5e-3, 200}, table);
  add({{-2.9e-3, 0.625e-3, 0.0}, 90.0, 5e-3, 200}, table);
  const Cracks cracks = trace_cracks(settings, table);
  CHECK(cracks.outline > 10);
  CHECK(cracks.wings[0].particles.size() == cracks.wings[1].particles.size());
  CHECK(cracks.events.size() == 2);
}

TEST_CASE("a second crack from a tip is told apart, and both reach their sides") {
  const Case settings = block_with({flat_slot(0.0, 0.0)});
  ParticleTable table = intact(settings);
  add({{2.875e-3, 0.6e-3, 0.0}, 90.0, 30e-3, 100}, table);
  add({{2.875e-3, -0.6e-3, 0.0}, -90.0, 30e-3, 150}, table);
  const Cracks cracks = trace_cracks(settings, table);
  REQUIRE(cracks.wings.size() == 3);
  CHECK(cracks.wings[1].name == "A2");
  REQUIRE(cracks.events.size() == 4);
  CHECK(describe(cracks.events[2]) == "A reaches the top side");
  CHECK(describe(cracks.events[3]) == "A2 reaches the bottom side");
  CHECK(cracks.events[2].position.y() == Approx(20e-3 - 0.625e-3));
}

TEST_CASE("cracks at a hole are named after the direction in which they start") {
  const Case settings = block_with({{.shape = FlawShape::circle, .length = 6e-3}});
  ParticleTable table = intact(settings);
  add({{0.0, 3e-3, 0.0}, 90.0, 5e-3, 100}, table);
  const Cracks cracks = trace_cracks(settings, table);
  REQUIRE(cracks.wings.size() == 1);
  CHECK(cracks.wings[0].name == "flaw[0] 90 deg");
  CHECK(*wing_angle(cracks.wings[0], 2e-3) == Approx(90.0).margin(5.0));
}

TEST_CASE("a crack is measured where its particles were, however far it opens") {
  const Case settings = block_with({flat_slot(0.0, 0.0)});
  ParticleTable table = intact(settings);
  add({{2.9e-3, 0.6e-3, 0.0}, 75.0, 12e-3, 100}, table);
  const std::size_t length = trace_front(trace_cracks(settings, table).wings[0]).size();
  for (auto& position : table.position) {
    position[0] *= position[0] > 0.0 ? 3.0 : 1.0;
  }
  CHECK(trace_front(trace_cracks(settings, table).wings[0]).size() == length);
}

TEST_CASE("particles of another case are refused") {
  const Case settings = block_with({flat_slot(0.0, 0.0)});
  CHECK_THROWS_AS(trace_cracks(settings, intact(block_with({}))), CaseError);
  ParticleTable table = intact(settings);
  table.id[3] = 4000000000u;
  CHECK_THROWS_AS(trace_cracks(settings, table), CaseError);
}

TEST_CASE("particles may be missing where the case takes out what leaves the grid") {
  Case settings = block_with({flat_slot(0.0, 0.0)});
  ParticleTable table = intact(settings);
  table.id.erase(table.id.begin());
  table.failed.erase(table.failed.begin());
  table.failure_step.erase(table.failure_step.begin());
  CHECK_THROWS_AS(trace_cracks(settings, table), CaseError);
  settings.grid.on_exit = OnExit::remove;
  CHECK_NOTHROW(trace_cracks(settings, table));
}

TEST_CASE("the wings of a simulated block start at both tips and grow alike") {
  Simulation simulation(cracking_block());
  simulation.run_until(1000);
  const ParticleTable table = simulation.particles();
  const Cracks cracks = trace_cracks(simulation.settings(), table);
  REQUIRE(cracks.wings.size() >= 2);
  const Wing& upper = cracks.wings[0];
  const Wing& lower = cracks.wings[1];
  REQUIRE(upper.name == "A");
  REQUIRE(lower.name == "B");
  CHECK(cracks.events[0].step == simulation.first_failure()->step);
  std::size_t failed = cracks.outline + cracks.elsewhere;
  for (const Wing& wing : cracks.wings) {
    failed += wing.particles.size();
  }
  CHECK(failed == static_cast<std::size_t>(failed_count(table)));
  CHECK(upper.particles.front().position.isApprox(-lower.particles.front().position, 1e-9));
  CHECK(trace_front(upper).back().length == Approx(trace_front(lower).back().length).epsilon(0.02));
  // Wings leave a 45 degree slot towards the load.
  for (const Wing* wing : {&upper, &lower}) {
    CHECK(*angle_to_load(cracks, *wing_angle(*wing, 2e-3)) < 30.0);
  }
}

}  // namespace rgimp::tests
