#include <fmt/format.h>

#include "atomic_file.hpp"
#include "case_names.hpp"
#include "json.hpp"
#include "rgimp/cracks.hpp"
#include "rgimp/results.hpp"

namespace rgimp {

namespace fs = std::filesystem;

namespace {

Json to_json(const CrackFront& front) {
  return {{"step", front.step},
          {"position_m", vector_json(front.position)},
          {"length_m", front.length}};
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
          {"tip_m", vector_json(wing.tip)},
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
          {"position_m", vector_json(event.position)}};
}

}  // namespace

Cracks trace_cracks(const fs::path& directory, std::optional<std::int64_t> until) {
  const Results results = read_results(directory, until);
  return trace_cracks(results.settings, results.particles);
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

std::string json_text(const Cracks& cracks) {
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
  return json.dump(1) + "\n";
}

void write_cracks(const fs::path& path, const Cracks& cracks) {
  write_file(path, json_text(cracks));
}

}  // namespace rgimp
