#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "case_check.hpp"
#include "case_error.hpp"
#include "case_names.hpp"
#include "shapes.hpp"

namespace rgimp {
namespace {

constexpr double kFewestCellsAcross = 2.0;
constexpr double kCellsAcrossObliqueSlot = 3.0;
constexpr double kAngleTolerance = 1e-6;  // degrees

/// Whether any point of the body's lattice in `part` satisfies `predicate`.
template <typename Predicate>
bool any_lattice_point(const Case& settings, const Body& body, const Box& part,
                       const Predicate& predicate) {
  const Lattice lattice(settings, body);
  const Lattice::Range columns = lattice.range(0, part);
  const Lattice::Range rows = lattice.range(1, part);
  const Lattice::Range planes = lattice.range(2, part);
  for (std::int64_t plane = planes.first; plane < planes.last; ++plane) {
    for (std::int64_t row = rows.first; row < rows.last; ++row) {
      for (std::int64_t column = columns.first; column < columns.last; ++column) {
        if (predicate(lattice.point(column, row, plane))) {
          return true;
        }
      }
    }
  }
  return false;
}

bool is_round(const Body& body) {
  return body.shape == BodyShape::disk || body.shape == BodyShape::sphere;
}

/// How deep the deepest point of a's lattice is in b; negative where none is.
double deepest_point(const Case& settings, const Body& a, const Body& b) {
  double deepest = -std::numeric_limits<double>::infinity();
  any_lattice_point(settings, a, bounds(b), [&](const Vector& point) {
    if (depth_inside(a, point) >= 0.0) {
      deepest = std::max(deepest, depth_inside(b, point));
    }
    return false;
  });
  return deepest;
}

/// How far two bodies reach into each other, negative where they are apart: boxes along the axis
/// where it is least; where one is a cylinder, as deep as particles of the one are in the other.
double overlap(const Case& settings, const Body& a, const Body& b) {
  if (a.shape == BodyShape::cylinder || b.shape == BodyShape::cylinder) {
    return std::max(deepest_point(settings, a, b), deepest_point(settings, b, a));
  }
  const Box box_a = bounds(a);
  const Box box_b = bounds(b);
  if (is_round(a) && is_round(b)) {
    return 0.5 * (a.size.x() + b.size.x()) - (a.center - b.center).norm();
  }
  if (is_round(a) || is_round(b)) {
    const Body& ball = is_round(a) ? a : b;
    const Box& box = is_round(a) ? box_b : box_a;
    const Vector nearest = ball.center.cwiseMax(box.min).cwiseMin(box.max);
    return 0.5 * ball.size.x() - (ball.center - nearest).norm();
  }
  const Vector depth = box_a.max.cwiseMin(box_b.max) - box_a.min.cwiseMax(box_b.min);
  const double in_plane = std::min(depth.x(), depth.y());
  return settings.dimension == 3 ? std::min(in_plane, depth.z()) : in_plane;
}

void check_overlaps(const Case& settings) {
  for (std::size_t i = 0; i < settings.bodies.size(); ++i) {
    for (std::size_t other = 0; other < i; ++other) {
      const double depth = overlap(settings, settings.bodies[i], settings.bodies[other]);
      if (depth > kGridTolerance * settings.grid.cell_size) {
        refuse(settings.source, fmt::format("body[{}]", i),
               fmt::format("reaches {:.4g} m into body[{}]; expected bodies that touch at most",
                           depth, other));
      }
    }
  }
}

/// A narrower flaw has faces that share nodes: they stay glued together.
void check_cells_across(const Case& settings, const std::string& key, double width) {
  const double cell = settings.grid.cell_size;
  if (width < (kFewestCellsAcross - kGridTolerance) * cell) {
    refuse(
        settings.source, key,
        fmt::format("is {} m, {:.4g} cells across; expected at least two cells, {:.6g} m: nearer "
                    "faces share grid nodes and stay glued",
                    width, width / cell, kFewestCellsAcross * cell));
  }
}

void check_flaw_width(const Case& settings, const std::string& path, const Flaw& flaw) {
  switch (flaw.shape) {
    case FlawShape::slot:
      if (flaw.depth) {
        check_cells_across(settings, path + ".depth", *flaw.depth);
      }
      return check_cells_across(settings, path + ".width", flaw.width);
    case FlawShape::penny:
      return check_cells_across(settings, path + ".width", flaw.width);
    case FlawShape::circle:
    case FlawShape::sphere:
      return check_cells_across(settings, path + ".length", flaw.length);
    case FlawShape::box:
      return check_cells_across(
          settings, path + ".size",
          settings.dimension == 3 ? flaw.size.minCoeff() : flaw.size.head<2>().minCoeff());
  }
}

std::string describe_point(const Case& settings, const Vector& point) {
  const std::string in_plane = fmt::format("{:.6g}, {:.6g}", point.x(), point.y());
  return settings.dimension == 3 ? fmt::format("({}, {:.6g})", in_plane, point.z())
                                 : fmt::format("({})", in_plane);
}

void check_flaw_place(const Case& settings, const std::string& path, const Flaw& flaw) {
  const double tolerance = kEdgeTolerance * settings.grid.cell_size;
  const Hole hole(flaw);
  const bool takes_any =
      std::any_of(settings.bodies.begin(), settings.bodies.end(), [&](const Body& body) {
        return any_lattice_point(settings, body, bounds(flaw), [&](const Vector& point) {
          return contains(body, point, tolerance) && hole.contains(point, tolerance);
        });
      });
  if (!takes_any) {
    const Box bodies = bounds(settings);
    refuse(settings.source, path + ".center",
           fmt::format("lies outside every body, so that no particle is left out; the bodies span "
                       "{} to {} m",
                       describe_point(settings, bodies.min), describe_point(settings, bodies.max)));
  }
}

/// Whether the faces of a slot or penny lie across the grid lines.
bool is_oblique(const Flaw& flaw) {
  const Vector normal = frame_of(flaw).across.cwiseAbs();
  int axis = 0;
  normal.maxCoeff(&axis);
  return normal.cross(Vector::Unit(axis)).norm() > kAngleTolerance * kRadiansPerDegree;
}

/// Particles fill a box from its lower corner and end up to half a pitch off its upper edge.
std::vector<std::string> warn_of_uneven_boxes(const Case& settings) {
  std::vector<std::string> warnings;
  for (std::size_t i = 0; i < settings.bodies.size(); ++i) {
    const Body& body = settings.bodies[i];
    const double pitch = settings.grid.cell_size / body.particles_per_cell;
    for (int axis = 0; axis < settings.dimension && body.shape == BodyShape::box; ++axis) {
      const double pitches = body.size[axis] / pitch;
      if (std::abs(pitches - std::round(pitches)) > kGridTolerance) {
        warnings.push_back(complaint(
            settings.source, fmt::format("body[{}].size[{}]", i, axis),
            fmt::format("is {} m, {:.6g} particles of {:.6g} m; whole numbers of particles make "
                        "{:.6g} or {:.6g} m",
                        body.size[axis], pitches, pitch, std::floor(pitches) * pitch,
                        std::ceil(pitches) * pitch)));
      }
    }
  }
  return warnings;
}

std::vector<std::string> warn_of_oblique_flaws(const Case& settings) {
  std::vector<std::string> warnings;
  const double cell = settings.grid.cell_size;
  for (std::size_t i = 0; i < settings.flaws.size(); ++i) {
    const Flaw& flaw = settings.flaws[i];
    const bool narrow = flaw.width < (kCellsAcrossObliqueSlot - kGridTolerance) * cell;
    const bool is_flat = flaw.shape == FlawShape::slot || flaw.shape == FlawShape::penny;
    if (is_flat && narrow && is_oblique(flaw)) {
      warnings.push_back(complaint(
          settings.source, fmt::format("flaw[{}].width", i),
          fmt::format("an oblique {} {:.4g} cells across still carries load (at two cells, 27 % "
                      "of a 45 degree slot's compliance is missing); better three cells, {:.6g} m",
                      name_of(flaw.shape), flaw.width / cell, kCellsAcrossObliqueSlot * cell)));
    }
  }
  return warnings;
}

void check_particles_left(const Case& settings) {
  for (std::size_t i = 0; i < settings.bodies.size(); ++i) {
    const Body& body = settings.bodies[i];
    const Rock rock(settings, body);
    const bool left = any_lattice_point(settings, body, bounds(body),
                                        [&](const Vector& point) { return rock.contains(point); });
    if (!left) {
      refuse(settings.source, fmt::format("body[{}]", i),
             fmt::format("no particle is left of it outside the flaws, at a spacing of {:.6g} m; "
                         "expected a larger body, smaller cells or smaller flaws",
                         settings.grid.cell_size / body.particles_per_cell));
    }
  }
}

}  // namespace

std::vector<std::string> check_bodies_and_flaws(const Case& settings) {
  check_overlaps(settings);
  for (std::size_t i = 0; i < settings.flaws.size(); ++i) {
    const std::string path = fmt::format("flaw[{}]", i);
    check_flaw_width(settings, path, settings.flaws[i]);
    check_flaw_place(settings, path, settings.flaws[i]);
  }
  check_particles_left(settings);
  std::vector<std::string> warnings = warn_of_uneven_boxes(settings);
  for (std::string& warning : warn_of_oblique_flaws(settings)) {
    warnings.push_back(std::move(warning));
  }
  return warnings;
}

}  // namespace rgimp
