#pragma once

#include <array>
#include <optional>

#include "geometry.hpp"
#include "rgimp/case.hpp"

namespace rgimp {

/// Where the grid lies in time. It follows the platens: the node rows on the specimen's ends at the
/// start stay on the platens, so that end cells stay full however far platens travel. Between two
/// opposed platens the spacing along their axis changes; with a platen on one end only, the grid
/// moves along, so a body that does not may run out of it; axes without platens stay. A particle's
/// half size is a share of a cell and changes with the spacing; the viscosity's L and dt stay those
/// of the start. A specimen pulled apart gets ever longer cells.
///
/// With rows fixed in space the end cell lost the platen's travel t and its stress rose by t / L:
/// a block without flaws was 6 % too weak at 0.064 L.
class GridMotion {
 public:
  GridMotion(const Case& settings, const GridExtent& start);

  /// A function of time alone, and `start` to the bit while no platen has moved.
  GridExtent at(double time) const;

 private:
  /// The platens on one axis, and the number of cells from its first node to the specimen.
  struct Axis {
    std::optional<Platen> low;
    std::optional<Platen> high;
    double cells_below = 0.0;
    double cells_between = 0.0;
  };

  GridExtent start_;
  std::array<Axis, 3> axes_;
};

}  // namespace rgimp
