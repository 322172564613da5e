#include "crack_geometry.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "shapes.hpp"

namespace rgimp {

namespace {

Vector direction(double degrees) {
  return {std::cos(degrees * kRadiansPerDegree), std::sin(degrees * kRadiansPerDegree), 0.0};
}

/// 0 -> A, 25 -> Z, 26 -> AA.
std::string letters(std::size_t number) {
  constexpr std::size_t count = 26;
  const std::string last(1, static_cast<char>('A' + number % count));
  return number < count ? last : letters(number / count - 1) + last;
}

void add_slot(std::vector<CrackSource>& sources, const Flaw& slot, std::size_t flaw,
              std::size_t& tips) {
  const Vector half = 0.5 * slot.length * direction(slot.angle);
  sources.push_back({letters(tips++), flaw, slot.center + half, true});
  sources.push_back({letters(tips++), flaw, slot.center - half, true});
  sources.push_back({fmt::format("flaw[{}] middle", flaw), flaw, slot.center});
}

/// Eight points: corners and middles of the edges of a box, every 45 degrees of a circle.
void add_around(std::vector<CrackSource>& sources, const Flaw& shape, std::size_t flaw) {
  const bool box = shape.shape == FlawShape::box;
  for (int eighth = 0; eighth < 8; ++eighth) {
    const double degrees = 45.0 * eighth;
    const Vector way = direction(degrees);
    const Vector offset = box ? Vector(0.5 * shape.size.x() * std::round(way.x()),
                                       0.5 * shape.size.y() * std::round(way.y()), 0.0)
                              : Vector(0.5 * shape.length * way);
    sources.push_back(
        {fmt::format("flaw[{}] {:g} deg", flaw, degrees), flaw, shape.center + offset});
  }
}

/// Signed distance to a box around the origin, `point` in its quarter of positive coordinates.
double distance_to_box(const Vector& point, double half_x, double half_y) {
  const double x = point.x() - half_x;
  const double y = point.y() - half_y;
  return std::hypot(std::max(x, 0.0), std::max(y, 0.0)) + std::min(std::max(x, y), 0.0);
}

double distance_to_slot(const Flaw& slot, const Vector& offset) {
  const Vector along = direction(slot.angle);
  const Vector local(std::abs(offset.dot(along)),
                     std::abs(offset.y() * along.x() - offset.x() * along.y()), 0.0);
  const double half_width = 0.5 * slot.width;
  if (slot.ends == SlotEnds::round) {
    return distance_to_box(local, 0.5 * slot.length - half_width, 0.0) - half_width;
  }
  return distance_to_box(local, 0.5 * slot.length, half_width);
}

struct Surface {
  double distance;  ///< m, inwards
  Vector outwards;
  Side side;
};

std::array<Surface, 4> surfaces(const Body& body, const Vector& point) {
  const Box box = bounds(body);
  return {{{box.max.y() - point.y(), Vector::UnitY(), Side::top},
           {point.y() - box.min.y(), -Vector::UnitY(), Side::bottom},
           {point.x() - box.min.x(), -Vector::UnitX(), Side::left},
           {box.max.x() - point.x(), Vector::UnitX(), Side::right}}};
}

Surface nearest_surface(const Body& body, const Vector& point) {
  const auto nearer = [](const Surface& a, const Surface& b) { return a.distance < b.distance; };
  const auto sides = surfaces(body, point);
  Surface nearest = *std::min_element(sides.begin(), sides.end(), nearer);
  if (body.shape == BodyShape::disk) {  // its side is where the rim looks to
    const Vector offset = point - body.center;
    const double radius = offset.norm();
    nearest.distance = 0.5 * body.size.x() - radius;
    nearest.outwards = radius > 0.0 ? Vector(offset / radius) : Vector::UnitY();
  }
  return nearest;
}

}  // namespace

std::vector<CrackSource> crack_sources(const Case& settings) {
  std::vector<CrackSource> sources;
  std::size_t tips = 0;
  for (std::size_t f = 0; f < settings.flaws.size(); ++f) {
    if (settings.flaws[f].shape == FlawShape::slot) {
      add_slot(sources, settings.flaws[f], f, tips);
    } else {
      add_around(sources, settings.flaws[f], f);
    }
  }
  return sources;
}

double distance_to(const Flaw& flaw, const Vector& point) {
  const Vector offset = point - flaw.center;
  switch (flaw.shape) {
    case FlawShape::slot:
      return distance_to_slot(flaw, offset);
    case FlawShape::circle:
    case FlawShape::sphere:
    case FlawShape::penny:
      return offset.norm() - 0.5 * flaw.length;
    case FlawShape::box:
      return distance_to_box(offset.cwiseAbs(), 0.5 * flaw.size.x(), 0.5 * flaw.size.y());
  }
  return 0.0;
}

std::optional<Side> side_within(const Case& settings, const Vector& point, double reach) {
  const double tolerance = kEdgeTolerance * settings.grid.cell_size;
  for (const Body& body : settings.bodies) {
    if (!contains(body, point, tolerance)) {
      continue;
    }
    const Surface surface = nearest_surface(body, point);
    const Vector beyond = point + (surface.distance + reach) * surface.outwards;
    const bool open = std::none_of(
        settings.bodies.begin(), settings.bodies.end(),
        [&](const Body& other) { return &other != &body && contains(other, beyond, tolerance); });
    if (surface.distance <= reach + tolerance && open) {
      return surface.side;
    }
  }
  return std::nullopt;
}

}  // namespace rgimp
