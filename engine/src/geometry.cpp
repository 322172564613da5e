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

/// The particles of one body, by rows of its lattice. Refers to the case.
class BodySeeds {
 public:
  BodySeeds(const Case& settings, std::size_t index)
      : lattice_(settings, settings.bodies[index]), rock_(settings, settings.bodies[index]) {
    const Body& body = settings.bodies[index];
    seed_.material = material_index(settings, index);
    seed_.velocity = body.velocity;
    seed_.volume =
        lattice_.pitch() * lattice_.pitch() * (settings.dimension == 3 ? lattice_.pitch() : 1.0);
    seed_.mass = settings.materials.at(body.material).density * seed_.volume;
  }

  /// Of all planes.
  std::int64_t rows() const { return lattice_.rows() * lattice_.planes(); }
  /// At least as many as there are particles in so many rows.
  std::size_t points(std::int64_t rows) const {
    return static_cast<std::size_t>(rows * lattice_.columns());
  }

  void append(Lattice::Range rows, std::vector<ParticleSeed>& seeds) const {
    ParticleSeed seed = seed_;
    for (std::int64_t row = rows.first; row < rows.last; ++row) {
      for (std::int64_t column = 0; column < lattice_.columns(); ++column) {
        seed.position = lattice_.point(column, row % lattice_.rows(), row / lattice_.rows());
        if (rock_.contains(seed.position)) {
          seeds.push_back(seed);
        }
      }
    }
  }

 private:
  Lattice lattice_;
  Rock rock_;
  ParticleSeed seed_;  // but for its position
};

std::vector<BodySeeds> seeds_of_bodies(const Case& settings) {
  std::vector<BodySeeds> bodies;
  for (std::size_t index = 0; index < settings.bodies.size(); ++index) {
    bodies.emplace_back(settings, index);
  }
  return bodies;
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
  const std::vector<BodySeeds> bodies = seeds_of_bodies(settings);
  std::size_t points = 0;
  for (const BodySeeds& body : bodies) {
    points += body.points(body.rows());
  }
  std::vector<ParticleSeed> seeds;
  seeds.reserve(points);  // growing would take half as much again
  for (const BodySeeds& body : bodies) {
    body.append({0, body.rows()}, seeds);
  }
  return seeds;
}

SeedParts seed_particles(const Case& settings, Workers& workers) {
  constexpr std::size_t kPointsOfPart = 1 << 14;
  struct Part {
    const BodySeeds& body;
    Lattice::Range rows;
  };
  const std::vector<BodySeeds> bodies = seeds_of_bodies(settings);
  std::vector<Part> parts;
  for (const BodySeeds& body : bodies) {
    const auto rows =
        static_cast<std::int64_t>(1 + kPointsOfPart / std::max<std::size_t>(body.points(1), 1));
    for (std::int64_t first = 0; first < body.rows(); first += rows) {
      parts.push_back({body, {first, std::min(first + rows, body.rows())}});
    }
  }
  SeedParts seeds(parts.size());
  workers.for_each(std::ssize(parts), [&](std::ptrdiff_t index) {
    const auto [body, rows] = parts[static_cast<std::size_t>(index)];
    std::vector<ParticleSeed>& part = seeds[static_cast<std::size_t>(index)];
    part.reserve(body.points(rows.last - rows.first));
    body.append(rows, part);
  });
  return seeds;
}

}  // namespace rgimp
