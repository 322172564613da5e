#pragma once

#include <optional>

#include "geometry.hpp"
#include "rgimp/case.hpp"

namespace rgimp {

/// Which way a platen moves and looks.
struct PlatenAxis {
  int axis;        ///< 0 x, 1 y, 2 z
  double towards;  ///< +1 or -1: direction of travel towards the specimen along the axis
};

PlatenAxis axis_of(Side side);

/// 0 x, 1 y, 2 z: the axis of the first moving platen, else of the first one; none without platens.
std::optional<int> load_axis(const Case& settings);

/// Where a platen touches the specimen: its end on the platen's side, or a part of it (in three
/// dimensions a strip).
struct PlatenContact {
  PlatenContact(const Platen& platen, const Box& specimen);

  /// Whether a node at `position` across the load is held; one on the contact's edge is.
  bool holds(double position) const;

  PlatenAxis side;
  int across;       ///< the axis that a half width is along: x, but y for left and right
  double end;       ///< m, of the specimen on the platen's side
  double opposite;  ///< m, its other end
  double center;    ///< m, across the load
  std::optional<double> half_width;  ///< m; none: the whole end
};

}  // namespace rgimp
