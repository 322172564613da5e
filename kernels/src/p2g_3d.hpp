#pragma once

#include "p2g.hpp"

/// What a slot gives to the nine node rows around its bins in space. Weights along an axis sum to
/// one and slopes to zero, so a row at the bins need not be weighed: what is summed there is what
/// all three rows of that axis share, and the two others are taken off once a group. Those at the
/// bins are the heavy ones, so nothing is lost, as it would be at nearly empty nodes. Of a slot's
/// 342 multiplications with all 27 nodes weighed, 274 are left.
namespace rgimp::kernels {
namespace {

/// Weights of the lower and upper node along an axis.
struct OuterWeights {
  Batch value[2];
  Batch slope[2];  // per cell along x; not along x, where `along` holds their products
};

template <>
struct Terms<3> {
  OuterWeights axis[3];
  Batch mass;
  Batch momentum[3];  // m v
  // With -(V sigma - V q I) / L along x [Eq. 10]:
  Batch along[3][2];   // its components along x times the slopes along x
  Batch across[3][2];  // its components along y and z
};

template <Content... Whats>
inline void find_terms(const ParticleView<3>& p, std::size_t index, const BinOffsets<3>& offsets,
                       const ShapeConstants<3>& shape, Terms<3>& terms) {
  const Places<3> places(p, index, offsets, shape);
  AxisWeights weights[3];
#pragma GCC unroll 3
  for (int a = 0; a < 3; ++a) {
    find_axis_weights(places.axis[a], shape, weights[a]);
#pragma GCC unroll 2
    for (int side = 0; side < 2; ++side) {
      terms.axis[a].value[side] = weights[a].value[2 * side];
      terms.axis[a].slope[side] = weights[a].slope[2 * side] * Batch(shape.aspect[a]);
    }
  }
  if constexpr (kScattersMomentum<Whats...>) {
    terms.mass = Batch::load_aligned(p.mass + index);
#pragma GCC unroll 3
    for (int a = 0; a < 3; ++a) {
      terms.momentum[a] = terms.mass * Batch::load_aligned(p.velocity[a] + index);
    }
  }
  if constexpr (kScattersForce<Whats...>) {
    const Batch volume = Batch::load_aligned(p.volume + index) * Batch(-shape.cells_per_metre[0]);
    const Batch viscous =
        Batch::load_aligned(p.viscous_energy + index) * Batch(shape.cells_per_metre[0]);
    Batch loaded[6];
#pragma GCC unroll 6
    for (int c = 0; c < 6; ++c) {
      const Batch stress = Batch::load_aligned(p.stress[c] + index);
      loaded[c] = c < 3 ? fused(volume, stress, viscous) : volume * stress;
    }
#pragma GCC unroll 3
    for (int a = 0; a < 3; ++a) {
#pragma GCC unroll 2
      for (int side = 0; side < 2; ++side) {
        terms.along[a][side] = loaded[kStressColumn[a][0]] * weights[0].slope[2 * side];
        terms.across[a][side] = loaded[kStressColumn[a][1 + side]];
      }
    }
  }
}

/// A node row by its place along y and z: 0 below the bins, 1 at them, 2 above.
template <int Row>
struct RowPlace {
  static constexpr int y = Row % 3;
  static constexpr int z = Row / 3;
  static constexpr bool kWeighsY = y != 1;
  static constexpr bool kWeighsZ = z != 1;
};

/// Weights along y and z of a row that is not at the bins.
template <int Row>
inline Batch row_weight(const Terms<3>& terms) {
  using Place = RowPlace<Row>;
  if constexpr (!Place::kWeighsZ) {
    return terms.axis[1].value[Place::y / 2];
  } else if constexpr (!Place::kWeighsY) {
    return terms.axis[2].value[Place::z / 2];
  } else {
    return terms.axis[1].value[Place::y / 2] * terms.axis[2].value[Place::z / 2];
  }
}

/// m S and m v S of one node row [Eq. 8, 9].
template <Content What, int Row>
inline void add_momentum(const Terms<3>& terms, Sums<kFields<3, What>>& sums) {
  constexpr int kFirst = What == Content::mass_momentum ? 1 : 0;
  Batch quantity[kFields<3, What>];
  if constexpr (What == Content::mass_momentum) {
    quantity[0] = terms.mass;
  }
#pragma GCC unroll 3
  for (int a = 0; a < 3; ++a) {
    quantity[kFirst + a] = terms.momentum[a];
  }
  const OuterWeights& x = terms.axis[0];
  if constexpr (Row == 4) {
#pragma GCC unroll 4
    for (int f = 0; f < kFields<3, What>; ++f) {
      sums.field[f][0] = fused(quantity[f], x.value[0], sums.field[f][0]);
      sums.field[f][1] = sums.field[f][1] + quantity[f];
      sums.field[f][2] = fused(quantity[f], x.value[1], sums.field[f][2]);
    }
  } else {
    const Batch weight = row_weight<Row>(terms);
    const Batch lower = weight * x.value[0];
    const Batch upper = weight * x.value[1];
#pragma GCC unroll 4
    for (int f = 0; f < kFields<3, What>; ++f) {
      sums.field[f][0] = fused(quantity[f], lower, sums.field[f][0]);
      sums.field[f][1] = fused(quantity[f], weight, sums.field[f][1]);
      sums.field[f][2] = fused(quantity[f], upper, sums.field[f][2]);
    }
  }
}

/// Factors of the components along y and z in one row.
template <int Row>
inline Batch across_of(const Terms<3>& terms, int a, Batch slope_y, Batch slope_z) {
  using Place = RowPlace<Row>;
  if constexpr (!Place::kWeighsZ) {
    return terms.across[a][0] * slope_y;
  } else if constexpr (!Place::kWeighsY) {
    return terms.across[a][1] * slope_z;
  } else {
    return fused(terms.across[a][0], slope_y, terms.across[a][1] * slope_z);
  }
}

/// -(V sigma - V q I) grad S of one node row [Eq. 10].
template <int Row>
inline void add_force(const Terms<3>& terms, Sums<3>& sums) {
  using Place = RowPlace<Row>;
  if constexpr (Row == 4) {
#pragma GCC unroll 3
    for (int a = 0; a < 3; ++a) {
      sums.field[a][0] = sums.field[a][0] + terms.along[a][0];
      sums.field[a][2] = sums.field[a][2] + terms.along[a][1];
    }
  } else {
    const OuterWeights& x = terms.axis[0];
    const OuterWeights& y = terms.axis[1];
    const OuterWeights& z = terms.axis[2];
    const Batch weight = row_weight<Row>(terms);
    Batch slope_y = y.slope[Place::y / 2];
    Batch slope_z = z.slope[Place::z / 2];
    if constexpr (Place::kWeighsY && Place::kWeighsZ) {
      slope_y = slope_y * z.value[Place::z / 2];
      slope_z = slope_z * y.value[Place::y / 2];
    }
#pragma GCC unroll 3
    for (int a = 0; a < 3; ++a) {
      const Batch across = across_of<Row>(terms, a, slope_y, slope_z);
      sums.field[a][0] =
          fused(terms.along[a][0], weight, fused(across, x.value[0], sums.field[a][0]));
      sums.field[a][1] = sums.field[a][1] + across;
      sums.field[a][2] =
          fused(terms.along[a][1], weight, fused(across, x.value[1], sums.field[a][2]));
    }
  }
}

template <Content What, int Row>
inline void add_slot(const Terms<3>& terms, Sums<kFields<3, What>>& sums) {
  if constexpr (What == Content::force) {
    add_force<Row>(terms, sums);
  } else {
    add_momentum<What, Row>(terms, sums);
  }
}

/// Takes the rows below and above off those that hold what all three share, along y, then z.
template <typename Value>
inline void take_off_shared(Value (&row)[9]) {
#pragma GCC unroll 3
  for (int z = 0; z < 9; z += 3) {
    row[z + 1] = row[z + 1] - (row[z] + row[z + 2]);
  }
#pragma GCC unroll 3
  for (int y = 0; y < 3; ++y) {
    row[3 + y] = row[3 + y] - (row[y] + row[6 + y]);
  }
}

}  // namespace
}  // namespace rgimp::kernels
