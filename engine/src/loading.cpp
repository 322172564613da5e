#include "loading.hpp"

#include <utility>

namespace rgimp {
namespace {

/// visit(row, node, index along x) for every node of the rows that has mass.
template <int Dim, typename Visit>
void over_nodes(const kernels::GridView<Dim>& grid, double least_mass, kernels::RowRange rows,
                Visit visit) {
  const std::ptrdiff_t stride = grid.groups_in_row * kernels::kGroupWidth;
  for (std::ptrdiff_t row = rows.first; row < rows.last; ++row) {
    for (std::ptrdiff_t i = 0; i < stride; ++i) {
      if (grid.mass[row * stride + i] > least_mass) {
        visit(row, row * stride + i, i);
      }
    }
  }
}

template <int Dim>
Vector position_of(const kernels::GridView<Dim>& grid, std::ptrdiff_t row, std::ptrdiff_t i) {
  const std::array<std::ptrdiff_t, 3> index{i, row % grid.rows_in_plane, row / grid.rows_in_plane};
  Vector position = Vector::Zero();
  for (int a = 0; a < Dim; ++a) {
    position[a] = grid.origin[a] + grid.spacing[a] * static_cast<double>(index[a]);
  }
  return position;
}

}  // namespace

template <int Dim>
void Loading<Dim>::set(AccelerationField field, std::size_t nodes) {
  field_ = std::move(field);
  for (std::vector<double>& component : acceleration_) {
    component.assign(field_ ? nodes : 0, 0.0);
  }
}

template <int Dim>
void Loading<Dim>::add_forces(const kernels::GridView<Dim>& grid, double time, double least_mass,
                              kernels::RowRange rows) {
  if (!field_) {
    return;
  }
  over_nodes(grid, least_mass, rows,
             [&](std::ptrdiff_t row, std::ptrdiff_t node, std::ptrdiff_t i) {
               const Vector acceleration = field_(position_of(grid, row, i), time);
               for (int a = 0; a < Dim; ++a) {
                 acceleration_[a][node] = acceleration[a];
                 grid.force[a][node] += grid.mass[node] * acceleration[a];
               }
             });
}

template <int Dim>
void Loading<Dim>::add_works(const kernels::GridView<Dim>& grid, double dt, double least_mass,
                             kernels::RowRange rows, kernels::NodeSums* by_row) const {
  if (!field_) {
    return;
  }
  over_nodes(grid, least_mass, rows, [&](std::ptrdiff_t row, std::ptrdiff_t node, std::ptrdiff_t) {
    for (int a = 0; a < Dim; ++a) {
      const double after = grid.momentum[a][node];
      const double before = after - dt * grid.force[a][node];
      by_row[row].body_force_work +=
          grid.mass[node] * acceleration_[a][node] * 0.5 * dt * (before + after);
    }
  });
}

template class Loading<2>;
template class Loading<3>;

}  // namespace rgimp
