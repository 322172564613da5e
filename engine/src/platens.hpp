#pragma once

#include <cstdint>
#include <vector>

#include "grid.hpp"
#include "platen_geometry.hpp"
#include "rgimp/case.hpp"

namespace rgimp {

/// Smooth step from 0 to `speed` over `ramp`, m/s towards the specimen.
double platen_speed(const Platen& platen, double time);
/// Its time integral, m.
double platen_travel(const Platen& platen, double time);

/// What the platens do to a row of nodes in a step.
struct PlatenSums {
  double work = 0.0;             ///< J, done on the nodes
  std::vector<double> reaction;  ///< N per platen, on the specimen, towards it > 0
};

/// Rigid plates: prescribed normal velocity, both signs (bonded), of all node rows at or beyond
/// the specimen's end at the start, which move with the platen (GridMotion). The other components
/// slip freely or stick (zero).
template <int Dim>
class Platens {
 public:
  /// Also takes the damping off the platens' nodes, in three dimensions off those on the load's
  /// axis.
  Platens(const Case& settings, Grid<Dim>& grid);

  void set_time(double time);

  /// After update_nodes: the prescribed velocity replaces velocity and acceleration
  /// (u = u_bar, Eq. 4). The reaction is the force that takes. Sets by_row[row], which holds
  /// one reaction per platen. Its work is that of the reaction, and takes back what update_nodes
  /// booked for the body force on the way to a velocity that the node does not get.
  void impose(const kernels::GridView<Dim>& grid, const kernels::NodeUpdate<Dim>& update,
              kernels::RowRange rows, std::vector<PlatenSums>& by_row) const;
  /// The prescribed velocity in the field that strains come from.
  void impose_on_second_field(const kernels::GridView<Dim>& grid, kernels::RowRange rows) const;

 private:
  struct Constraint {
    std::ptrdiff_t node;
    std::uint8_t component;
    std::uint8_t platen;
    bool is_normal;  // else held at zero by a platen that sticks
  };

  void constrain_nodes(std::size_t platen, const Box& specimen, const Grid<Dim>& grid);
  double target(const Constraint& constraint) const;

  std::vector<Platen> settings_;
  std::vector<double> velocity_;  // by platen, along the axis, at the set time
  std::vector<Constraint> constraints_;
  std::vector<std::size_t> row_begin_;
};

}  // namespace rgimp
