#include <algorithm>
#include <cmath>
#include <utility>

#include "case_check.hpp"
#include "case_error.hpp"
#include "shapes.hpp"

namespace rgimp {
namespace {

constexpr double kFewestCellsAcross = 2.0;
constexpr double kCellsAcrossObliqueSlot = 3.0;
constexpr double kAngleTolerance = 1e-6;  // degrees

/// How far a disk and a box, or two disks, reach into each other; boxes along the axis where it
/// is least. Negative where they are apart.
double overlap(const Body& a, const Body& b) {
  const Box box_a = bounds(a);
  const Box box_b = bounds(b);
  if (a.shape == BodyShape::disk && b.shape == BodyShape::disk) {
    return 0.5 * (a.size.x() + b.size.x()) - (a.center - b.center).head<2>().norm();
  }
  if (a.shape == BodyShape::box && b.shape == BodyShape::box) {
    const Vector depth = box_a.max.cwiseMin(box_b.max) - box_a.min.cwiseMax(box_b.min);
    return std::min(depth.x(), depth.y());
  }
  const Body& disk = a.shape == BodyShape::disk ? a : b;
  const Box& box = a.shape == BodyShape::disk ? box_b : box_a;
  const Vector nearest = disk.center.cwiseMax(box.min).cwiseMin(box.max);
  return 0.5 * disk.size.x() - (disk.center - nearest).head<2>().norm();
}

void check_overlaps(const Case& settings) {
  for (std::size_t i = 0; i < settings.bodies.size(); ++i) {
    for (std::size_t other = 0; other < i; ++other) {
      const double depth = overlap(settings.bodies[i], settings.bodies[other]);
      if (depth > kGridTolerance * settings.grid.cell_size) {
        refuse(settings.source, fmt::format("body[{}]", i),
               fmt::format("reaches {:.4g} m into body[{}]; expected bodies that touch at most",
                           depth, other));
      }
    }
  }
}

/// Whether any point of the body's lattice satisfies `predicate`.
template <typename Predicate>
bool any_lattice_point(const Case& settings, const Body& body, const Predicate& predicate) {
  const Lattice lattice(body, settings.grid.cell_size);
  for (std::int64_t row = 0; row < lattice.rows(); ++row) {
    for (std::int64_t column = 0; column < lattice.columns(); ++column) {
      if (predicate(lattice.point(column, row))) {
        return true;
      }
    }
  }
  return false;
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
      return check_cells_across(settings, path + ".width", flaw.width);
    case FlawShape::circle:
      return check_cells_across(settings, path + ".length", flaw.length);
    case FlawShape::box:
      return check_cells_across(settings, path + ".size", flaw.size.head<2>().minCoeff());
  }
}

void check_flaw_place(const Case& settings, const std::string& path, const Flaw& flaw) {
  const double tolerance = kEdgeTolerance * settings.grid.cell_size;
  const bool takes_any =
      std::any_of(settings.bodies.begin(), settings.bodies.end(), [&](const Body& body) {
        return any_lattice_point(settings, body, [&](const Vector& point) {
          return contains(body, point, tolerance) && contains(flaw, point, tolerance);
        });
      });
  if (!takes_any) {
    const Box bodies = bounds(settings);
    refuse(settings.source, path + ".center",
           fmt::format("lies outside every body, so that no particle is left out; the bodies span "
                       "({:.6g}, {:.6g}) to ({:.6g}, {:.6g}) m",
                       bodies.min.x(), bodies.min.y(), bodies.max.x(), bodies.max.y()));
  }
}

bool is_oblique(const Flaw& slot) {
  const double quarters = slot.angle / 90.0;
  return std::abs(quarters - std::round(quarters)) * 90.0 > kAngleTolerance;
}

/// Particles fill a box from its lower corner and end up to half a pitch off its upper edge.
std::vector<std::string> warn_of_uneven_boxes(const Case& settings) {
  std::vector<std::string> warnings;
  for (std::size_t i = 0; i < settings.bodies.size(); ++i) {
    const Body& body = settings.bodies[i];
    const double pitch = settings.grid.cell_size / body.particles_per_cell;
    for (int axis = 0; axis < 2 && body.shape == BodyShape::box; ++axis) {
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

std::vector<std::string> warn_of_oblique_slots(const Case& settings) {
  std::vector<std::string> warnings;
  const double cell = settings.grid.cell_size;
  for (std::size_t i = 0; i < settings.flaws.size(); ++i) {
    const Flaw& flaw = settings.flaws[i];
    const bool narrow = flaw.width < (kCellsAcrossObliqueSlot - kGridTolerance) * cell;
    if (flaw.shape == FlawShape::slot && narrow && is_oblique(flaw)) {
      warnings.push_back(complaint(
          settings.source, fmt::format("flaw[{}].width", i),
          fmt::format("an oblique slot {:.4g} cells across still carries load (at two cells, 27 % "
                      "of a 45 degree slot's compliance is missing); better three cells, {:.6g} m",
                      flaw.width / cell, kCellsAcrossObliqueSlot * cell)));
    }
  }
  return warnings;
}

void check_particles_left(const Case& settings) {
  for (std::size_t i = 0; i < settings.bodies.size(); ++i) {
    const Body& body = settings.bodies[i];
    const bool left = any_lattice_point(
        settings, body, [&](const Vector& point) { return is_rock(settings, body, point); });
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
  for (std::string& warning : warn_of_oblique_slots(settings)) {
    warnings.push_back(std::move(warning));
  }
  return warnings;
}

}  // namespace rgimp
