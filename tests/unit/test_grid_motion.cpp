#include <catch2/catch.hpp>

#include "grid_motion.hpp"
#include "models.hpp"

namespace rgimp::tests {
namespace {

double node(const GridExtent& extent, int axis, double index) {
  return extent.origin[axis] + index * extent.spacing[axis];
}

Case between(double top, double bottom) {
  Case settings = compressed_block(5.0, 10.0, 0.0);  // 5 cells below, 20 along the load
  settings.platens[0].speed = top;
  settings.platens[1].speed = bottom;
  return settings;
}

}  // namespace

TEST_CASE("the rows on the ends stay on two platens, with a grid that the case places too") {
  for (const bool placed : {false, true}) {
    for (const double top : {0.5, -0.3}) {
      Case settings = between(top, 0.2);
      double first = 5.0;
      if (placed) {
        settings.grid.min = Vector(-8e-3, -9e-3, 0.0);
        first = 8.0;
      }
      const GridExtent start = grid_extent(settings);
      const GridExtent later = GridMotion(settings, start).at(1e-4);
      CHECK(node(later, 1, first) == Approx(-5e-3 + 0.2 * 9e-5).epsilon(1e-13));
      CHECK(node(later, 1, first + 20.0) == Approx(5e-3 - top * 9e-5).epsilon(1e-13));
      CHECK(later.origin.x() == start.origin.x());
      CHECK(later.spacing.x() == start.spacing.x());
      CHECK(later.nodes == start.nodes);
    }
  }
}

TEST_CASE("in space the grid follows the platens of every axis by itself") {
  Case settings = free_block_in_space(Vector(5.0, 10.0, 4.0));
  for (const auto& [side, speed] :
       {std::pair(Side::left, 0.1), std::pair(Side::right, 0.2), std::pair(Side::top, 0.5),
        std::pair(Side::back, -0.3), std::pair(Side::front, 0.4)}) {
    settings.platens.push_back(holding(side));
    settings.platens.back().speed = speed;
  }
  const GridExtent start = grid_extent(settings);
  const GridExtent later = GridMotion(settings, start).at(1e-4);
  CHECK(node(later, 0, 8.0) == Approx(-2.5e-3 + 0.1 * 1e-4).epsilon(1e-13));
  CHECK(node(later, 0, 18.0) == Approx(2.5e-3 - 0.2 * 1e-4).epsilon(1e-13));
  CHECK(later.spacing.y() == start.spacing.y());  // a platen on one end alone
  CHECK(node(later, 1, 25.0) == Approx(5e-3 - 0.5 * 1e-4).epsilon(1e-13));
  CHECK(node(later, 2, 5.0) == Approx(-2e-3 - 0.3 * 1e-4).epsilon(1e-13));
  CHECK(node(later, 2, 13.0) == Approx(2e-3 - 0.4 * 1e-4).epsilon(1e-13));
  CHECK(later.nodes == start.nodes);
}

TEST_CASE("with a platen on one end the grid moves along, and its spacing stays") {
  Case settings = between(0.5, 0.0);
  settings.platens.pop_back();
  const GridExtent start = grid_extent(settings);
  const GridExtent later = GridMotion(settings, start).at(1e-4);
  CHECK(later.origin.y() == Approx(start.origin.y() - 0.5 * 9e-5).epsilon(1e-13));
  CHECK(later.spacing == start.spacing);
}

TEST_CASE("without a platen that moves the grid is that of the start to the bit") {
  const Case settings = between(0.0, 0.0);
  const GridExtent start = grid_extent(settings);
  const GridExtent later = GridMotion(settings, start).at(1.0);
  CHECK(later.origin == start.origin);
  CHECK(later.spacing == start.spacing);
}

}  // namespace rgimp::tests
