#include <algorithm>
#include <array>
#include <cmath>

#include "case_check.hpp"
#include "case_error.hpp"
#include "case_names.hpp"
#include "case_size.hpp"
#include "machine_memory.hpp"
#include "platen_geometry.hpp"
#include "shapes.hpp"

namespace rgimp {
namespace {

constexpr double kSmallestMargin = 3.0;          // cells beyond the bodies, for weights and drift
constexpr double kMostNodes = 2147483648.0;      // 2^31
constexpr double kMostParticles = 4294967295.0;  // ids have 32 bits
constexpr double kGibibyte = 1024.0 * 1024.0 * 1024.0;

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
void check_amount(const Case& settings, std::optional<double> available_bytes) {
  const CaseSize size = estimate_size(settings);
  const double nodes = size.nodes;
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
  const double bytes = peak_bytes(size.state_bytes, size.particles);
  if (available_bytes && bytes > *available_bytes) {
    check.refuse(
        "grid.cell_size",
        fmt::format("makes {:.3g} nodes and {:.3g} particles, which take about {:.1f} GiB of "
                    "memory; expected no more than the {:.1f} GiB that are free here",
                    nodes, size.particles, bytes / kGibibyte, *available_bytes / kGibibyte));
  }
}

void check_grid(const Case& settings) {
  check_amount(settings, available_memory());
  check_distance(settings);
  const GridExtent extent = grid_extent(settings);
  check_margin(settings, extent);
  for (std::size_t i = 0; i < settings.platens.size(); ++i) {
    check_on_grid_line(settings, extent, i);
    check_contact_nodes(settings, extent, i);
  }
}

}  // namespace rgimp
