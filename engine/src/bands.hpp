#pragma once

#include <algorithm>
#include <cstddef>

#include "rgimp/kernels/views.hpp"

namespace rgimp {

/// Cuts the grid into bands of layers (node rows in 2D, planes in 3D) of two alternating colours.
/// A band's particles add to its own layers and one more on either side, so bands of one colour
/// can run side by side. Bands depend on the grid alone, never on threads: every node gets its
/// addends in one order, hence the same bits for any number of threads.
class Bands {
 public:
  Bands(std::ptrdiff_t layers, std::ptrdiff_t rows_in_layer, std::ptrdiff_t height)
      : layers_(layers), rows_in_layer_(rows_in_layer), height_(height) {}

  std::ptrdiff_t count() const { return (layers_ + height_ - 1) / height_; }
  /// Bands of a colour: 0 are the even ones, 1 the odd ones.
  std::ptrdiff_t count_of(int colour) const { return (count() + 1 - colour) / 2; }
  static std::ptrdiff_t band_of(int colour, std::ptrdiff_t index) { return 2 * index + colour; }

  kernels::RowRange rows(std::ptrdiff_t band) const {
    return in_rows(band * height_, (band + 1) * height_);
  }
  /// What a band sets to zero before it scatters: an even band all it writes to, an odd band what
  /// its even neighbours, which ran before, have not reached.
  kernels::RowRange cleared_rows(std::ptrdiff_t band) const {
    const bool even = band % 2 == 0;
    const std::ptrdiff_t beyond = even ? 1 : -1;
    const bool is_last = band == count() - 1;
    return in_rows(band * height_ - beyond, is_last ? layers_ : (band + 1) * height_ + beyond);
  }
  /// Rows that are complete once a band has scattered: an odd band's and the rows next to it, which
  /// only the even band there adds to besides; the rest of an even band's. Every row is in one.
  kernels::RowRange completed_rows(std::ptrdiff_t band) const {
    const bool even = band % 2 == 0;
    const std::ptrdiff_t beyond = even ? -1 : 1;
    const bool is_last = band == count() - 1;
    const std::ptrdiff_t first = band == 0 ? 0 : band * height_ - beyond;
    return in_rows(first, is_last ? layers_ : (band + 1) * height_ + beyond);
  }

 private:
  kernels::RowRange in_rows(std::ptrdiff_t first, std::ptrdiff_t last) const {
    return {std::max<std::ptrdiff_t>(first, 0) * rows_in_layer_,
            std::min(last, layers_) * rows_in_layer_};
  }

  std::ptrdiff_t layers_;
  std::ptrdiff_t rows_in_layer_;
  std::ptrdiff_t height_;
};

}  // namespace rgimp
