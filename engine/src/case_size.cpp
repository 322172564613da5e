#include "case_size.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "grid.hpp"
#include "particles.hpp"
#include "shapes.hpp"

namespace rgimp {
namespace {

/// Libraries, threads and their stacks: a run of a hundred particles.
constexpr double kProcessBytes = 20.0 * 1024.0 * 1024.0;
/// A snapshot in memory is 138 bytes a particle; its columns are copied one by one from a table, of
/// which the largest, stress, is there twice.
constexpr double kSnapshotBytes = 138.0 + 48.0;

/// m3 (2D: m2).
double volume(const Body& body, int dimension) {
  const double radius = 0.5 * body.size.x();
  switch (body.shape) {
    case BodyShape::box:
      break;
    case BodyShape::disk:
      return std::numbers::pi * radius * radius;
    case BodyShape::cylinder:
      return std::numbers::pi * radius * radius * body.size.y();
    case BodyShape::sphere:
      return 4.0 / 3.0 * std::numbers::pi * radius * radius * radius;
  }
  const double area = body.size.x() * body.size.y();
  return dimension == 3 ? area * body.size.z() : area;
}

/// m2 (2D: m), of the body seen along x, the direction of rows.
double shadow(const Body& body, int dimension) {
  const double diameter = body.size.x();
  switch (body.shape) {
    case BodyShape::box:
      break;
    case BodyShape::disk:
      return diameter;
    case BodyShape::cylinder: {
      const double cosine = std::abs(body.axis.normalized().x());
      return 0.25 * std::numbers::pi * diameter * diameter * cosine +
             diameter * body.size.y() * std::sqrt(1.0 - cosine * cosine);
    }
    case BodyShape::sphere:
      return 0.25 * std::numbers::pi * diameter * diameter;
  }
  return dimension == 3 ? body.size.y() * body.size.z() : body.size.y();
}

/// Lanes over particles of equal rows of `cells`, which start on a group and lie in one bin more,
/// the first and the last of which hold half as many particles as the others.
double padding_of_equal_rows(double cells) {
  constexpr double kGroup = kernels::kGroupWidth;
  const double whole = std::ceil(cells - kGridTolerance);
  const double rest = std::fmod(whole, kGroup);
  return (whole - rest + (rest == 0.0 ? 0.5 * kGroup : kGroup)) / cells;
}

/// Of rows of `cells` on average that start and end anywhere in a group.
double padding_of_unequal_rows(double cells) {
  return (cells + kernels::kGroupWidth - 1.0) / cells;
}

void add_body(const Case& settings, const Body& body, CaseSize& size) {
  const double cell = settings.grid.cell_size;
  const Box box = bounds(body);
  const double row = volume(body, settings.dimension) / shadow(body, settings.dimension);
  const bool rows_are_equal = row > (box.max.x() - box.min.x()) * (1.0 - kGridTolerance);
  const double pitch = cell / body.particles_per_cell;
  const double particles = volume(body, settings.dimension) / std::pow(pitch, settings.dimension);
  size.particles += particles;
  size.lanes += particles * (rows_are_equal ? padding_of_equal_rows(row / cell)
                                            : padding_of_unequal_rows(row / cell));
}

template <int Dim>
double state_bytes(const Case& settings, const CaseSize& size) {
  const bool softens =
      std::any_of(settings.materials.begin(), settings.materials.end(), [](auto& entry) {
        const auto& failure = entry.second.failure;
        return failure && failure->fracture_energy + failure->shear_fracture_energy > 0.0;
      });
  const double lane = Particles<Dim>::kLaneBytes + (softens ? sizeof(double) : 0);
  return size.lanes * lane + size.particles +
         size.padded_nodes * Grid<Dim>::kFields * sizeof(double);
}

}  // namespace

CaseSize estimate_size(const Case& settings) {
  CaseSize size;
  const Box grid = grid_box(settings);
  size.nodes = 1.0;
  size.padded_nodes = 1.0;
  for (int axis = 0; axis < settings.dimension; ++axis) {
    const double nodes =
        std::ceil(std::abs(grid.max[axis] - grid.min[axis]) / settings.grid.cell_size -
                  kGridTolerance) +
        1.0;
    const double group = axis == 0 ? kernels::kGroupWidth : 1.0;
    size.nodes *= nodes;
    size.padded_nodes *= std::ceil(nodes / group) * group;
  }
  for (const Body& body : settings.bodies) {
    add_body(settings, body, size);
  }
  size.state_bytes =
      settings.dimension == 3 ? state_bytes<3>(settings, size) : state_bytes<2>(settings, size);
  return size;
}

double peak_bytes(double state_bytes, double particles) {
  return kProcessBytes + state_bytes + std::max(kSnapshotBytes * particles, state_bytes);
}

}  // namespace rgimp
