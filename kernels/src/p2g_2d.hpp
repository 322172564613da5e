#pragma once

#include "p2g.hpp"

/// What a slot gives to the three node rows around its bins in the plane.
namespace rgimp::kernels {
namespace {

template <>
struct Terms<2> {
  AxisWeights axis[2];
  Batch mass;
  Batch momentum[2];                   // m v
  Batch loaded[kStressComponents<2>];  // -(V sigma - V q I) / L along x [Eq. 10]; no zz
};

template <Content... Whats>
inline void find_terms(const ParticleView<2>& p, std::size_t index, const BinOffsets<2>& offsets,
                       const ShapeConstants<2>& shape, Terms<2>& terms) {
  const Places<2> places(p, index, offsets, shape);
#pragma GCC unroll 2
  for (int a = 0; a < 2; ++a) {
    find_axis_weights(places.axis[a], shape, terms.axis[a]);
  }
  if constexpr (kScattersMomentum<Whats...>) {
    terms.mass = Batch::load_aligned(p.mass + index);
#pragma GCC unroll 2
    for (int a = 0; a < 2; ++a) {
      terms.momentum[a] = terms.mass * Batch::load_aligned(p.velocity[a] + index);
    }
  }
  if constexpr (kScattersForce<Whats...>) {
    // Slopes per cell along x on both axes, so that `loaded` serves both.
#pragma GCC unroll 3
    for (Batch& slope : terms.axis[1].slope) {
      slope = slope * Batch(shape.aspect[1]);
    }
    const Batch volume = Batch::load_aligned(p.volume + index) * Batch(-shape.cells_per_metre[0]);
    const Batch viscous =
        Batch::load_aligned(p.viscous_energy + index) * Batch(shape.cells_per_metre[0]);
    for (const int c : {0, 1, 3}) {  // zz pulls at no node of the plane
      const Batch stress = Batch::load_aligned(p.stress[c] + index);
      terms.loaded[c] = c < 3 ? fused(volume, stress, viscous) : volume * stress;
    }
  }
}

inline void add_weighted(Batch value, const AxisWeights& x, Batch (&sums)[3]) {
#pragma GCC unroll 3
  for (int k = 0; k < 3; ++k) {
    sums[k] = fused(value, x.value[k], sums[k]);
  }
}

/// m S and m v S of one node row [Eq. 8, 9].
template <Content What>
inline void add_momentum(const Terms<2>& terms, int row, Sums<kFields<2, What>>& sums) {
  constexpr int kFirst = What == Content::mass_momentum ? 1 : 0;
  const Batch weight = terms.axis[1].value[row];
  if constexpr (What == Content::mass_momentum) {
    add_weighted(weight * terms.mass, terms.axis[0], sums.field[0]);
  }
#pragma GCC unroll 2
  for (int a = 0; a < 2; ++a) {
    add_weighted(weight * terms.momentum[a], terms.axis[0], sums.field[kFirst + a]);
  }
}

/// -(V sigma - V q I) grad S of one node row but for the nodes at the bins, which get the rest:
/// weights along x sum to one and slopes to zero, so sums.field[a][1] only collects what all three
/// nodes share (see at_nodes) [Eq. 10].
inline void add_force(const Terms<2>& terms, int row, Sums<2>& sums) {
  const Batch weight = terms.axis[1].value[row];
#pragma GCC unroll 2
  for (int a = 0; a < 2; ++a) {
    const Batch along = terms.loaded[kStressColumn[a][0]] * weight;
    const Batch across = terms.loaded[kStressColumn[a][1]] * terms.axis[1].slope[row];
    sums.field[a][1] = sums.field[a][1] + across;
#pragma GCC unroll 2
    for (int k = 0; k < 3; k += 2) {
      sums.field[a][k] = fused(along, terms.axis[0].slope[k],
                               fused(across, terms.axis[0].value[k], sums.field[a][k]));
    }
  }
}

template <Content What>
inline void add_slot(const Terms<2>& terms, int row, Sums<kFields<2, What>>& sums) {
  if constexpr (What == Content::force) {
    add_force(terms, row, sums);
  } else {
    add_momentum<What>(terms, row, sums);
  }
}

}  // namespace
}  // namespace rgimp::kernels
