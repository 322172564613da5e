#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "atomic_file.hpp"
#include "history_file.hpp"
#include "output_schedule.hpp"
#include "rgimp/error.hpp"
#include "rgimp/version.hpp"
#include "summary.hpp"
#include "temporary_directory.hpp"

namespace {

using namespace rgimp;

std::vector<std::string> split(const std::string& text, char separator) {
  std::istringstream stream(text);
  std::vector<std::string> parts;
  for (std::string part; std::getline(stream, part, separator);) {
    parts.push_back(part);
  }
  return parts;
}

/// All steps of a run that `stops` names, walked as a run walks them.
std::vector<std::int64_t> stops(const OutputSchedule& schedule, std::int64_t total) {
  std::vector<std::int64_t> steps;
  for (std::int64_t step = 0; step < total;) {
    step = schedule.next_stop(step);
    steps.push_back(step);
  }
  return steps;
}

}  // namespace

TEST_CASE("the history's columns and their order are those that programs rely on") {
  CHECK(kHistoryHeader ==
        "step,time_s,closure_m,axial_stress_Pa,reaction_N,kinetic_energy_J,strain_energy_J,"
        "external_work_J,damping_work_J,viscous_work_J,released_energy_J,failed_tension,"
        "failed_shear");
}

TEST_CASE("a row of the history holds its values in the header's order") {
  const HistoryRow row{7, 1.5, 2.5, 3.5, 4.5, 5.5, 6.5, 7.5, 8.5, 9.5, 10.5, 11, 12, 13.5};
  CHECK(format_history_row(row) == "7,1.5,2.5,3.5,4.5,5.5,6.5,7.5,8.5,9.5,10.5,11,12");
  CHECK(split(format_history_row(row), ',').size() ==
        split(std::string(kHistoryHeader), ',').size());
}

TEST_CASE("numbers of the history read back to the same bits") {
  HistoryRow row;
  row.time = 1.0 / 3.0;
  row.closure = 5e-324;
  row.axial_stress = -1.7976931348623157e308;
  row.reaction = 0.1;
  const std::vector<std::string> parts = split(format_history_row(row), ',');
  CHECK(std::stod(parts[1]) == row.time);
  CHECK(std::strtod(parts[2].c_str(), nullptr) == row.closure);
  CHECK(std::stod(parts[3]) == row.axial_stress);
  CHECK(parts[4] == "0.1");
}

TEST_CASE("rows of the history are on disk at once") {
  const TemporaryDirectory directory;
  HistoryFile history(directory / "history.csv");
  history.append(HistoryRow{});
  const std::string text = read_text(directory / "history.csv");
  CHECK(text == std::string(kHistoryHeader) + "\n0,0,0,0,0,0,0,0,0,0,0,0,0\n");
}

TEST_CASE("a history that cannot be written is an error") {
  const TemporaryDirectory directory;
  CHECK_THROWS_AS(HistoryFile(directory / "missing" / "history.csv"), FileError);
}

TEST_CASE("first and last step are always written") {
  OutputSettings settings;
  settings.history_every = 100;
  const OutputSchedule schedule(settings, 250);
  CHECK(stops(schedule, 250) == std::vector<std::int64_t>{100, 200, 250});
  for (const std::int64_t step : {0, 250}) {
    CHECK(schedule.writes_history(step));
    CHECK(schedule.writes_snapshot(step));
  }
  CHECK(schedule.writes_history(100));
  CHECK_FALSE(schedule.writes_snapshot(100));
  CHECK_FALSE(schedule.writes_history(101));
}

TEST_CASE("snapshots follow both their pace and their list") {
  OutputSettings settings;
  settings.history_every = 1000;
  settings.snapshot_every = 40;
  settings.snapshot_steps = {75, 10, 75, 5001};  // in any order, twice, and past the end
  const OutputSchedule schedule(settings, 100);
  CHECK(stops(schedule, 100) == std::vector<std::int64_t>{10, 40, 75, 80, 100});
  CHECK(schedule.writes_snapshot(75));
  CHECK(schedule.writes_snapshot(80));
  CHECK_FALSE(schedule.writes_history(75));
  CHECK_FALSE(schedule.writes_snapshot(76));
  CHECK_FALSE(schedule.writes_snapshot(5001));
}

TEST_CASE("chunks of steps grow to the pace wanted and shrink again") {
  ChunkSize chunk(0.2);
  CHECK(chunk.steps() == 1);
  chunk.learn(1, 0.001);
  CHECK(chunk.steps() == 10);  // tenfold at most
  chunk.learn(10, 0.01);
  CHECK(chunk.steps() == 100);
  chunk.learn(100, 0.1);
  CHECK(chunk.steps() == 200);
  chunk.learn(200, 2.0);
  CHECK(chunk.steps() == 20);
  chunk.learn(20, 600.0);
  CHECK(chunk.steps() == 1);
  chunk.learn(1, 0.0);
  CHECK(chunk.steps() == 10);
}

TEST_CASE("the energy error is what the books miss over the largest work") {
  const HistoryRow rest;
  HistoryRow row;
  row.external_work = 10.0;
  row.kinetic_energy = 1.0;
  row.strain_energy = 2.0;
  row.damping_work = 3.0;
  row.viscous_work = 1.5;
  row.released_energy = 1.5;
  CHECK(energy_error(rest, row, 20.0) == Approx(0.05));
  row.kinetic_energy = 3.0;
  CHECK(energy_error(rest, row, 20.0) == Approx(-0.05));
}

TEST_CASE("energy a specimen starts with is no error") {
  HistoryRow start;
  start.kinetic_energy = 8.0;
  CHECK(energy_error(start, start, 0.0) == 0.0);
  HistoryRow end;
  end.kinetic_energy = 5.0;
  end.strain_energy = 1.0;
  CHECK(energy_error(start, end, 0.0) == Approx(0.25));
  CHECK(energy_error(start, end, 1e-18) == Approx(0.25));  // what round-off works is no scale
  CHECK(energy_error(start, end, 20.0) == Approx(0.1));
  end.external_work = -2.0;
  CHECK(energy_error(start, end, 2.0) == Approx(0.0).margin(1e-15));
  CHECK(energy_error(HistoryRow{}, end, 0.0) == 0.0);
}

TEST_CASE("the summary's keys and their order are those that programs rely on") {
  Summary summary;
  summary.particles = 4;
  summary.steps = 9;
  summary.dt = 1e-8;
  summary.isa = "avx2";
  summary.state_hash = 0xfedcba9876543210U;
  summary.first_failure = {3, 1e-6, 2e6, Vector(1.0, 2.0, 0.0), FailureMode::shear};
  const auto json = nlohmann::ordered_json::parse(format_summary(summary));
  std::vector<std::string> keys;
  for (const auto& entry : json.items()) {
    keys.push_back(entry.key());
  }
  CHECK(keys == std::vector<std::string>{
                    "particles", "steps", "dt_s", "wall_s", "particle_steps_per_second", "isa",
                    "threads", "version", "first_failure", "failed_tension", "failed_shear",
                    "peak_axial_stress_Pa", "energy_error", "removed", "state_hash"});
  CHECK(json["version"] == std::string(version()));
  CHECK(json["state_hash"] == "fedcba9876543210");
  CHECK(json["first_failure"].dump() ==
        R"({"step":3,"closure_m":1e-06,"axial_stress_Pa":2000000.0,"position_m":[1.0,2.0,0.0],)"
        R"("mode":"shear"})");
}

TEST_CASE("a summary without failure says null, and stays JSON with what is not a number") {
  Summary summary;
  summary.energy_error = std::numeric_limits<double>::quiet_NaN();
  const auto json = nlohmann::json::parse(format_summary(summary));
  CHECK(json["first_failure"].is_null());
  CHECK(json["energy_error"].is_null());
  CHECK(json["failed_tension"] == 0);
}

TEST_CASE("a file is put in place whole or not at all") {
  const TemporaryDirectory directory;
  write_file(directory / "a", "old");
  {
    const AtomicFile unfinished(directory / "a");
    write_text(unfinished.temporary(), "ne");
  }
  CHECK(read_text(directory / "a") == "old");
  write_file(directory / "a", "new");
  CHECK(read_text(directory / "a") == "new");
  CHECK(std::distance(std::filesystem::directory_iterator(directory.path()), {}) == 1);
}
