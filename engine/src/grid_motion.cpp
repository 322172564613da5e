#include "grid_motion.hpp"

#include <cmath>

#include "platen_geometry.hpp"
#include "platens.hpp"

namespace rgimp {

GridMotion::GridMotion(const Case& settings, const GridExtent& start) : start_(start) {
  const Box specimen = bounds(settings);
  for (std::size_t a = 0; a < axes_.size(); ++a) {
    const auto i = static_cast<Eigen::Index>(a);
    axes_[a].cells_below = std::round((specimen.min[i] - start.origin[i]) / start.spacing[i]);
    axes_[a].cells_between = std::round((specimen.max[i] - specimen.min[i]) / start.spacing[i]);
  }
  for (const Platen& platen : settings.platens) {
    const PlatenAxis side = axis_of(platen.side);
    Axis& axis = axes_[static_cast<std::size_t>(side.axis)];
    (side.towards > 0.0 ? axis.low : axis.high) = platen;
  }
}

GridExtent GridMotion::at(double time) const {
  GridExtent extent = start_;
  for (std::size_t a = 0; a < axes_.size(); ++a) {
    const Axis& axis = axes_[a];
    const auto i = static_cast<Eigen::Index>(a);
    const double low = axis.low ? platen_travel(*axis.low, time) : 0.0;
    const double high = axis.high ? platen_travel(*axis.high, time) : 0.0;
    if (axis.low && axis.high) {
      const double shrinkage = (low + high) / axis.cells_between;
      extent.spacing[i] -= shrinkage;
      extent.origin[i] += low + axis.cells_below * shrinkage;
    } else {
      extent.origin[i] += low - high;
    }
  }
  return extent;
}

}  // namespace rgimp
