#include "crack_geometry.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

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

/// Signed distance to what a plane figure sweeps along the axis across its plane: from the distance
/// to the figure and that to the two ends.
double distance_to_swept(double to_figure, double to_ends) {
  return std::hypot(std::max(to_figure, 0.0), std::max(to_ends, 0.0)) +
         std::min(std::max(to_figure, to_ends), 0.0);
}

double distance_to_slot(const Flaw& slot, const Vector& offset) {
  const FlawFrame frame = frame_of(slot);
  const Vector local(std::abs(offset.dot(frame.along)), std::abs(offset.dot(frame.across)), 0.0);
  const double half_width = 0.5 * slot.width;
  const double to_figure =
      slot.ends == SlotEnds::round
          ? distance_to_box(local, 0.5 * slot.length - half_width, 0.0) - half_width
          : distance_to_box(local, 0.5 * slot.length, half_width);
  return slot.depth
             ? distance_to_swept(to_figure, std::abs(offset.dot(frame.deep)) - 0.5 * *slot.depth)
             : to_figure;
}

double distance_to_penny(const Flaw& penny, const Vector& offset) {
  const double height = offset.dot(frame_of(penny).across);
  const double radius = std::sqrt(std::max(offset.squaredNorm() - height * height, 0.0));
  return distance_to_swept(radius - 0.5 * penny.length, std::abs(height) - 0.5 * penny.width);
}

double distance_to_box_flaw(const Flaw& box, const Vector& offset) {
  const double to_figure =
      distance_to_box(offset.cwiseAbs(), 0.5 * box.size.x(), 0.5 * box.size.y());
  const bool is_flat = box.size.z() == 0.0;  // two dimensions
  return is_flat ? to_figure
                 : distance_to_swept(to_figure, std::abs(offset.z()) - 0.5 * box.size.z());
}

struct Surface {
  double distance;  ///< m, inwards
  Vector outwards;
};

/// Where a round body's surface is nearest, seen from an offset from its centre or axis.
Surface round_surface(const Vector& offset, double radius) {
  const double distance = offset.norm();
  return {radius - distance, distance > 0.0 ? Vector(offset / distance) : Vector::UnitY()};
}

std::vector<Surface> surfaces(const Body& body, const Vector& point) {
  const Vector offset = point - body.center;
  const double radius = 0.5 * body.size.x();
  switch (body.shape) {
    case BodyShape::disk:
    case BodyShape::sphere:
      return {round_surface(offset, radius)};
    case BodyShape::cylinder: {
      const Vector axis = body.axis.normalized();
      const double height = offset.dot(axis);
      const double half_height = 0.5 * body.size.y();
      return {round_surface(offset - height * axis, radius),
              {half_height - height, axis},
              {half_height + height, -axis}};
    }
    case BodyShape::box:
      break;
  }
  std::vector<Surface> faces;
  for (const int axis : {1, 0, 2}) {
    const Vector outwards = Vector::Unit(axis);
    if (body.size[axis] > 0.0) {  // not along z in two dimensions
      faces.push_back({0.5 * body.size[axis] - offset[axis], outwards});
      faces.push_back({0.5 * body.size[axis] + offset[axis], -outwards});
    }
  }
  return faces;
}

Surface nearest_surface(const Body& body, const Vector& point) {
  const auto nearer = [](const Surface& a, const Surface& b) { return a.distance < b.distance; };
  const std::vector<Surface> all = surfaces(body, point);
  return *std::min_element(all.begin(), all.end(), nearer);
}

/// Up or down where a direction is as much so as sideways.
Side side_towards(const Vector& outwards) {
  const Vector size = outwards.cwiseAbs();
  if (size.y() >= size.x() && size.y() >= size.z()) {
    return outwards.y() > 0.0 ? Side::top : Side::bottom;
  }
  if (size.x() >= size.z()) {
    return outwards.x() > 0.0 ? Side::right : Side::left;
  }
  return outwards.z() > 0.0 ? Side::front : Side::back;
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
      return offset.norm() - 0.5 * flaw.length;
    case FlawShape::penny:
      return distance_to_penny(flaw, offset);
    case FlawShape::box:
      return distance_to_box_flaw(flaw, offset);
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
      return side_towards(surface.outwards);
    }
  }
  return std::nullopt;
}

}  // namespace rgimp
