#include "crack_table.hpp"

#include <fmt/format.h>

#include "format.hpp"

namespace rgimp::cli {

namespace {

std::string plane_in_mm(const Vector& position) {
  return fmt::format("({:.2f}, {:.2f})", position.x() * 1e3, position.y() * 1e3);
}

std::string angle_text(const Cracks& cracks, const Wing& wing, double span) {
  const auto angle = wing_angle(wing, span);
  if (!angle) {
    return "-";
  }
  const auto to_load = angle_to_load(cracks, *angle);
  return to_load ? fmt::format("{:.0f} ({:.0f})", *angle, *to_load) : fmt::format("{:.0f}", *angle);
}

constexpr std::string_view kWingLine =
    "{:<15} {:>16} {:>7} {:>10} {:>16} {:>16} {:>10} {:>9} {:>10} {:>10}\n";

std::string format_wing(const Cracks& cracks, const Wing& wing) {
  const std::vector<CrackFront> front = trace_front(wing);
  if (front.empty()) {
    return fmt::format("{:<15} {:>16} no crack\n", wing.name, plane_in_mm(wing.tip));
  }
  return fmt::format(
      kWingLine, wing.name, plane_in_mm(wing.tip), with_separators(wing.particles.size()),
      with_separators(front.front().step), plane_in_mm(front.front().position),
      plane_in_mm(front.back().position), with_separators(front.back().step),
      fmt::format("{:.2f}", front.back().length * 1e3), angle_text(cracks, wing, kWingSpans[0]),
      angle_text(cracks, wing, kWingSpans[1]));
}

}  // namespace

std::string format_cracks(const Cracks& cracks) {
  std::int64_t in_wings = 0;
  for (const Wing& wing : cracks.wings) {
    in_wings += static_cast<std::int64_t>(wing.particles.size());
  }
  const auto outline = static_cast<std::int64_t>(cracks.outline);
  const auto elsewhere = static_cast<std::int64_t>(cracks.elsewhere);
  std::string text =
      fmt::format("{} failed: {} in cracks from flaws, {} along faces of flaws, {} elsewhere\n",
                  with_separators(in_wings + outline + elsewhere), with_separators(in_wings),
                  with_separators(outline), with_separators(elsewhere));
  if (!cracks.wings.empty()) {
    text +=
        "\nWings: lengths in mm; directions over 2 and 5 mm in degrees from +x (from the load)\n";
    text += fmt::format(kWingLine, "wing", "tip", "failed", "from step", "from", "front", "at step",
                        "length", "over 2 mm", "over 5 mm");
  }
  for (const Wing& wing : cracks.wings) {
    text += format_wing(cracks, wing);
  }
  if (!cracks.events.empty()) {
    text += "\nEvents\n";
  }
  for (const CrackEvent& event : cracks.events) {
    text += fmt::format("{:>11}  {}, {} mm\n", with_separators(event.step), describe(event),
                        plane_in_mm(event.position));
  }
  return text;
}

}  // namespace rgimp::cli
