#pragma once

#include "shape.hpp"

/// How P2G sums reach memory. Eight bins side by side give three rows of sums: for the nodes below,
/// at and above them along x. They are shifted onto the same nodes with what the neighbouring
/// groups carry over, so that memory is read and written in whole aligned groups; overlapping
/// unaligned read-modify-writes instead cost a prototype 6.4 ns a particle against 2.5 (stores
/// cannot be forwarded to such loads).
namespace rgimp::kernels {
namespace {

/// Sums of a batch of bins for the nodes below, at and above them along x.
template <int Count>
struct Sums {
  Sums() {
#pragma GCC unroll 4
    for (int f = 0; f < Count; ++f) {
#pragma GCC unroll 3
      for (int k = 0; k < 3; ++k) {
        field[f][k] = Batch(0.0);
      }
    }
  }
  Batch field[Count][3];
};

/// One field of one node row for a group: what its bins add to the nodes below them along x, at
/// them (with the share of the bins before, once settled), and above them.
struct alignas(64) FieldSums {
  double lower[kGroupWidth];
  double settled[kGroupWidth];
  double upper[kGroupWidth];
};

/// Puts a batch's sums down: starts its own nodes, whose highest bins' share the batch before has,
/// and finishes those of the group before, whose last node still lacks this group's lowest share.
/// `node_before` is null where there is no group before.
inline void settle(const Batch (&sums)[3], int part, const FieldSums& before, FieldSums& here,
                   double* node_before) {
  const int lane = part * kLanes;
  sums[0].store_aligned(here.lower + lane);
  sums[2].store_aligned(here.upper + lane);
  const double* upper_before =
      part > 0 ? here.upper + lane - kLanes : before.upper + kGroupWidth - kLanes;
  (sums[1] + shift_up(Batch::load_aligned(upper_before), sums[2]))
      .store_aligned(here.settled + lane);
  if (node_before != nullptr) {
    const double* lower_after = part + 1 < kParts ? before.lower + lane + kLanes : here.lower;
    const Batch finished =
        Batch::load_aligned(before.settled + lane) +
        shift_down(Batch::load_aligned(before.lower + lane), Batch::load_aligned(lower_after));
    (Batch::load_aligned(node_before + lane) + finished).store_aligned(node_before + lane);
  }
}

}  // namespace
}  // namespace rgimp::kernels
