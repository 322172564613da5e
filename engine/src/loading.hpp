#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "rgimp/extension.hpp"
#include "rgimp/kernels/views.hpp"

namespace rgimp {

/// An own acceleration of the nodes. Without one its functions return at once.
template <int Dim>
class Loading {
 public:
  void set(AccelerationField field, std::size_t nodes);
  bool is_set() const { return static_cast<bool>(field_); }

  /// Before the nodes' update, so that damping sees it: adds mass times acceleration at `time`.
  void add_forces(const kernels::GridView<Dim>& grid, double time, double least_mass,
                  kernels::RowRange rows);
  /// After it and the platens, when the new velocities are known: the forces' work of the step.
  void add_works(const kernels::GridView<Dim>& grid, double dt, double least_mass,
                 kernels::RowRange rows, kernels::NodeSums* by_row) const;

 private:
  AccelerationField field_;
  std::array<std::vector<double>, Dim> acceleration_;  // m/s2, of every node in the last update
};

}  // namespace rgimp
