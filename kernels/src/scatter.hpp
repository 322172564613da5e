#pragma once

#include "p2g_2d.hpp"
#include "p2g_3d.hpp"

namespace rgimp::kernels {
namespace {

/// Scatters the contents named, group by group along rows of bins, into `field` (in the order of
/// the contents).
template <int Dim, Content... Whats>
class Scatter {
 public:
  static constexpr int kCount = (kFields<Dim, Whats> + ...);

  Scatter(const ParticleView<Dim>& particles, const ShapeConstants<Dim>& shape,
          double* const (&field)[kCount])
      : particles_(particles), shape_(shape) {
    for (int f = 0; f < kCount; ++f) {
      field_[f] = field[f];
    }
  }

  /// The first group of a row that holds particles. Unless it is the row's first, its lowest nodes
  /// belong to the group before.
  void begin_row() {
    for (auto& row : carry_) {
      for (auto& upper : row) {
        Batch(0.0).store_aligned(upper.lane);
      }
    }
  }

  /// Finds the terms of a batch of lanes of a round of slots.
  void find(const GroupPlace<Dim>& place, Slots round, int part) {
    const BinOffsets<Dim> offsets = place.offsets(shape_, part);
    for (std::size_t slot = round.first; slot < round.last; ++slot) {
      find_terms<Whats...>(particles_, slot * kGroupWidth + part * kLanes, offsets, shape_,
                           terms_[part][slot - round.first]);
    }
  }

  /// The terms of all slots must be there if they fit in a round; else they are found here.
  void sum_group(const GroupPlace<Dim>& place, Slots slots) {
    if constexpr (Dim == 2) {
      for (int row = 0; row < 3; ++row) {
        int first_field = 0;
        ((sum_row<Whats>(place, slots, row, first_field), first_field += kFields<2, Whats>), ...);
      }
    } else {
      int first_field = 0;
      ((sum_rows<Whats>(place, slots, first_field), first_field += kFields<3, Whats>), ...);
    }
  }

  /// What the last group gave to the node beyond it.
  void end_row(const GroupPlace<Dim>& beyond) {
    for (int f = 0; f < kCount; ++f) {
      double given[kNeighbourRows<Dim>];
      for (int row = 0; row < kNeighbourRows<Dim>; ++row) {
        given[row] = carry_[row][f].lane[kLanes - 1];
      }
      if constexpr (Dim == 3) {
        take_off_shared(given);
      }
      for (int row = 0; row < kNeighbourRows<Dim>; ++row) {
        field_[f][beyond.first_node + beyond.row_offset[row]] += given[row];
      }
    }
  }

 private:
  /// One row in the plane.
  template <Content What>
  void sum_row(const GroupPlace<2>& place, Slots slots, int row, int first_field) {
    Sums<kFields<2, What>> sums[kParts];
    for (int part = 0; part < kParts; ++part) {
      Sums<kFields<2, What>> sum;  // by itself: of an array it would not stay in registers
      for_each_term(place, slots, part,
                    [&](const Terms<2>& terms) { add_slot<What>(terms, row, sum); });
      sums[part] = sum;
    }
#pragma GCC unroll 4
    for (int f = 0; f < kFields<2, What>; ++f) {
      double* const node = field_[first_field + f] + place.first_node + place.row_offset[row];
      Batch onto[kParts];
      double below;
      shift_onto_nodes<What != Content::force>(sums, f, carry_[row][first_field + f].lane, onto,
                                               below);
      add_to(node, onto);
      if (place.index[0] > 0) {
        node[-1] += below;
      }
    }
  }

  /// The nine rows in space.
  template <Content What>
  void sum_rows(const GroupPlace<3>& place, Slots slots, int first_field) {
    constexpr int kFieldCount = kFields<3, What>;
    const double* ahead[kFieldCount];
    for (int f = 0; f < kFieldCount; ++f) {
      ahead[f] = field_[first_field + f];
    }
    fetch_ahead(ahead, place);
    Batch onto[kFieldCount][kParts][9];
    double below[kFieldCount][9];
    const auto sum_row = [&]<int Row>() {
      Sums<kFieldCount> sums[kParts];
      for (int part = 0; part < kParts; ++part) {
        Sums<kFieldCount> sum;
        for_each_term(place, slots, part,
                      [&](const Terms<3>& terms) { add_slot<What, Row>(terms, sum); });
        sums[part] = sum;
      }
#pragma GCC unroll 4
      for (int f = 0; f < kFieldCount; ++f) {
        Batch shifted[kParts];
        shift_onto_nodes<false>(sums, f, carry_[Row][first_field + f].lane, shifted, below[f][Row]);
        for (int part = 0; part < kParts; ++part) {
          onto[f][part][Row] = shifted[part];
        }
      }
    };
    [&]<int... Rows>(Sequence<Rows...>) {
      (sum_row.template operator()<Rows>(), ...);
    }
    (NineRows{});
    for (int f = 0; f < kFieldCount; ++f) {
      put_down(onto[f], below[f], place, field_[first_field + f] + place.first_node);
    }
  }

  void put_down(Batch (&onto)[kParts][9], double (&below)[9], const GroupPlace<3>& place,
                double* node) {
    for (int part = 0; part < kParts; ++part) {
      take_off_shared(onto[part]);
#pragma GCC unroll 9
      for (int row = 0; row < 9; ++row) {
        double* const at = node + place.row_offset[row] + part * kLanes;
        (Batch::load_aligned(at) + onto[part][row]).store_aligned(at);
      }
    }
    if (place.index[0] > 0) {
      take_off_shared(below);
      for (int row = 0; row < 9; ++row) {
        node[place.row_offset[row] - 1] += below[row];
      }
    }
  }

  /// Calls visit(terms) for the slots of a group; those of several rounds are found anew.
  template <typename Visit>
  void for_each_term(const GroupPlace<Dim>& place, Slots slots, int part, Visit visit) {
    if (slots.count() <= kRound<Dim>) {
      for (std::size_t s = 0; s < slots.count(); ++s) {
        visit(terms_[part][s]);
      }
      return;
    }
    for_each_round<Dim>(slots, [&](Slots round) {
      find(place, round, part);
      for (std::size_t s = 0; s < round.count(); ++s) {
        visit(terms_[part][s]);
      }
    });
  }

  ParticleView<Dim> particles_;
  ShapeConstants<Dim> shape_;
  double* field_[kCount];
  Terms<Dim> terms_[kParts][kRound<Dim>];
  Lanes carry_[kNeighbourRows<Dim>][kCount];
};

}  // namespace
}  // namespace rgimp::kernels
