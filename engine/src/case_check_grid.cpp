#include <unistd.h>

#include <array>
#include <cmath>

#include "case_check.hpp"
#include "case_error.hpp"
#include "case_names.hpp"
#include "shapes.hpp"

namespace rgimp {
namespace {

constexpr double kSmallestMargin = 3.0;          // cells beyond the bodies, for weights and drift
constexpr double kMostNodes = 2147483648.0;      // 2^31
constexpr double kMostParticles = 4294967295.0;  // ids have 32 bits
// Roughly what the engine keeps, for telling a slip of the pen from a case that fits.
constexpr double kBytesPerParticle = 250.0;
constexpr double kBytesPerNode = 100.0;
constexpr double kGibibyte = 1024.0 * 1024.0 * 1024.0;
constexpr double kContactTolerance = 1e-9;  // m, as platens take the nodes of their half width

double machine_memory() {
  return static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
}

double count_nodes(const Case& settings) {
  const Box box = grid_box(settings);
  const Vector cells = (box.max - box.min) / settings.grid.cell_size;
  return (std::abs(cells.x()) + 1.0) * (std::abs(cells.y()) + 1.0);
}

double count_lattice_points(const Case& settings) {
  double points = 0.0;
  for (const Body& body : settings.bodies) {
    const Box box = bounds(body);
    const Vector pitches = (box.max - box.min) / settings.grid.cell_size * body.particles_per_cell;
    points += pitches.x() * pitches.y();
  }
  return points;
}

/// In real numbers, for what is refused here need not fit an integer.
void check_amount(const Case& settings) {
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
  if (bytes > machine_memory()) {
    check.refuse(
        "grid.cell_size",
        fmt::format("makes {:.3g} nodes and {:.3g} particles, which take about {:.0f} GiB; "
                    "expected no more than this machine's {:.0f} GiB",
                    nodes, particles, bytes / kGibibyte, machine_memory() / kGibibyte));
  }
}

void check_margin(const Case& settings, const GridExtent& extent) {
  constexpr std::array<std::string_view, 2> kBelow{"left of", "below"};
  constexpr std::array<std::string_view, 2> kAbove{"right of", "above"};
  const Box bodies = bounds(settings);
  const ValueChecker check(settings);
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const auto i = static_cast<Eigen::Index>(axis);
    const double cell = extent.cell_size;
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

/// The end of the bodies that a platen touches, along its axis.
struct Contact {
  Eigen::Index axis;
  double end;       // m
  double opposite;  // m
};

Contact contact_of(Side side, const Box& bodies) {
  switch (side) {
    case Side::top:
      return {1, bodies.max.y(), bodies.min.y()};
    case Side::bottom:
      return {1, bodies.min.y(), bodies.max.y()};
    case Side::left:
      return {0, bodies.min.x(), bodies.max.x()};
    case Side::right:
      return {0, bodies.max.x(), bodies.min.x()};
  }
  return {};
}

void check_on_grid_line(const Case& settings, const GridExtent& extent, std::size_t index) {
  const Side side = settings.platens[index].side;
  const Contact contact = contact_of(side, bounds(settings));
  const double cells = (contact.end - extent.origin[contact.axis]) / extent.cell_size;
  if (std::abs(cells - std::round(cells)) <= kGridTolerance) {
    return;
  }
  const auto size_to_line = [&](double line) {
    return std::abs(extent.origin[contact.axis] + line * extent.cell_size - contact.opposite);
  };
  const double one = size_to_line(std::floor(cells));
  const double other = size_to_line(std::ceil(cells));
  const bool vertical = contact.axis == 1;
  refuse(settings.source, fmt::format("platen[{}].side", index),
         fmt::format("the bodies' {} end at {} = {:.6g} m is not on a grid line; expected a {} of "
                     "{:.6g} or {:.6g} m",
                     name_of(side), vertical ? "y" : "x", contact.end,
                     vertical ? "height" : "width", std::min(one, other), std::max(one, other)));
}

/// A contact narrower than a cell may lie between two nodes and press on nothing.
void check_contact_nodes(const Case& settings, const GridExtent& extent, std::size_t index) {
  const Platen& platen = settings.platens[index];
  if (!platen.half_width) {
    return;
  }
  const Box bodies = bounds(settings);
  const Eigen::Index across = 1 - contact_of(platen.side, bodies).axis;
  const double center = 0.5 * (bodies.min[across] + bodies.max[across]);
  const double cells = (center - extent.origin[across]) / extent.cell_size;
  const double to_node = std::abs(cells - std::round(cells)) * extent.cell_size;
  if (to_node > *platen.half_width + kContactTolerance) {
    refuse(settings.source, fmt::format("platen[{}].half_width", index),
           fmt::format("is {}, within which no grid node lies; expected at least {:.6g}",
                       *platen.half_width, to_node));
  }
}

}  // namespace

void check_grid(const Case& settings) {
  check_amount(settings);
  const GridExtent extent = grid_extent(settings);
  check_margin(settings, extent);
  for (std::size_t i = 0; i < settings.platens.size(); ++i) {
    check_on_grid_line(settings, extent, i);
    check_contact_nodes(settings, extent, i);
  }
}

}  // namespace rgimp
