#include "platen_geometry.hpp"

#include <algorithm>
#include <cmath>

namespace rgimp {

PlatenAxis axis_of(Side side) {
  switch (side) {
    case Side::left:
      return {0, 1.0};
    case Side::right:
      return {0, -1.0};
    case Side::bottom:
      return {1, 1.0};
    case Side::top:
      return {1, -1.0};
    case Side::back:
      return {2, 1.0};
    case Side::front:
      return {2, -1.0};
  }
  return {1, -1.0};
}

std::optional<int> load_axis(const Case& settings) {
  const std::vector<Platen>& platens = settings.platens;
  const auto moving = std::find_if(platens.begin(), platens.end(),
                                   [](const Platen& platen) { return platen.speed != 0.0; });
  if (moving != platens.end()) {
    return axis_of(moving->side).axis;
  }
  return platens.empty() ? std::nullopt : std::optional(axis_of(platens.front().side).axis);
}

PlatenContact::PlatenContact(const Platen& platen, const Box& specimen)
    : side(axis_of(platen.side)),
      across(side.axis == 0 ? 1 : 0),
      end(side.towards < 0.0 ? specimen.max[side.axis] : specimen.min[side.axis]),
      opposite(side.towards < 0.0 ? specimen.min[side.axis] : specimen.max[side.axis]),
      center(0.5 * (specimen.min[across] + specimen.max[across])),
      half_width(platen.half_width) {}

bool PlatenContact::holds(double position) const {
  constexpr double kTolerance = 1e-9;  // m
  return !half_width || std::abs(position - center) <= *half_width + kTolerance;
}

}  // namespace rgimp
