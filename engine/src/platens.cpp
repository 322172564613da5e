#include "platens.hpp"

#include <algorithm>
#include <tuple>

namespace rgimp {

double platen_speed(const Platen& platen, double time) {
  if (time >= platen.ramp) {
    return platen.speed;
  }
  const double s = time / platen.ramp;
  return platen.speed * s * s * (3.0 - 2.0 * s);
}

double platen_travel(const Platen& platen, double time) {
  if (time >= platen.ramp) {
    return platen.speed * (time - 0.5 * platen.ramp);
  }
  const double s = time / platen.ramp;
  return platen.speed * platen.ramp * s * s * s * (1.0 - 0.5 * s);
}

template <int Dim>
Platens<Dim>::Platens(const Case& settings, Grid<Dim>& grid)
    : settings_(settings.platens), velocity_(settings.platens.size(), 0.0) {
  const Box specimen = bounds(settings);
  for (std::size_t p = 0; p < settings_.size(); ++p) {
    constrain_nodes(p, specimen, grid);
  }
  // Where a component is prescribed twice (a corner), a normal velocity wins over sticking.
  std::stable_sort(constraints_.begin(), constraints_.end(),
                   [](const Constraint& a, const Constraint& b) {
                     return std::tuple(a.node, a.component, !a.is_normal) <
                            std::tuple(b.node, b.component, !b.is_normal);
                   });
  const auto same = [](const Constraint& a, const Constraint& b) {
    return a.node == b.node && a.component == b.component;
  };
  constraints_.erase(std::unique(constraints_.begin(), constraints_.end(), same),
                     constraints_.end());
  row_begin_.assign(static_cast<std::size_t>(grid.rows()) + 1, 0);
  const std::optional<int> loaded = load_axis(settings);
  for (const Constraint& constraint : constraints_) {
    // In space, plane strain between front and back must be damped as it is in two dimensions, and
    // nobody reads the reactions there.
    if (Dim == 2 || axis_of(settings_[constraint.platen].side).axis == loaded) {
      grid.clear_damping(constraint.node);
    }
    ++row_begin_[static_cast<std::size_t>(constraint.node / grid.row_stride()) + 1];
  }
  for (std::size_t row = 1; row < row_begin_.size(); ++row) {
    row_begin_[row] += row_begin_[row - 1];
  }
}

template <int Dim>
void Platens<Dim>::constrain_nodes(std::size_t platen, const Box& specimen, const Grid<Dim>& grid) {
  const Platen& p = settings_[platen];
  const PlatenContact contact(p, specimen);
  const PlatenAxis side = contact.side;
  const double slack = 1e-6 * grid.extent().spacing[side.axis];
  for (std::ptrdiff_t node = 0; node < grid.rows() * grid.row_stride(); ++node) {
    const Vector x = grid.position(node);
    const bool beyond = (contact.end - x[side.axis]) * side.towards >= -slack;
    if (!beyond || !contact.holds(x[contact.across])) {
      continue;
    }
    for (int a = 0; a < Dim; ++a) {
      if (a == side.axis || p.lateral == Lateral::stick) {
        constraints_.push_back({node, static_cast<std::uint8_t>(a),
                                static_cast<std::uint8_t>(platen), a == side.axis});
      }
    }
  }
}

template <int Dim>
void Platens<Dim>::set_time(double time) {
  for (std::size_t p = 0; p < settings_.size(); ++p) {
    velocity_[p] = axis_of(settings_[p].side).towards * platen_speed(settings_[p], time);
  }
}

template <int Dim>
double Platens<Dim>::target(const Constraint& constraint) const {
  return constraint.is_normal ? velocity_[constraint.platen] : 0.0;
}

template <int Dim>
void Platens<Dim>::impose(const kernels::GridView<Dim>& grid,
                          const kernels::NodeUpdate<Dim>& update, kernels::RowRange rows,
                          std::vector<PlatenSums>& by_row) const {
  const double dt = update.dt;
  for (std::ptrdiff_t row = rows.first; row < rows.last; ++row) {
    PlatenSums& sums = by_row[row];
    sums.work = 0.0;
    std::fill(sums.reaction.begin(), sums.reaction.end(), 0.0);
    for (std::size_t c = row_begin_[row]; c < row_begin_[row + 1]; ++c) {
      const Constraint& constraint = constraints_[c];
      double& velocity = grid.momentum[constraint.component][constraint.node];
      double& acceleration = grid.force[constraint.component][constraint.node];
      const double mass = grid.mass[constraint.node];
      const double prescribed = target(constraint);
      if (mass > update.least_mass) {
        const double before = velocity - dt * acceleration;
        const double force = mass * (prescribed - velocity) / dt;
        const double body = mass * update.body_acceleration[constraint.component];
        sums.work +=
            force * 0.5 * dt * (before + prescribed) + body * 0.5 * dt * (prescribed - velocity);
        if (constraint.is_normal) {
          sums.reaction[constraint.platen] +=
              force * axis_of(settings_[constraint.platen].side).towards;
        }
        acceleration += (prescribed - velocity) / dt;
      }
      velocity = prescribed;
    }
  }
}

template <int Dim>
void Platens<Dim>::impose_on_second_field(const kernels::GridView<Dim>& grid,
                                          kernels::RowRange rows) const {
  for (std::size_t c = row_begin_[rows.first]; c < row_begin_[rows.last]; ++c) {
    const Constraint& constraint = constraints_[c];
    grid.second_field[constraint.component][constraint.node] = target(constraint);
  }
}

template class Platens<2>;
template class Platens<3>;

}  // namespace rgimp
