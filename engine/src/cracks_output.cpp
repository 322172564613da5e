#include <fmt/format.h>

#include <charconv>
#include <nlohmann/json.hpp>
#include <system_error>

#include "atomic_file.hpp"
#include "case_names.hpp"
#include "geometry.hpp"
#include "input_file.hpp"
#include "rgimp/case_file.hpp"
#include "rgimp/cracks.hpp"
#include "rgimp/error.hpp"
#include "snapshot.hpp"
#include "snapshot_reader.hpp"

namespace rgimp {

namespace fs = std::filesystem;

namespace {

using Json = nlohmann::ordered_json;

struct SnapshotFile {
  std::int64_t step = -1;
  fs::path path;
};

std::int64_t step_of(const fs::path& snapshot) {
  const std::string name = snapshot.stem().string();
  const std::size_t digits = name.find('_') + 1;
  std::int64_t step = -1;
  std::from_chars(name.data() + digits, name.data() + name.size(), step);
  return step;
}

SnapshotFile last_snapshot(const fs::path& directory) {
  SnapshotFile last;
  try {
    for (const fs::directory_entry& entry : fs::directory_iterator(directory / "snapshots")) {
      if (is_snapshot_name(entry.path().filename().string()) && step_of(entry.path()) > last.step) {
        last = {step_of(entry.path()), entry.path()};
      }
    }
  } catch (const fs::filesystem_error& error) {
    throw FileError(fmt::format("cannot read the snapshots in '{}': {}", directory.string(),
                                error.code().message()));
  }
  if (last.path.empty()) {
    throw FileError(fmt::format("there are no snapshots in '{}'", directory.string()));
  }
  return last;
}

/// What failed after `step` is intact again.
void forget_after(std::int64_t step, ParticleTable& particles) {
  for (std::size_t row = 0; row < particles.size(); ++row) {
    if (particles.failure_step[row] > step) {
      particles.failed[row] = FailureMode::intact;
      particles.failure_step[row] = -1;
    }
  }
}

Json to_json(const Vector& position) {
  return {position.x(), position.y(), position.z()};
}

Json to_json(const CrackFront& front) {
  return {
      {"step", front.step}, {"position_m", to_json(front.position)}, {"length_m", front.length}};
}

Json to_json(const std::optional<double>& number) {
  return number ? Json(*number) : Json();
}

Json angles_of(const Wing& wing, const Cracks& cracks) {
  Json angles = Json::array();
  for (const double span : kWingSpans) {
    const auto angle = wing_angle(wing, span);
    const auto to_load = angle ? angle_to_load(cracks, *angle) : std::nullopt;
    angles.push_back(
        {{"span_m", span}, {"deg", to_json(angle)}, {"to_load_deg", to_json(to_load)}});
  }
  return angles;
}

Json to_json(const Wing& wing, const Cracks& cracks) {
  Json fronts = Json::array();
  for (const CrackFront& front : trace_front(wing)) {
    fronts.push_back(to_json(front));
  }
  return {{"name", wing.name},
          {"flaw", wing.flaw},
          {"tip_m", to_json(wing.tip)},
          {"failed", wing.particles.size()},
          {"angles", angles_of(wing, cracks)},
          {"front", fronts}};
}

Json to_json(const CrackEvent& event) {
  return {{"step", event.step},
          {"event", describe(event)},
          {"wing", event.wing},
          {"other_wing", event.other_wing ? Json(*event.other_wing) : Json()},
          {"side", event.side ? Json(name_of(*event.side)) : Json()},
          {"position_m", to_json(event.position)}};
}

}  // namespace

Cracks trace_cracks(const fs::path& directory, std::optional<std::int64_t> until) {
  std::error_code ignored;
  if (!fs::exists(fs::symlink_status(directory / "case.toml", ignored))) {
    throw CaseError(fmt::format("'{}' is no output directory of `rgimp run`: it has no case.toml",
                                directory.string()));
  }
  require_regular_file(directory / "case.toml");
  const Case settings = read_case(directory / "case.toml");
  const SnapshotFile last = last_snapshot(directory);
  require_regular_file(last.path);
  ParticleTable particles =
      read_snapshot(last.path, seed_particles(settings).size(), settings.grid.on_exit);
  if (until) {
    if (*until > last.step) {
      throw CaseError(fmt::format("step {} lies past the last snapshot, of step {}, in '{}'",
                                  *until, last.step, directory.string()));
    }
    forget_after(*until, particles);
  }
  return trace_cracks(settings, particles);
}

std::string describe(const CrackEvent& event) {
  if (event.other_wing) {
    return fmt::format("{} and {} meet", event.wing, *event.other_wing);
  }
  if (event.side) {
    return fmt::format("{} reaches the {} side", event.wing, name_of(*event.side));
  }
  return fmt::format("first failure at {}", event.wing);
}

void write_cracks(const fs::path& path, const Cracks& cracks) {
  Json wings = Json::array();
  std::size_t failed = cracks.outline + cracks.elsewhere;
  for (const Wing& wing : cracks.wings) {
    failed += wing.particles.size();
    wings.push_back(to_json(wing, cracks));
  }
  Json events = Json::array();
  for (const CrackEvent& event : cracks.events) {
    events.push_back(to_json(event));
  }
  const Json json{{"failed", failed},
                  {"outline", cracks.outline},
                  {"elsewhere", cracks.elsewhere},
                  {"wings", wings},
                  {"events", events}};
  write_file(path, json.dump(1) + "\n");
}

}  // namespace rgimp
