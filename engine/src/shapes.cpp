#include "shapes.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace rgimp {
namespace {

/// How far a circle of radius 1 about the unit vector `axis` reaches along x, y and z.
Vector circle_half_size(const Vector& axis) {
  return (1.0 - axis.array().square()).max(0.0).sqrt();
}

Vector half_size(const Body& body) {
  const double radius = 0.5 * body.size.x();
  switch (body.shape) {
    case BodyShape::box:
      break;
    case BodyShape::disk:
      return {radius, radius, 0.0};
    case BodyShape::cylinder: {
      const Vector axis = body.axis.normalized();
      return 0.5 * body.size.y() * axis.cwiseAbs() + radius * circle_half_size(axis);
    }
    case BodyShape::sphere:
      return Vector::Constant(radius);
  }
  return 0.5 * body.size;
}

/// How far a segment along the unit vector `direction` reaches; without a length it has no end.
Vector segment_half_size(const Vector& direction, std::optional<double> length) {
  Vector half = direction.cwiseAbs();
  for (double& component : half) {
    if (component != 0.0) {  // infinity times 0 is not a number
      component *= 0.5 * length.value_or(std::numeric_limits<double>::infinity());
    }
  }
  return half;
}

Vector slot_half_size(const Flaw& slot) {
  const FlawFrame frame = frame_of(slot);
  const Vector depth = segment_half_size(frame.deep, slot.depth);
  if (slot.ends == SlotEnds::round) {
    return segment_half_size(frame.along, slot.length - slot.width) +
           0.5 * slot.width * circle_half_size(frame.deep) + depth;
  }
  return segment_half_size(frame.along, slot.length) + segment_half_size(frame.across, slot.width) +
         depth;
}

Vector half_size(const Flaw& flaw) {
  const double radius = 0.5 * flaw.length;
  switch (flaw.shape) {
    case FlawShape::slot:
      return slot_half_size(flaw);
    case FlawShape::circle:
      return {radius, radius, 0.0};
    case FlawShape::box:
      break;
    case FlawShape::sphere:
      return Vector::Constant(radius);
    case FlawShape::penny: {
      const Vector normal = frame_of(flaw).across;
      return segment_half_size(normal, flaw.width) + radius * circle_half_size(normal);
    }
  }
  return 0.5 * flaw.size;
}

}  // namespace

FlawFrame frame_of(const Flaw& flaw) {
  FlawFrame frame;
  if (flaw.normal) {
    frame.across = flaw.normal->normalized();
    frame.along = flaw.direction.value_or(flaw.normal->unitOrthogonal()).normalized();
  } else {
    const double angle = flaw.angle * kRadiansPerDegree;
    frame.along = {std::cos(angle), std::sin(angle), 0.0};
    frame.across = {-frame.along.y(), frame.along.x(), 0.0};
  }
  frame.deep = frame.along.cross(frame.across);
  return frame;
}

Box bounds(const Body& body) {
  const Vector half = half_size(body);
  return {body.center - half, body.center + half};
}

Box bounds(const Flaw& flaw) {
  const Vector half = half_size(flaw);
  return {flaw.center - half, flaw.center + half};
}

double depth_inside(const Body& body, const Vector& point) {
  const Vector offset = point - body.center;
  const double radius = 0.5 * body.size.x();
  switch (body.shape) {
    case BodyShape::box:
      break;
    case BodyShape::disk:
      return radius - std::hypot(offset.x(), offset.y());
    case BodyShape::cylinder: {
      const Vector axis = body.axis.normalized();
      const double along = offset.dot(axis);
      return std::min(0.5 * body.size.y() - std::abs(along),
                      radius - (offset - along * axis).norm());
    }
    case BodyShape::sphere:
      return radius - offset.norm();
  }
  return (0.5 * body.size - offset.cwiseAbs()).minCoeff();
}

bool contains(const Body& body, const Vector& point, double tolerance) {
  return depth_inside(body, point) >= -tolerance;
}

bool Hole::contains_in_slot(const Vector& offset, double tolerance) const {
  const double along = std::abs(offset.dot(frame_.along));
  const double across = std::abs(offset.dot(frame_.across));
  const double half_length = 0.5 * flaw_.length;
  const double half_width = 0.5 * flaw_.width;
  if (flaw_.depth && std::abs(offset.dot(frame_.deep)) >= 0.5 * *flaw_.depth - tolerance) {
    return false;
  }
  if (flaw_.ends == SlotEnds::round) {
    const double past_straight = std::max(along - (half_length - half_width), 0.0);
    return std::hypot(past_straight, across) < half_width - tolerance;
  }
  return along < half_length - tolerance && across < half_width - tolerance;
}

bool Hole::contains(const Vector& point, double tolerance) const {
  const Vector offset = point - flaw_.center;
  const double radius = 0.5 * flaw_.length - tolerance;
  switch (flaw_.shape) {
    case FlawShape::slot:
      return contains_in_slot(offset, tolerance);
    case FlawShape::circle:
      return std::hypot(offset.x(), offset.y()) < radius;
    case FlawShape::box:
      break;
    case FlawShape::sphere:
      return offset.norm() < radius;
    case FlawShape::penny: {
      const double across = offset.dot(frame_.across);
      return std::abs(across) < 0.5 * flaw_.width - tolerance &&
             (offset - across * frame_.across).norm() < radius;
    }
  }
  const auto inside = offset.array().abs() < 0.5 * flaw_.size.array() - tolerance;
  const bool is_plane = flaw_.size.z() == 0.0;  // in two dimensions
  return inside.x() && inside.y() && (is_plane || inside.z());
}

bool contains(const Flaw& flaw, const Vector& point, double tolerance) {
  return Hole(flaw).contains(point, tolerance);
}

Rock::Rock(const Case& settings, const Body& body)
    : body_(body), tolerance_(kEdgeTolerance * settings.grid.cell_size) {
  const Box box = bounds(body);
  for (const Flaw& flaw : settings.flaws) {
    const Box hole = bounds(flaw);
    if ((hole.min.array() <= box.max.array()).all() &&
        (box.min.array() <= hole.max.array()).all()) {
      holes_.emplace_back(flaw);
    }
  }
}

bool Rock::contains(const Vector& point) const {
  return rgimp::contains(body_, point, tolerance_) &&
         std::none_of(holes_.begin(), holes_.end(),
                      [&](const Hole& hole) { return hole.contains(point, tolerance_); });
}

Lattice::Lattice(const Case& settings, const Body& body)
    : corner_(bounds(body).min), pitch_(settings.grid.cell_size / body.particles_per_cell) {
  const Vector size = bounds(body).max - corner_;
  for (int axis = 0; axis < settings.dimension; ++axis) {
    // Half a pitch left over still holds a point, on its edge; round-off must not decide that.
    const double pitches = size[axis] / pitch_ + 0.5 + kEdgeTolerance;
    count_[static_cast<std::size_t>(axis)] = static_cast<std::int64_t>(std::floor(pitches));
    first_[axis] = 0.5;
  }
}

Lattice::Range Lattice::range(int axis, const Box& part) const {
  const auto count = static_cast<double>(count_[static_cast<std::size_t>(axis)]);
  const double first = (part.min[axis] - corner_[axis]) / pitch_ - 1.0;  // one more: round-off
  const double last = (part.max[axis] - corner_[axis]) / pitch_ + 1.0;
  return {static_cast<std::int64_t>(std::clamp(first, 0.0, count)),
          static_cast<std::int64_t>(std::clamp(std::ceil(last), 0.0, count))};
}

Vector Lattice::point(std::int64_t column, std::int64_t row, std::int64_t plane) const {
  const Vector index(static_cast<double>(column), static_cast<double>(row),
                     static_cast<double>(plane));
  return corner_ + (index + first_) * pitch_;
}

}  // namespace rgimp
