#pragma once

#include "places.hpp"

/// P2G of a group of bins. Eight bins side by side give, per field and node row, three rows of sums
/// in registers: for the nodes below, at and above them along x. Shifted onto the same nodes they
/// reach memory once a group, in whole aligned groups but for the one node the group shares with
/// the one before; overlapping unaligned read-modify-writes instead cost a prototype 6.4 ns a
/// particle against 2.5 (stores cannot be forwarded to such loads). What a slot adds to a row, and
/// how rows are put down, is particular to a dimension: p2g_2d.hpp, p2g_3d.hpp.
namespace rgimp::kernels {
namespace {

/// Which fields a scatter adds to.
enum class Content { mass_momentum, force, momentum };

template <int Dim, Content What>
constexpr int kFields = What == Content::mass_momentum ? Dim + 1 : Dim;

template <Content... Whats>
constexpr bool kScattersForce = ((Whats == Content::force) || ...);
template <Content... Whats>
constexpr bool kScattersMomentum = ((Whats != Content::force) || ...);

/// What a batch of particles gives to its nodes, before weights.
template <int Dim>
struct Terms;

/// Sums of fields for the nodes below, at and above a batch of bins along x.
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

/// One row of sums, as they lie in memory.
struct alignas(64) Lanes {
  double lane[kLanes];
};

/// Numbers for templates.
template <int... Values>
struct Sequence {};
using NineRows = Sequence<0, 1, 2, 3, 4, 5, 6, 7, 8>;

/// The sums of one field and node row that belong to the group's own nodes, and in `below` what
/// belongs to the node below them. `carry` is what the group before gives to this one, then what
/// this one gives to the next. Unless `Weighed`, the sums in the middle are what all three nodes
/// share.
template <bool Weighed, int Count>
inline void shift_onto_nodes(const Sums<Count> (&sums)[kParts], int f, double* carry,
                             Batch (&onto)[kParts], double& below) {
  Batch before = Batch::load_aligned(carry);
  for (int part = 0; part < kParts; ++part) {
    const Batch(&sum)[3] = sums[part].field[f];
    const Batch after =
        part + 1 < kParts ? sums[part + 1 < kParts ? part + 1 : part].field[f][0] : Batch(0.0);
    const Batch at = Weighed ? sum[1] : sum[1] - (sum[0] + sum[2]);
    onto[part] = (at + shift_up(before, sum[2])) + shift_down(sum[0], after);
    before = sum[2];
  }
  before.store_aligned(carry);
  below = first_lane(sums[0].field[f][0]);
}

inline void add_to(double* node, const Batch (&onto)[kParts]) {
  for (int part = 0; part < kParts; ++part) {
    double* const at = node + part * kLanes;
    (Batch::load_aligned(at) + onto[part]).store_aligned(at);
  }
}

}  // namespace
}  // namespace rgimp::kernels
