#include <catch2/catch.hpp>
#include <filesystem>

#include "rgimp/case_file.hpp"
#include "rgimp/error.hpp"
#include "snapshot.hpp"
#include "synthetic_cracks.hpp"
#include "temporary_directory.hpp"

namespace rgimp::tests {
namespace {

/// An output directory with one crack, of steps 100 to 1,000, and snapshots of steps 0 and 2,000.
class Output {
 public:
  Output() : settings_(block_with({flat_slot(0.0, 0.0)})), table_(intact(settings_)) {
    write_text(place_ / "case.toml", write_case(settings_));
    std::filesystem::create_directory(place_ / "snapshots");
    write(0, table_);
    add({{2.9e-3, 0.6e-3, 0.0}, 90.0, 9e-3, 100}, table_);
    write(2000, table_);
  }

  void write(std::int64_t step, const ParticleTable& table) const {
    write_snapshot(snapshot(step), table, {step, 0.0});
  }
  std::filesystem::path snapshot(std::int64_t step) const {
    return place_ / "snapshots" / snapshot_name(step);
  }
  const std::filesystem::path& path() const { return place_.path(); }
  const ParticleTable& table() const { return table_; }

 private:
  TemporaryDirectory place_;
  Case settings_;
  ParticleTable table_;
};

}  // namespace

TEST_CASE("cracks of an output directory are those of its last snapshot, at any step before") {
  const Output output;
  CHECK(trace_front(trace_cracks(output.path()).wings[0]).back().step == Approx(990).margin(20));
  CHECK(trace_front(trace_cracks(output.path(), 500).wings[0]).back().step ==
        Approx(490).margin(20));
  CHECK(trace_cracks(output.path(), 0).events.empty());
  CHECK_THROWS_AS(trace_cracks(output.path(), 2001), CaseError);
  write_cracks(output.path() / "cracks.json", trace_cracks(output.path()));
  CHECK_THAT(::read_text(output.path() / "cracks.json"),
             Catch::Contains("first failure at A") && Catch::Contains("\"length_m\""));
}

TEST_CASE("a directory without results is named") {
  const TemporaryDirectory empty;
  CHECK_THROWS_AS(trace_cracks(empty.path()), CaseError);
  const Output output;
  std::filesystem::remove_all(output.path() / "snapshots");
  CHECK_THROWS_AS(trace_cracks(output.path()), FileError);
}

TEST_CASE("a damaged snapshot is refused before it is used") {
  const Output output;
  ParticleTable table = output.table();
  const auto refused = [&](const std::string& reason) {
    output.write(3000, table);
    CHECK_THROWS_WITH(trace_cracks(output.path()),
                      Catch::Contains("step_000003000.vtkhdf") && Catch::Contains(reason));
  };
  SECTION("an id twice") {
    table.id[7] = table.id[8];
    refused("is not there once");
  }
  SECTION("an id past the end") {
    table.id[7] = 4000000000u;
    refused("is not there once");
  }
  SECTION("an unknown mode") {
    table.failed[7] = static_cast<FailureMode>(9);
    refused("unknown failure mode 9");
  }
  SECTION("a failure without its step") {
    table.failed[7] = FailureMode::shear;
    table.failure_step[7] = -1;
    refused("do not agree");
  }
  SECTION("particles of another case") {
    table = intact(block_with({}));
    refused("'VTKHDF/PointData/id' is not the");
  }
  SECTION("a column too short") {
    table.stress.pop_back();
    refused("'VTKHDF/PointData/stress' is not the");
  }
}

TEST_CASE("a snapshot that is cut off, or none at all, is refused") {
  const Output output;
  const std::string whole = ::read_text(output.snapshot(2000));
  for (const std::size_t size : {std::size_t{0}, std::size_t{100}, whole.size() / 2}) {
    write_text(output.snapshot(3000), whole.substr(0, size));
    CHECK_THROWS_AS(trace_cracks(output.path()), FileError);
  }
}

}  // namespace rgimp::tests
