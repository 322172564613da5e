#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "case_check.hpp"
#include "case_error.hpp"
#include "case_names.hpp"
#include "platen_geometry.hpp"
#include "shapes.hpp"

namespace rgimp {
namespace {

constexpr double kSmallestMargin = 3.0;          // cells beyond the bodies, for weights and drift
constexpr double kMostNodes = 2147483648.0;      // 2^31
constexpr double kMostParticles = 4294967295.0;  // ids have 32 bits
// What a run takes at its height, while a snapshot is written: in space 210 of them are the state
// that steps go on from (2.1 million particles, measured); in the plane a tenth less.
constexpr double kBytesPerParticle = 440.0;
constexpr double kBytesPerNode = 140.0;
constexpr double kGibibyte = 1024.0 * 1024.0 * 1024.0;

double machine_memory() {
  return static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
}

double count_nodes(const Case& settings) {
  const Box box = grid_box(settings);
  double nodes = 1.0;
  for (int axis = 0; axis < settings.dimension; ++axis) {
    nodes *= std::abs(box.max[axis] - box.min[axis]) / settings.grid.cell_size + 1.0;
  }
  return nodes;
}

double count_lattice_points(const Case& settings) {
  double points = 0.0;
  for (const Body& body : settings.bodies) {
    const Box box = bounds(body);
    double of_body = 1.0;
    for (int axis = 0; axis < settings.dimension; ++axis) {
      of_body *=
          (box.max[axis] - box.min[axis]) / settings.grid.cell_size * body.particles_per_cell;
    }
    points += of_body;
  }
  return points;
}

/// Far from the origin positions are rounded too coarsely for cells: a moving particle would stand.
void check_distance(const Case& settings) {
  constexpr double kMostCells = 1e8;  // rounds positions to 1.5e-8 cells
  const Box bodies = bounds(settings);
  const double farthest =
      std::max(bodies.min.cwiseAbs().maxCoeff(), bodies.max.cwiseAbs().maxCoeff());
  if (farthest > kMostCells * settings.grid.cell_size) {
    ValueChecker(settings).refuse(
        "grid.cell_size",
        fmt::format("is {}, and the bodies reach {:.6g} m from the origin, where positions are "
                    "rounded too coarsely for such cells; expected {:.0e} cells at most",
                    settings.grid.cell_size, farthest, kMostCells));
  }
}

void check_margin(const Case& settings, const GridExtent& extent) {
  constexpr std::array<std::string_view, 3> kBelow{"left of", "below", "behind"};
  constexpr std::array<std::string_view, 3> kAbove{"right of", "above", "in front of"};
  const Box bodies = bounds(settings);
  const ValueChecker check(settings);
  for (int i = 0; i < settings.dimension; ++i) {
    const auto axis = static_cast<std::size_t>(i);
    const double cell = extent.spacing[i];
    const double last = extent.origin[i] + cell * static_cast<double>(extent.nodes[axis] - 1);
    const double below = (bodies.min[i] - extent.origin[i]) / cell;
    const double above = (last - bodies.max[i]) / cell;
    if (below < kSmallestMargin - kGridTolerance) {
      check.refuse("grid.min",
                   fmt::format("leaves {:.4g} cells {} the bodies; expected at least {}", below,
                               kBelow[axis], kSmallestMargin));
    }
    if (above < kSmallestMargin - kGridTolerance) {
      check.refuse("grid.max",
                   fmt::format("leaves {:.4g} cells {} the bodies; expected at least {}", above,
                               kAbove[axis], kSmallestMargin));
    }
  }
}

void check_on_grid_line(const Case& settings, const GridExtent& extent, std::size_t index) {
  constexpr std::array<std::string_view, 3> kAxis{"x", "y", "z"};
  constexpr std::array<std::string_view, 3> kSize{"width", "height", "depth"};
  const PlatenContact contact(settings.platens[index], bounds(settings));
  const int axis = contact.side.axis;
  const double cells = (contact.end - extent.origin[axis]) / extent.spacing[axis];
  if (std::abs(cells - std::round(cells)) <= kGridTolerance) {
    return;
  }
  const auto size_to_line = [&](double line) {
    return std::abs(extent.origin[axis] + line * extent.spacing[axis] - contact.opposite);
  };
  const double one = size_to_line(std::floor(cells));
  const double other = size_to_line(std::ceil(cells));
  refuse(settings.source, fmt::format("platen[{}].side", index),
         fmt::format("the bodies' {} end at {} = {:.6g} m is not on a grid line; expected a {} of "
                     "{:.6g} or {:.6g} m",
                     name_of(settings.platens[index].side), kAxis[axis], contact.end, kSize[axis],
                     std::min(one, other), std::max(one, other)));
}

/// A contact narrower than a cell may lie between two nodes and press on nothing.
void check_contact_nodes(const Case& settings, const GridExtent& extent, std::size_t index) {
  const PlatenContact contact(settings.platens[index], bounds(settings));
  const double origin = extent.origin[contact.across];
  const double spacing = extent.spacing[contact.across];
  const double nearest = origin + std::round((contact.center - origin) / spacing) * spacing;
  if (!contact.holds(nearest)) {
    refuse(settings.source, fmt::format("platen[{}].half_width", index),
           fmt::format("is {}, within which no grid node lies; expected at least {:.6g}",
                       *contact.half_width, std::abs(nearest - contact.center)));
  }
}

}  // namespace

// In real numbers, for what is refused here need not fit an integer.
void check_amount(const Case& settings, double machine_bytes) {
  const double nodes = count_nodes(settings);
  const double particles = count_lattice_points(settings);
  const ValueChecker check(settings);
  if (!(nodes <= kMostNodes)) {
    check.refuse("grid.cell_size",
                 fmt::format("makes {:.3g} nodes; expected at most {:.0f}", nodes, kMostNodes));
  }
  if (!(particles <= kMostParticles)) {
    check.refuse("grid.cell_size", fmt::format("makes {:.3g} particles; expected at most {:.0f}",
                                               particles, kMostParticles));
  }
  const double bytes = nodes * kBytesPerNode + particles * kBytesPerParticle;
  if (bytes > machine_bytes) {
    check.refuse(
        "grid.cell_size",
        fmt::format("makes {:.3g} nodes and {:.3g} particles, which take about {:.0f} GiB; "
                    "expected no more than this machine's {:.0f} GiB",
                    nodes, particles, bytes / kGibibyte, machine_bytes / kGibibyte));
  }
}

void check_grid(const Case& settings) {
  check_amount(settings, machine_memory());
  check_distance(settings);
  const GridExtent extent = grid_extent(settings);
  check_margin(settings, extent);
  for (std::size_t i = 0; i < settings.platens.size(); ++i) {
    check_on_grid_line(settings, extent, i);
    check_contact_nodes(settings, extent, i);
  }
}

}  // namespace rgimp
