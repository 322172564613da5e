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

/// A flaw's own axes, unit vectors: along its length, across its width, along its depth.
struct FlawFrame {
  Vector along;
  Vector across;
  Vector deep;
};

FlawFrame frame_of(const Flaw& flaw);

/// Without an end along the axes that the flaw goes all through.
Box bounds(const Flaw& flaw);

/// A flaw prepared for many points. Refers to the flaw.
class Hole {
 public:
  explicit Hole(const Flaw& flaw) : flaw_(flaw), frame_(frame_of(flaw)) {}

  bool contains(const Vector& point, double tolerance) const;

 private:
  bool contains_in_slot(const Vector& offset, double tolerance) const;

  const Flaw& flaw_;
  FlawFrame frame_;
};

/// m, how far a point is from the body's nearest face; in a box in two dimensions 0 at most, as
/// its front and back are there. Negative outside.
double depth_inside(const Body& body, const Vector& point);

/// The edge belongs to the body and not to the flaw: a point on either edge is rock.
bool contains(const Body& body, const Vector& point, double tolerance);
bool contains(const Flaw& flaw, const Vector& point, double tolerance);

/// What the flaws leave of a body. Refers to both.
class Rock {
 public:
  Rock(const Case& settings, const Body& body);

  /// Whether a particle at `point` of the body's lattice exists: in the body and in no flaw.
  bool contains(const Vector& point) const;

 private:
  const Body& body_;
  double tolerance_;
  std::vector<Hole> holes_;
};

/// The grid before its upper corner is rounded up to whole cells.
Box grid_box(const Case& settings);

/// Cell-centred points in a body's bounding box, the first half a pitch from its lower corner.
class Lattice {
 public:
  Lattice(const Case& settings, const Body& body);

  double pitch() const { return pitch_; }
  std::int64_t columns() const { return count_[0]; }
  std::int64_t rows() const { return count_[1]; }
  std::int64_t planes() const { return count_[2]; }
  /// From `first` to before `last`.
  struct Range {
    std::int64_t first;
    std::int64_t last;
  };
  /// Indices along an axis of all points in `part`, and perhaps a few more.
  Range range(int axis, const Box& part) const;
  Vector point(std::int64_t column, std::int64_t row, std::int64_t plane) const;

 private:
  Vector corner_;
  double pitch_;
  std::array<std::int64_t, 3> count_{1, 1, 1};
  Vector first_ = Vector::Zero();  // in pitches from the corner; 0 along z in two dimensions
};

}  // namespace rgimp
