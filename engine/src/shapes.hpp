#pragma once

#include <array>
#include <cstdint>
#include <numbers>

#include "geometry.hpp"

/// Points against the shapes of a case, and the lattice that particles sit on.
namespace rgimp {

/// How much of a cell round-off may move a point across an edge.
inline constexpr double kEdgeTolerance = 1e-9;
/// How far from a grid line, in cells, an edge may be and still count as on it.
inline constexpr double kGridTolerance = 1e-6;
inline constexpr double kRadiansPerDegree = std::numbers::pi / 180.0;

Box bounds(const Flaw& flaw);

/// The edge belongs to the body and not to the flaw: a point on either edge is rock.
bool contains(const Body& body, const Vector& point, double tolerance);
bool contains(const Flaw& flaw, const Vector& point, double tolerance);

/// Whether a particle at `point` of the body's lattice exists: in the body and in no flaw.
bool is_rock(const Case& settings, const Body& body, const Vector& point);

/// The grid before its upper corner is rounded up to whole cells.
Box grid_box(const Case& settings);

/// Cell-centred points in a body's bounding box, the first half a pitch from its lower corner.
class Lattice {
 public:
  Lattice(const Body& body, double cell_size);

  double pitch() const { return pitch_; }
  std::int64_t columns() const { return count_[0]; }
  std::int64_t rows() const { return count_[1]; }
  Vector point(std::int64_t column, std::int64_t row) const;

 private:
  Vector corner_;
  double pitch_;
  std::array<std::int64_t, 2> count_;
};

}  // namespace rgimp
