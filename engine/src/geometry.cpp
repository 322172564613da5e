#include "geometry.hpp"

#include <algorithm>
#include <cmath>

#include "case_error.hpp"
#include "rgimp/kernels/views.hpp"
#include "shapes.hpp"

namespace rgimp {
namespace {

constexpr double kDefaultMargin = 5.0;  // cells between the bodies and the edge of the grid
/// Before the bodies along x a whole group of bins: their first bin is then a group's first lane
/// and fewer lanes stay empty (1.13 lanes a particle in example 1 with 5 cells, 1.05 with 8).
constexpr double kDefaultMarginBefore = kernels::kGroupWidth;

Vector half_size(const Body& body) {
  if (body.shape == BodyShape::disk) {
    return {0.5 * body.size.x(), 0.5 * body.size.x(), 0.0};
  }
  return {0.5 * body.size.x(), 0.5 * body.size.y(), 0.0};
}

/// Half the length and width of the box around a slot, along x and y.
Vector slot_half_size(const Flaw& slot) {
  const double cosine = std::abs(std::cos(slot.angle * kRadiansPerDegree));
  const double sine = std::abs(std::sin(slot.angle * kRadiansPerDegree));
  const double half_length = 0.5 * slot.length;
  const double half_width = 0.5 * slot.width;
  if (slot.ends == SlotEnds::round) {
    const double straight = half_length - half_width;
    return {straight * cosine + half_width, straight * sine + half_width, 0.0};
  }
  return {half_length * cosine + half_width * sine, half_length * sine + half_width * cosine, 0.0};
}

bool slot_contains(const Flaw& slot, const Vector& offset, double tolerance) {
  if (offset.norm() > slot.length + slot.width) {
    return false;  // most points, without the cost of an angle
  }
  const double cosine = std::cos(slot.angle * kRadiansPerDegree);
  const double sine = std::sin(slot.angle * kRadiansPerDegree);
  const double along = std::abs(offset.x() * cosine + offset.y() * sine);
  const double across = std::abs(offset.y() * cosine - offset.x() * sine);
  const double half_length = 0.5 * slot.length;
  const double half_width = 0.5 * slot.width;
  if (slot.ends == SlotEnds::round) {
    const double past_straight = std::max(along - (half_length - half_width), 0.0);
    return std::hypot(past_straight, across) < half_width - tolerance;
  }
  return along < half_length - tolerance && across < half_width - tolerance;
}

std::uint8_t material_index(const Case& settings, std::size_t body) {
  const auto found = settings.materials.find(settings.bodies[body].material);
  if (found == settings.materials.end()) {
    refuse(settings.source, fmt::format("body[{}].material", body), "no such material");
  }
  return static_cast<std::uint8_t>(std::distance(settings.materials.begin(), found));
}

}  // namespace

Box bounds(const Body& body) {
  return {body.center - half_size(body), body.center + half_size(body)};
}

Box bounds(const Case& settings) {
  if (settings.bodies.empty()) {
    return {};
  }
  Box all = bounds(settings.bodies.front());
  for (const Body& body : settings.bodies) {
    const Box one = bounds(body);
    all.min = all.min.cwiseMin(one.min);
    all.max = all.max.cwiseMax(one.max);
  }
  return all;
}

Box bounds(const Flaw& flaw) {
  Vector half = Vector::Zero();
  switch (flaw.shape) {
    case FlawShape::slot:
      half = slot_half_size(flaw);
      break;
    case FlawShape::circle:
      half = Vector(0.5 * flaw.length, 0.5 * flaw.length, 0.0);
      break;
    case FlawShape::box:
      half = Vector(0.5 * flaw.size.x(), 0.5 * flaw.size.y(), 0.0);
      break;
  }
  return {flaw.center - half, flaw.center + half};
}

bool contains(const Body& body, const Vector& point, double tolerance) {
  const Vector offset = (point - body.center).cwiseAbs();
  if (body.shape == BodyShape::disk) {
    return std::hypot(offset.x(), offset.y()) <= 0.5 * body.size.x() + tolerance;
  }
  return offset.x() <= 0.5 * body.size.x() + tolerance &&
         offset.y() <= 0.5 * body.size.y() + tolerance;
}

bool contains(const Flaw& flaw, const Vector& point, double tolerance) {
  const Vector offset = point - flaw.center;
  switch (flaw.shape) {
    case FlawShape::slot:
      return slot_contains(flaw, offset, tolerance);
    case FlawShape::circle:
      return std::hypot(offset.x(), offset.y()) < 0.5 * flaw.length - tolerance;
    case FlawShape::box:
      return std::abs(offset.x()) < 0.5 * flaw.size.x() - tolerance &&
             std::abs(offset.y()) < 0.5 * flaw.size.y() - tolerance;
  }
  return false;
}

Lattice::Lattice(const Body& body, double cell_size)
    : corner_(bounds(body).min), pitch_(cell_size / body.particles_per_cell) {
  const Vector size = bounds(body).max - corner_;
  for (int axis = 0; axis < 2; ++axis) {
    // Half a pitch left over still holds a point, on its edge; round-off must not decide that.
    const double pitches = size[axis] / pitch_ + 0.5 + kEdgeTolerance;
    count_[static_cast<std::size_t>(axis)] = static_cast<std::int64_t>(std::floor(pitches));
  }
}

Vector Lattice::point(std::int64_t column, std::int64_t row) const {
  return {corner_.x() + (static_cast<double>(column) + 0.5) * pitch_,
          corner_.y() + (static_cast<double>(row) + 0.5) * pitch_, 0.0};
}

Box grid_box(const Case& settings) {
  const Box bodies = bounds(settings);
  const double margin = kDefaultMargin * settings.grid.cell_size;
  const double before = kDefaultMarginBefore * settings.grid.cell_size;
  return {settings.grid.min.value_or(bodies.min - Vector(before, margin, 0.0)),
          settings.grid.max.value_or(bodies.max + Vector(margin, margin, 0.0))};
}

GridExtent grid_extent(const Case& settings) {
  const Box box = grid_box(settings);
  GridExtent extent;
  extent.spacing = Vector::Constant(settings.grid.cell_size);
  extent.origin = box.min;
  extent.nodes = {1, 1, 1};
  for (int axis = 0; axis < 2; ++axis) {
    const double cells = (box.max[axis] - box.min[axis]) / extent.spacing[axis];
    extent.nodes[static_cast<std::size_t>(axis)] =
        static_cast<std::int64_t>(std::ceil(cells - kGridTolerance)) + 1;
  }
  return extent;
}

bool is_rock(const Case& settings, const Body& body, const Vector& point) {
  const double tolerance = kEdgeTolerance * settings.grid.cell_size;
  return contains(body, point, tolerance) &&
         std::none_of(settings.flaws.begin(), settings.flaws.end(),
                      [&](const Flaw& flaw) { return contains(flaw, point, tolerance); });
}

std::vector<ParticleSeed> seed_particles(const Case& settings) {
  std::vector<ParticleSeed> seeds;
  for (std::size_t b = 0; b < settings.bodies.size(); ++b) {
    const Body& body = settings.bodies[b];
    const Lattice lattice(body, settings.grid.cell_size);
    ParticleSeed seed;
    seed.material = material_index(settings, b);
    seed.velocity = body.velocity;
    seed.volume = lattice.pitch() * lattice.pitch();
    seed.mass = settings.materials.at(body.material).density * seed.volume;
    for (std::int64_t row = 0; row < lattice.rows(); ++row) {
      for (std::int64_t column = 0; column < lattice.columns(); ++column) {
        seed.position = lattice.point(column, row);
        if (is_rock(settings, body, seed.position)) {
          seeds.push_back(seed);
        }
      }
    }
  }
  return seeds;
}

}  // namespace rgimp
