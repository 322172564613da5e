#include "recorder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "rgimp/error.hpp"

namespace rgimp {

namespace {

using Json = nlohmann::ordered_json;

Json to_json(const HistoryRow& row) {
  return {row.step,         row.time,           row.closure,         row.axial_stress,
          row.reaction,     row.kinetic_energy, row.strain_energy,   row.external_work,
          row.damping_work, row.viscous_work,   row.released_energy, row.failed_tension,
          row.failed_shear, row.removed_energy};
}

HistoryRow history_row(const Json& json) {
  HistoryRow row;
  row.step = json.at(0).get<std::int64_t>();
  row.time = json.at(1).get<double>();
  row.closure = json.at(2).get<double>();
  row.axial_stress = json.at(3).get<double>();
  row.reaction = json.at(4).get<double>();
  row.kinetic_energy = json.at(5).get<double>();
  row.strain_energy = json.at(6).get<double>();
  row.external_work = json.at(7).get<double>();
  row.damping_work = json.at(8).get<double>();
  row.viscous_work = json.at(9).get<double>();
  row.released_energy = json.at(10).get<double>();
  row.failed_tension = json.at(11).get<std::int64_t>();
  row.failed_shear = json.at(12).get<std::int64_t>();
  row.removed_energy = json.at(13).get<double>();
  return row;
}

}  // namespace

/// What note() says, read back.
struct Recorder::Past {
  HistoryFile::Extent history;
  HistoryRow first_row;
  HistoryRow last_row;
  double largest_work = 0.0;
  std::vector<SnapshotTime> snapshots;
  std::string isa;

  /// None where the note is not a run's.
  static std::optional<Past> read(std::string_view note) {
    try {
      return Past(Json::parse(note));
    } catch (const nlohmann::json::exception&) {
      return std::nullopt;
    }
  }

  explicit Past(const Json& json)
      : first_row(history_row(json.at("first_row"))),
        last_row(history_row(json.at("last_row"))),
        largest_work(json.at("largest_work").get<double>()),
        isa(json.at("isa").get<std::string>()) {
    history.bytes = json.at("history_bytes").get<std::uint64_t>();
    history.checksum = json.at("history_checksum").get<std::uint64_t>();
    for (const Json& snapshot : json.at("snapshots")) {
      snapshots.push_back({snapshot.at(0).get<std::int64_t>(), snapshot.at(1).get<double>()});
    }
  }
};

Recorder::Recorder(const Simulation& simulation, OutputDirectory& directory)
    : simulation_(simulation),
      directory_(directory),
      schedule_(simulation.settings().output, simulation.facts().total_steps),
      history_(directory.history_file()) {}

std::unique_ptr<Recorder> Recorder::go_on(const Simulation& simulation, OutputDirectory& directory,
                                          std::string_view note) {
  const std::optional<Past> past = Past::read(note);
  if (!past) {
    return nullptr;
  }
  auto history = HistoryFile::go_on(directory.history_file(), past->history);
  return history ? std::unique_ptr<Recorder>(
                       new Recorder(simulation, directory, *past, std::move(*history)))
                 : nullptr;
}

Recorder::Recorder(const Simulation& simulation, OutputDirectory& directory, const Past& past,
                   HistoryFile history)
    : simulation_(simulation),
      directory_(directory),
      schedule_(simulation.settings().output, simulation.facts().total_steps),
      history_(std::move(history)),
      first_row_(past.first_row),
      last_row_(past.last_row),
      history_step_(past.last_row.step),
      snapshots_(past.snapshots),
      largest_work_(past.largest_work),
      past_isa_(past.isa) {
  directory.go_back_to(simulation.steps_done());
  std::erase_if(snapshots_, [&](const SnapshotTime& snapshot) {
    return !std::filesystem::exists(directory.snapshot_file(snapshot.step));  // deleted by hand
  });
  write_series(directory.series_file(), snapshots_);
}

void Recorder::write_due() {
  const std::int64_t step = simulation_.steps_done();
  if (schedule_.writes_history(step)) {
    write_history();
  }
  if (schedule_.writes_snapshot(step)) {
    write_snapshot();
  }
}

void Recorder::write_all() {
  const std::int64_t step = simulation_.steps_done();
  if (!history_step_ || *history_step_ != step) {
    write_history();
  }
  if (snapshots_.empty() || snapshots_.back().step != step) {
    write_snapshot();
  }
}

std::string Recorder::note() {
  const HistoryFile::Extent history = history_.sync();
  Json snapshots = Json::array();
  for (const SnapshotTime& snapshot : snapshots_) {
    snapshots.push_back({snapshot.step, snapshot.time});
  }
  const Json json{{"history_bytes", history.bytes},   {"history_checksum", history.checksum},
                  {"first_row", to_json(first_row_)}, {"last_row", to_json(last_row_)},
                  {"largest_work", largest_work_},    {"snapshots", snapshots},
                  {"isa", simulation_.facts().isa}};
  return json.dump();
}

void Recorder::write_history() {
  last_row_ = simulation_.history();
  largest_work_ = std::max(largest_work_, std::abs(last_row_.external_work));
  history_.append(last_row_);
  if (!history_step_) {
    first_row_ = last_row_;
  }
  history_step_ = last_row_.step;
}

void Recorder::write_snapshot() {
  const SnapshotTime now{simulation_.steps_done(), simulation_.time()};
  rgimp::write_snapshot(directory_.snapshot_file(now.step), simulation_.particles(), now);
  snapshots_.push_back(now);
  write_series(directory_.series_file(), snapshots_);
}

}  // namespace rgimp
