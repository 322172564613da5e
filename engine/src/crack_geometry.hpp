#pragma once

#include <optional>
#include <string>
#include <vector>

#include "rgimp/case.hpp"

/// Where cracks can start and end in a case.
namespace rgimp {

/// A place of a flaw that cracks are told apart by.
struct CrackSource {
  std::string name;
  std::size_t flaw = 0;
  Vector position = Vector::Zero();  ///< m
  bool is_tip = false;               ///< of a slot
};

/// Of a case of two dimensions.
std::vector<CrackSource> crack_sources(const Case& settings);

/// m, from the flaw's surface; negative inside.
double distance_to(const Flaw& flaw, const Vector& point);

/// The side of the bodies within `reach` m of a point inside them, the nearest if there are
/// several; a side that lies against another body does not count.
std::optional<Side> side_within(const Case& settings, const Vector& point, double reach);

}  // namespace rgimp
