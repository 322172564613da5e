#include "geometry.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "case_error.hpp"
#include "rgimp/kernels/views.hpp"
#include "shapes.hpp"

namespace rgimp {
namespace {

constexpr double kDefaultMargin = 5.0;  // cells between the bodies and the edge of the grid
/// Before the bodies along x a whole group of bins: their first bin is then a group's first lane
/// and fewer lanes stay empty (1.13 lanes a particle in example 1 with 5 cells, 1.05 with 8).
constexpr double kDefaultMarginBefore = kernels::kGroupWidth;

std::uint8_t material_index(const Case& settings, std::size_t body) {
  const auto found = settings.materials.find(settings.bodies[body].material);
  if (found == settings.materials.end()) {
    refuse(settings.source, fmt::format("body[{}].material", body), "no such material");
  }
  return static_cast<std::uint8_t>(std::distance(settings.materials.begin(), found));
}

/// Of all bodies; at least as many as there are particles.
std::size_t lattice_points(const Case& settings) {
  std::int64_t points = 0;
  for (const Body& body : settings.bodies) {
    const Lattice lattice(settings, body);
    points += lattice.columns() * lattice.rows() * lattice.planes();
  }
  return static_cast<std::size_t>(points);
}

}  // namespace

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

Box grid_box(const Case& settings) {
  const Box bodies = bounds(settings);
  const double margin = kDefaultMargin * settings.grid.cell_size;
  const double before = kDefaultMarginBefore * settings.grid.cell_size;
  const double depth = settings.dimension == 3 ? margin : 0.0;
  return {settings.grid.min.value_or(bodies.min - Vector(before, margin, depth)),
          settings.grid.max.value_or(bodies.max + Vector(margin, margin, depth))};
}

GridExtent grid_extent(const Case& settings) {
  const Box box = grid_box(settings);
  GridExtent extent;
  extent.spacing = Vector::Constant(settings.grid.cell_size);
  extent.origin = box.min;
  extent.nodes = {1, 1, 1};
  for (int axis = 0; axis < settings.dimension; ++axis) {
    const double cells = (box.max[axis] - box.min[axis]) / extent.spacing[axis];
    extent.nodes[static_cast<std::size_t>(axis)] =
        static_cast<std::int64_t>(std::ceil(cells - kGridTolerance)) + 1;
  }
  return extent;
}

std::vector<ParticleSeed> seed_particles(const Case& settings) {
  std::vector<ParticleSeed> seeds;
  seeds.reserve(lattice_points(settings));  // growing would take half as much again
  for (std::size_t b = 0; b < settings.bodies.size(); ++b) {
    const Body& body = settings.bodies[b];
    const Lattice lattice(settings, body);
    const Rock rock(settings, body);
    ParticleSeed seed;
    seed.material = material_index(settings, b);
    seed.velocity = body.velocity;
    seed.volume =
        lattice.pitch() * lattice.pitch() * (settings.dimension == 3 ? lattice.pitch() : 1.0);
    seed.mass = settings.materials.at(body.material).density * seed.volume;
    for (std::int64_t plane = 0; plane < lattice.planes(); ++plane) {
      for (std::int64_t row = 0; row < lattice.rows(); ++row) {
        for (std::int64_t column = 0; column < lattice.columns(); ++column) {
          seed.position = lattice.point(column, row, plane);
          if (rock.contains(seed.position)) {
            seeds.push_back(seed);
          }
        }
      }
    }
  }
  return seeds;
}

}  // namespace rgimp
