#include <catch2/catch.hpp>

#include "crack_geometry.hpp"
#include "rgimp/case_file.hpp"
#include "rgimp/crack_clusters.hpp"
#include "rgimp/cracks.hpp"
#include "rgimp/error.hpp"
#include "rgimp/results.hpp"
#include "snapshot.hpp"
#include "synthetic_cracks.hpp"
#include "temporary_directory.hpp"

namespace rgimp::tests {
namespace {

constexpr double kCell = 0.5e-3;  // m; particles every half of it

/// 10 mm x 20 mm x 10 mm between platens.
Case block_in_space(std::vector<Flaw> flaws) {
  Case settings = block_with(std::move(flaws));
  settings.dimension = 3;
  settings.bodies.front().size = {10e-3, 20e-3, 10e-3};
  return settings;
}

Flaw penny_at_45() {
  return {
      .shape = FlawShape::penny, .length = 5e-3, .width = 1.5e-3, .normal = Vector(-1.0, 1.0, 0.0)};
}

Flaw hole(double y) {
  return {.shape = FlawShape::sphere, .center = {0.0, y, 0.0}, .length = 2e-3};
}

/// Fails, at a step that follows from its place, what lies where `chosen` says.
template <typename Chosen, typename StepOf>
std::size_t fail(ParticleTable& table, Chosen chosen, StepOf step_of) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < table.size(); ++i) {
    const Vector place(table.position[i].data());
    if (table.failed[i] == FailureMode::intact && chosen(place)) {
      table.failed[i] = FailureMode::tension;
      table.failure_step[i] = static_cast<std::int32_t>(step_of(place));
      ++count;
    }
  }
  return count;
}

/// Up from the penny's upper rim and down from the lower one: sheets one cell thick, 2 mm wide,
/// that rise 1 mm in 100 steps.
std::size_t fail_wings(ParticleTable& table, double height) {
  return fail(
      table,
      [&](const Vector& at) {
        const double side = at.y() > 0.0 ? 1.0 : -1.0;
        return std::abs(at.x() * side - 1.75e-3) < 0.25e-3 && std::abs(at.z()) < 1e-3 &&
               at.y() * side > 1.5e-3 && at.y() * side < height;
      },
      [](const Vector& at) { return 100 + std::llround(std::abs(at.y()) * 1e5); });
}

}  // namespace

TEST_CASE("wings of a penny are two cracks, though its rim has failed all around") {
  const Case settings = block_in_space({penny_at_45()});
  ParticleTable table = intact(settings);
  const std::size_t rim = fail(
      table, [&](const Vector& at) { return distance_to(settings.flaws[0], at) < 0.9 * kCell; },
      [](const Vector&) { return 50; });
  const std::size_t wings = fail_wings(table, 6e-3);
  const CrackClusters cracks = trace_clusters(settings, table);
  REQUIRE(cracks.clusters.size() == 2);
  CHECK(cracks.first->step == 50);
  CHECK(cracks.first->flaw == 0U);
  CHECK(cracks.outline >= rim);
  CHECK(cracks.elsewhere == 0);
  std::size_t counted = cracks.outline;
  for (const CrackCluster& crack : cracks.clusters) {
    counted += crack.particles.size();
    CHECK(crack.flaws == std::vector<std::size_t>{0});
    const ClusterExtent end = trace_extent(cracks, crack).back();
    CHECK(end.failed == crack.particles.size());
    CHECK(std::abs(end.farthest.y()) == Approx(6e-3).margin(0.2e-3));
    CHECK(end.distance == Approx(distance_to(settings.flaws[0], end.farthest)));
    CHECK(end.max.z() - end.min.z() == Approx(2e-3).margin(0.3e-3));
    // A row of particles, 0.5 mm2, may miss: the lower edge runs along the flaw, at 45 degrees.
    CHECK(end.area == Approx(2e-3 * (end.max.y() - end.min.y() + 0.25e-3)).margin(0.5e-6));
  }
  CHECK(counted == rim + wings);
  CHECK(describe(cracks.events[0]) == "crack 1 starts");
  CHECK(describe(cracks.events[1]) == "crack 2 starts");
}

TEST_CASE("a cluster's extent follows its growth") {
  const Case settings = block_in_space({penny_at_45()});
  ParticleTable table = intact(settings);
  fail_wings(table, 8e-3);
  const CrackClusters cracks = trace_clusters(settings, table);
  const std::vector<ClusterExtent> extents = trace_extent(cracks, cracks.clusters[0]);
  REQUIRE(extents.size() > 10);
  for (std::size_t e = 1; e < extents.size(); ++e) {
    CHECK(extents[e].distance >= extents[e - 1].distance);
    CHECK(extents[e].step >= extents[e - 1].step);
    CHECK(extents[e].area > extents[e - 1].area);
    CHECK(extents[e].step == Approx(100.0 + 1e5 * std::abs(extents[e].farthest.y())).margin(26.0));
  }
}

TEST_CASE("a crack that runs straight out reaches the side there") {
  const Case settings = block_in_space({hole(0.0)});
  const auto [way, side] = GENERATE(std::pair(Vector(Vector::UnitX()), Side::right),
                                    std::pair(Vector(-Vector::UnitX()), Side::left),
                                    std::pair(Vector(Vector::UnitY()), Side::top),
                                    std::pair(Vector(-Vector::UnitY()), Side::bottom),
                                    std::pair(Vector(Vector::UnitZ()), Side::front),
                                    std::pair(Vector(-Vector::UnitZ()), Side::back));
  ParticleTable table = intact(settings);
  const Vector along = way;
  fail(
      table,
      [&](const Vector& at) {
        return at.dot(along) > 1e-3 && (at - at.dot(along) * along).cwiseAbs().maxCoeff() < 0.5e-3;
      },
      [&](const Vector& at) { return std::llround(at.dot(along) * 1e5); });
  const CrackClusters cracks = trace_clusters(settings, table);
  REQUIRE(cracks.clusters.size() == 1);
  REQUIRE(cracks.events.size() == 2);
  CHECK(cracks.events[1].side == side);
  const double edge = settings.bodies[0].size.cwiseProduct(along).norm() / 2;
  CHECK(cracks.events[1].position.dot(along) == Approx(edge - kCell).margin(0.3e-3));
}

TEST_CASE("a crack between two holes belongs to both, at their middle to none") {
  const Case settings = block_in_space({hole(4e-3), hole(-4e-3)});
  ParticleTable table = intact(settings);
  const auto column = [](double from, double to) {
    return [from, to](const Vector& at) {
      return std::abs(at.x()) < 0.3e-3 && std::abs(at.z()) < 0.3e-3 && at.y() > from && at.y() < to;
    };
  };
  const auto step = [](const Vector& at) { return std::llround(100.0 + at.y() * 1e4); };
  const std::size_t island = fail(table, column(-1.2e-3, -0.4e-3), step);
  CHECK(trace_clusters(settings, table).elsewhere == island);
  CHECK(trace_clusters(settings, table).clusters.empty());
  fail(table, column(-1.2e-3, 1.2e-3), step);
  const CrackClusters middle = trace_clusters(settings, table);
  REQUIRE(middle.clusters.size() == 1);
  CHECK(middle.clusters[0].flaws.empty());
  CHECK(trace_extent(middle, middle.clusters[0]).back().distance == Approx(2.4e-3).margin(0.5e-3));
  fail(table, column(-3e-3, 3e-3), step);
  const CrackClusters cracks = trace_clusters(settings, table);
  REQUIRE(cracks.clusters.size() == 1);
  CHECK(cracks.clusters[0].flaws == std::vector<std::size_t>{0, 1});
  CHECK(cracks.elsewhere == 0);
}

TEST_CASE("each kind of measuring refuses the other's dimension, and no failure is no crack") {
  const Case space = block_in_space({penny_at_45()});
  const CrackClusters none = trace_clusters(space, intact(space));
  CHECK_FALSE(none.first);
  CHECK(none.clusters.empty());
  CHECK(none.events.empty());
  CHECK_THROWS_WITH(trace_cracks(space, intact(space)), Catch::Contains("trace_clusters"));
  const Case plane = block_with({flat_slot(0.0, 0.0)});
  CHECK_THROWS_WITH(trace_clusters(plane, intact(plane)), Catch::Contains("trace_cracks"));
}

TEST_CASE("clusters of an output directory, at its end or before, and as JSON") {
  const Case settings = block_in_space({penny_at_45()});
  const TemporaryDirectory place;
  write_text(place / "case.toml", write_case(settings));
  std::filesystem::create_directory(place / "snapshots");
  ParticleTable table = intact(settings);
  fail_wings(table, 8e-3);
  write_snapshot(place / "snapshots" / snapshot_name(2000), table, {2000, 0.0});
  const auto farthest = [&](std::optional<std::int64_t> until) {
    const Results results = read_results(place.path(), until);
    const CrackClusters cracks = trace_clusters(results.settings, results.particles);
    return std::abs(trace_extent(cracks, cracks.clusters[0]).back().farthest.y());
  };
  CHECK(farthest(std::nullopt) == Approx(8e-3).margin(0.2e-3));
  CHECK(farthest(600) == Approx(5e-3).margin(0.2e-3));
  CHECK_THROWS_AS(read_results(place.path(), 2001), CaseError);
  CHECK_THROWS_AS(trace_cracks(place.path()), CaseError);
  write_clusters(place / "cracks.json", trace_clusters(settings, table));
  CHECK_THAT(::read_text(place / "cracks.json"),
             Catch::Contains("\"crack 1 starts\"") && Catch::Contains("\"area_m2\""));
}

TEST_CASE("distances from flaws in space") {
  const Vector up(0.0, 1e-3, 0.0);
  CHECK(distance_to(hole(0.0), 3.0 * up) == Approx(2e-3));
  const Flaw penny{
      .shape = FlawShape::penny, .length = 4e-3, .width = 1e-3, .normal = Vector(0.0, 3.0, 0.0)};
  CHECK(distance_to(penny, 2.0 * up) == Approx(1.5e-3));
  CHECK(distance_to(penny, Vector(3e-3, 0.0, 4e-3)) == Approx(3e-3));
  CHECK(distance_to(penny, Vector(5e-3, 4.5e-3, 0.0)) == Approx(5e-3));
  CHECK(distance_to(penny, Vector(0.0, 0.4e-3, 0.0)) == Approx(-0.1e-3));
  Flaw slot{.length = 4e-3,
            .width = 2e-3,
            .direction = Vector(0.0, 0.0, 1.0),
            .normal = Vector(2.0, 0.0, 0.0)};
  CHECK(distance_to(slot, Vector(4e-3, 9.0, 6e-3)) == Approx(5e-3));  // through along y
  slot.depth = 2e-3;
  CHECK(distance_to(slot, Vector(0.0, 4e-3, 6e-3)) == Approx(5e-3));
  slot.ends = SlotEnds::round;
  CHECK(distance_to(slot, Vector(4e-3, 0.0, 4e-3)) == Approx(4e-3));
  const Flaw box{.shape = FlawShape::box, .size = Vector(2e-3, 2e-3, 4e-3)};
  CHECK(distance_to(box, Vector(0.0, 4e-3, 6e-3)) == Approx(5e-3));
}

TEST_CASE("sides of round bodies in space") {
  Case settings = block_in_space({});
  settings.bodies[0] = {.shape = BodyShape::cylinder,
                        .size = Vector(20e-3, 10e-3, 0.0),
                        .axis = Vector(0.0, 0.0, 2.0),
                        .material = "rock"};
  const auto side = [&](double x, double y, double z) {
    return side_within(settings, {x, y, z}, kCell);
  };
  CHECK(side(0.0, 9.8e-3, 0.0) == Side::top);
  CHECK(side(-9.8e-3, 0.0, 0.0) == Side::left);
  CHECK(side(6e-3, -7.8e-3, 0.0) == Side::bottom);
  CHECK(side(0.0, 0.0, 4.8e-3) == Side::front);
  CHECK(side(0.0, 0.0, -4.8e-3) == Side::back);
  CHECK_FALSE(side(0.0, 9e-3, 0.0));
  settings.bodies[0] = {
      .shape = BodyShape::sphere, .size = Vector(20e-3, 0.0, 0.0), .material = "rock"};
  CHECK(side(0.0, 0.0, -9.8e-3) == Side::back);
  CHECK(side(7e-3, 5e-3, 4.7e-3) == Side::right);
  CHECK_FALSE(side(5e-3, 5e-3, 5e-3));
}

}  // namespace rgimp::tests
