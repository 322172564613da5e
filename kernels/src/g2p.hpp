#pragma once

#include "places.hpp"

/// G2P in coefficient form. About its bin's node a field is, along each axis with d the distance
/// in cells and t = clamp(d, -l, l),
///   f = f0 + h (f+ - f-) + q (f+ - 2 f0 + f-),   h = d / 2,   q = (t^2 + l^2) / 4l + |d - t| / 2,
/// which is the sum of Eq. 18 over the three nodes, so the coefficients of the tensor product
/// belong to the bin and are shared by the slots of a group.
namespace rgimp::kernels {
namespace {

template <int Dim>
constexpr int kCoefficients = Dim == 2 ? 9 : 27;

/// Coefficients of one field component; entry 3 (row) + k: power k along x, rows along y, then z.
template <int Dim>
struct FieldCoefficients {
  Batch value[kCoefficients<Dim>];
};

/// The coefficients of a vector field.
template <int Dim>
struct VectorCoefficients {
  FieldCoefficients<Dim> component[Dim];
};

/// Turns values at the lower, nearest and upper node into coefficients.
inline void to_coefficients(Batch& lower, Batch& nearest, Batch& upper) {
  const Batch difference = upper - lower;
  const Batch curvature = fused(Batch(-2.0), nearest, upper + lower);
  lower = nearest;
  nearest = difference;
  upper = curvature;
}

template <int Dim>
inline FieldCoefficients<Dim> field_coefficients(const double* field, const GroupPlace<Dim>& place,
                                                 int part) {
  FieldCoefficients<Dim> c;
#pragma GCC unroll 9
  for (int row = 0; row < kNeighbourRows<Dim>; ++row) {
    const double* node = field + place.first_node + place.row_offset[row] + part * kLanes;
    c.value[3 * row] = Batch::load_unaligned(node - 1);
    c.value[3 * row + 1] = Batch::load_aligned(node);
    c.value[3 * row + 2] = Batch::load_unaligned(node + 1);
    to_coefficients(c.value[3 * row], c.value[3 * row + 1], c.value[3 * row + 2]);
  }
  constexpr int kPlanes = Dim == 2 ? 1 : 3;
#pragma GCC unroll 3
  for (int plane = 0; plane < kPlanes; ++plane) {
#pragma GCC unroll 3
    for (int k = 0; k < 3; ++k) {
      Batch* line = c.value + 9 * plane + k;
      to_coefficients(line[0], line[3], line[6]);
    }
  }
  if constexpr (Dim == 3) {
#pragma GCC unroll 9
    for (int k = 0; k < 9; ++k) {
      to_coefficients(c.value[k], c.value[9 + k], c.value[18 + k]);
    }
  }
  return c;
}

template <int Dim>
inline void load_coefficients(const double* const* field, const GroupPlace<Dim>& place, int part,
                              VectorCoefficients<Dim>& c) {
#pragma GCC unroll 3
  for (int a = 0; a < Dim; ++a) {
    c.component[a] = field_coefficients(field[a], place, part);
  }
}

/// The basis 1, h, q along an axis.
struct AxisBasis {
  Batch h;
  Batch q;
  Batch q_slope;  // per two cells, as that of h is then 1
};

template <int Dim>
struct Basis {
  Basis(const Places<Dim>& places, const ShapeConstants<Dim>& shape) {
    const Batch per_quad_half(0.25 * shape.per_half);
    const Batch at_node(0.25 * shape.half);
#pragma GCC unroll 3
    for (int a = 0; a < Dim; ++a) {
      const AxisPlace& place = places.axis[a];
      const Batch flank = fused(Batch(0.5), place.above + place.below, at_node);
      axis[a].h = Batch(0.5) * place.d;
      axis[a].q = fused(place.core * per_quad_half, place.core, flank);
      axis[a].q_slope = place.core * Batch(shape.per_half);
    }
  }
  AxisBasis axis[Dim];
};

inline Batch along(const AxisBasis& b, Batch c0, Batch c1, Batch c2) {
  return fused(b.q, c2, fused(b.h, c1, c0));
}

inline Batch slope_along(const AxisBasis& b, Batch c1, Batch c2) {
  return fused(b.q_slope, c2, c1);
}

template <int Dim>
inline Batch value_at(const FieldCoefficients<Dim>& c, const Basis<Dim>& basis) {
  Batch row[kNeighbourRows<Dim>];
#pragma GCC unroll 9
  for (int j = 0; j < kNeighbourRows<Dim>; ++j) {
    row[j] = along(basis.axis[0], c.value[3 * j], c.value[3 * j + 1], c.value[3 * j + 2]);
  }
  if constexpr (Dim == 2) {
    return along(basis.axis[1], row[0], row[1], row[2]);
  } else {
    return along(basis.axis[2], along(basis.axis[1], row[0], row[1], row[2]),
                 along(basis.axis[1], row[3], row[4], row[5]),
                 along(basis.axis[1], row[6], row[7], row[8]));
  }
}

/// Derivatives along x and y, per two cells, of a field in the plane.
inline void gradient_at(const FieldCoefficients<2>& c, const Basis<2>& basis,
                        Batch (&gradient)[2]) {
  Batch row[3];
  Batch slope[3];
#pragma GCC unroll 3
  for (int j = 0; j < 3; ++j) {
    row[j] = along(basis.axis[0], c.value[3 * j], c.value[3 * j + 1], c.value[3 * j + 2]);
    slope[j] = slope_along(basis.axis[0], c.value[3 * j + 1], c.value[3 * j + 2]);
  }
  gradient[0] = along(basis.axis[1], slope[0], slope[1], slope[2]);
  gradient[1] = slope_along(basis.axis[1], row[1], row[2]);
}

/// Derivatives along x, y and z, each per two cells.
inline void gradient_at(const FieldCoefficients<3>& c, const Basis<3>& basis,
                        Batch (&gradient)[3]) {
  Batch value[3];
  Batch by_x[3];
  Batch by_y[3];
#pragma GCC unroll 3
  for (int k = 0; k < 3; ++k) {
    Batch row[3];
    Batch slope[3];
#pragma GCC unroll 3
    for (int j = 0; j < 3; ++j) {
      const Batch* line = c.value + 9 * k + 3 * j;
      row[j] = along(basis.axis[0], line[0], line[1], line[2]);
      slope[j] = slope_along(basis.axis[0], line[1], line[2]);
    }
    value[k] = along(basis.axis[1], row[0], row[1], row[2]);
    by_x[k] = along(basis.axis[1], slope[0], slope[1], slope[2]);
    by_y[k] = slope_along(basis.axis[1], row[1], row[2]);
  }
  gradient[0] = along(basis.axis[2], by_x[0], by_x[1], by_x[2]);
  gradient[1] = along(basis.axis[2], by_y[0], by_y[1], by_y[2]);
  gradient[2] = slope_along(basis.axis[2], value[1], value[2]);
}

}  // namespace
}  // namespace rgimp::kernels
