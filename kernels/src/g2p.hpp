#pragma once

#include "shape.hpp"

/// G2P in coefficient form. About its bin's node a field is, along each axis with d the distance
/// in cells and t = clamp(d, -l, l),
///   f = f0 + d (f+ - f-) / 2 + q (f+ - 2 f0 + f-),   q = (t^2 + l^2) / 4l + |d - t| / 2,
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

/// Turns values at the lower, nearest and upper node into coefficients.
inline void to_coefficients(Batch& lower, Batch& nearest, Batch& upper) {
  const Batch difference = Batch(0.5) * (upper - lower);
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

/// The basis 1, d, q along an axis.
struct AxisBasis {
  Batch d;
  Batch q;
  Batch q_slope;  // per cell
};

template <int Dim>
inline AxisBasis axis_basis(Batch d, const ShapeConstants<Dim>& shape) {
  const Batch half(shape.half);
  const Batch core = xsimd::min(xsimd::max(d, -half), half);
  const Batch flank = xsimd::abs(d - core);
  AxisBasis basis;
  basis.d = d;
  basis.q = fused(Batch(0.5), flank,
                  fused(core * Batch(shape.per_quad_half), core, Batch(0.25 * shape.half)));
  basis.q_slope = core * Batch(shape.per_double_half);
  return basis;
}

template <int Dim>
struct Basis {
  AxisBasis axis[Dim];
};

template <int Dim>
inline Basis<Dim> basis_at(const ParticleView<Dim>& particles, std::size_t index,
                           const BinOffsets<Dim>& offsets, const ShapeConstants<Dim>& shape) {
  Basis<Dim> basis;
#pragma GCC unroll 3
  for (int a = 0; a < Dim; ++a) {
    basis.axis[a] = axis_basis(node_distance(particles, index, offsets, shape, a), shape);
  }
  return basis;
}

inline Batch along(const AxisBasis& b, Batch c0, Batch c1, Batch c2) {
  return fused(b.q, c2, fused(b.d, c1, c0));
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

/// Derivatives along x and y, per cell, of a field in the plane.
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

/// `value` where a lane holds a particle, 0 in padding. Padding must stay where it is: next to
/// nearly empty nodes, whose accelerations have no bound, it would fly off and overflow, and a
/// weight of zero does not undo an infinity.
template <int Dim>
inline Batch where_present(const ParticleView<Dim>& particles, std::size_t index, double value) {
  const auto present = Batch::load_aligned(particles.mass + index) > Batch(0.0);
  return xsimd::select(present, Batch(value), Batch(0.0));
}

/// A gathered field at a batch of particles.
template <int Dim>
struct Gathered {
  Batch value[Dim];
};

/// What becomes of a gathered acceleration: v += dt a.
template <int Dim>
class VelocityUpdate {
 public:
  VelocityUpdate(const ParticleView<Dim>& particles, double dt) : particles_(particles), dt_(dt) {}

  void begin_row() {}
  void end_row(std::ptrdiff_t) {}

  void put(std::size_t index, const Gathered<Dim>& acceleration, const Basis<Dim>&) {
    const Batch dt = where_present(particles_, index, dt_);
#pragma GCC unroll 3
    for (int a = 0; a < Dim; ++a) {
      double* velocity = particles_.velocity[a] + index;
      fused(dt, acceleration.value[a], Batch::load_aligned(velocity)).store_aligned(velocity);
    }
  }

 private:
  const ParticleView<Dim>& particles_;
  double dt_;
};

/// What becomes of a gathered velocity: x += dt v, and how far that took the row's particles.
template <int Dim>
class PositionUpdate {
 public:
  PositionUpdate(const ParticleView<Dim>& particles, const GridView<Dim>& grid, double dt,
                 Reach* by_row)
      : particles_(particles), dt_(dt), cells_per_metre_(1.0 / grid.cell_size), by_row_(by_row) {}

  void begin_row() {
    step2_ = Batch(0.0);
    distance_ = Batch(0.0);
  }

  void put(std::size_t index, const Gathered<Dim>& velocity, const Basis<Dim>& basis) {
    const Batch dt = where_present(particles_, index, dt_);
    Batch step2(0.0);
#pragma GCC unroll 3
    for (int a = 0; a < Dim; ++a) {
      double* position = particles_.position[a] + index;
      const Batch step = dt * velocity.value[a];
      (Batch::load_aligned(position) + step).store_aligned(position);
      step2 = fused(step, step, step2);
      const Batch distance = fused(step, Batch(cells_per_metre_), basis.axis[a].d);
      distance_ = xsimd::max(distance_, xsimd::abs(distance));
    }
    step2_ = xsimd::max(step2_, step2);
  }

  void end_row(std::ptrdiff_t row) {
    by_row_[row] = {largest(distance_), __builtin_sqrt(largest(step2_))};
  }

 private:
  static double largest(Batch values) {
    alignas(64) double lane[kLanes];
    values.store_aligned(lane);
    double most = 0.0;
    for (const double value : lane) {
      most = value > most ? value : most;
    }
    return most;
  }

  const ParticleView<Dim>& particles_;
  double dt_;
  double cells_per_metre_;
  Reach* by_row_;
  Batch step2_;  // m2
  Batch distance_;
};

template <int Dim, typename Update>
void gather_group(const ParticleView<Dim>& particles, const GroupPlace<Dim>& place,
                  const ShapeConstants<Dim>& shape, const double* const* field, Update& update) {
  const std::uint32_t* begin = particles.group_begin + place.first_node / kGroupWidth;
  for (int part = 0; part < kParts; ++part) {
    FieldCoefficients<Dim> c[Dim];
#pragma GCC unroll 3
    for (int a = 0; a < Dim; ++a) {
      c[a] = field_coefficients(field[a], place, part);
    }
    const BinOffsets<Dim> offsets = place.offsets(shape, part);
    for (std::size_t slot = begin[0]; slot < begin[1]; ++slot) {
      const std::size_t index = slot * kGroupWidth + part * kLanes;
      const Basis<Dim> basis = basis_at(particles, index, offsets, shape);
      Gathered<Dim> gathered;
#pragma GCC unroll 3
      for (int a = 0; a < Dim; ++a) {
        gathered.value[a] = value_at(c[a], basis);
      }
      update.put(index, gathered, basis);
    }
  }
}

/// Gathers a field at the particles of the bins, row by row [Eq. 6].
template <int Dim, typename Update>
void gather(const ParticleView<Dim>& particles, const GridView<Dim>& grid,
            const double* const* field, RowRange bins, Update update) {
  const ShapeConstants<Dim> shape(grid);
  for (std::ptrdiff_t row = bins.first; row < bins.last; ++row) {
    update.begin_row();
    for_each_group(particles, grid, row, [&](const GroupPlace<Dim>& place) {
      gather_group(particles, place, shape, field, update);
    });
    update.end_row(row);
  }
}

template <int Dim>
void gather_velocity(const ParticleView<Dim>& particles, const GridView<Dim>& grid, double dt,
                     RowRange bins) {
  gather(particles, grid, grid.force, bins, VelocityUpdate<Dim>(particles, dt));
}

template <int Dim>
void gather_position(const ParticleView<Dim>& particles, const GridView<Dim>& grid, double dt,
                     RowRange bins, Reach* by_row) {
  gather(particles, grid, grid.momentum, bins, PositionUpdate<Dim>(particles, grid, dt, by_row));
}

}  // namespace
}  // namespace rgimp::kernels
