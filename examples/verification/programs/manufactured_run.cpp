#include "manufactured_run.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "../../../kernels/reference/shape.hpp"
#include "solver.hpp"

namespace rgimp::verification {
namespace {

namespace reference = kernels::reference;

/// Of a particle's mass. Nodes lighter than that are left alone: where the kernels' fused weight is
/// zero, the weight here may be 1e-33.
constexpr double kLeastMass = 1e-12;

template <int Dim>
class ManufacturedRun {
 public:
  ManufacturedRun(const ManufacturedSolution& solution, const Resolution& resolution)
      : solution_(solution),
        settings_(solution.settings(resolution)),
        workers_(1),
        solver_(settings_, kernels::best_isa(), workers_),
        point_(solver_.particles().count, Vector::Zero()) {
    Particles<Dim>& p = solver_.particles();
    for (std::size_t i = 0; i < p.lanes(); ++i) {
      if (!p.is_padding(i)) {
        Vector& point = point_[p.id[i]];
        for (int a = 0; a < Dim; ++a) {
          point[a] = p.position[a][i];
        }
        const Vector velocity = solution.velocity(point, -0.5 * solver_.dt());
        for (int a = 0; a < Dim; ++a) {
          p.velocity[a][i] = velocity[a];
        }
      }
    }
    solver_.rebin();
  }

  void step() {
    solver_.prepare();
    push();
    solver_.step();
  }

  void note_errors(ManufacturedErrors& errors) {
    const Particles<Dim>& p = solver_.particles();
    double displacement = 0.0;
    double stress = 0.0;
    for (std::size_t i = 0; i < p.lanes(); ++i) {
      if (p.is_padding(i)) {
        continue;
      }
      const Vector& point = point_[p.id[i]];
      const Vector expected = point + solution_.displacement(point, solver_.time());
      for (int a = 0; a < Dim; ++a) {
        displacement += std::pow(p.position[a][i] - expected[a], 2);
      }
      const Stress s = solution_.stress(point, solver_.time());
      for (std::size_t c = 0; c < p.stress.size(); ++c) {
        stress += std::pow(p.stress[c][i] - s[c], 2);
      }
    }
    const auto count = static_cast<double>(p.count);
    errors.displacement = std::max(
        errors.displacement, std::sqrt(displacement / count) / solution_.largest_displacement());
    errors.stress = std::max(errors.stress, std::sqrt(stress / count) / solution_.largest_stress());
  }

  const Solver<Dim>& solver() const { return solver_; }

 private:
  bool is_held(const Vector& node, int axis) const {
    const Box box = bounds(settings_);
    const double slack = 1e-6 * settings_.grid.cell_size;
    return !settings_.platens.empty() &&
           (node[axis] <= box.min[axis] + slack || node[axis] >= box.max[axis] - slack);
  }

  /// a_i += sum m_p b_p S_ip / m_i, and v_i likewise: what a body force per particle adds to the
  /// grid that the next step starts from. Platens hold what they prescribe.
  void push() {
    const kernels::GridView<Dim>& grid = solver_.now();
    const std::ptrdiff_t nodes = solver_.grid().rows() * solver_.grid().row_stride();
    for (std::vector<double>& force : force_) {
      force.assign(static_cast<std::size_t>(nodes), 0.0);
    }
    const reference::Shape<Dim> shape(grid);
    const kernels::ParticleView<Dim> p = solver_.particles().view();
    const Column<std::uint32_t>& id = solver_.particles().id;
    const auto scatter = [&](std::size_t i, const reference::BinNode<Dim>& bin, std::size_t) {
      const Vector push = p.mass[i] * solution_.body_force(point_[id[i]], solver_.time());
      reference::for_each_node(reference::stencil_of(p, i, bin, shape), shape,
                               [&](std::ptrdiff_t node, double weight, const double(&)[Dim]) {
                                 for (int a = 0; a < Dim; ++a) {
                                   force_[a][node] += weight * push[a];
                                 }
                               });
    };
    reference::for_each_particle(p, grid, {0, solver_.grid().rows()}, scatter);
    const double least_mass = kLeastMass * *std::max_element(p.mass, p.mass + id.size());
    for (std::ptrdiff_t node = 0; node < nodes; ++node) {
      const Vector position = solver_.grid().position(node);
      for (int a = 0; a < Dim; ++a) {
        if (grid.mass[node] > least_mass && !is_held(position, a)) {
          const double acceleration = force_[a][node] / grid.mass[node];
          grid.force[a][node] += acceleration;
          grid.momentum[a][node] += solver_.dt() * acceleration;
        }
      }
    }
  }

  const ManufacturedSolution& solution_;
  Case settings_;
  Workers workers_;
  Solver<Dim> solver_;
  std::vector<Vector> point_;  // by id, where it lies without displacement
  std::array<std::vector<double>, Dim> force_;
};

template <int Dim>
ManufacturedErrors run_in(const ManufacturedSolution& solution, const Resolution& resolution) {
  ManufacturedRun<Dim> run(solution, resolution);
  ManufacturedErrors errors;
  while (run.solver().time() < solution.duration()) {
    run.step();
    run.note_errors(errors);
  }
  errors.steps = run.solver().steps_done();
  errors.particles =
      static_cast<std::int64_t>(seed_particles(solution.settings(resolution)).size());
  return errors;
}

}  // namespace

ManufacturedErrors run_manufactured(const ManufacturedSolution& solution,
                                    const Resolution& resolution) {
  return solution.settings(resolution).dimension == 3 ? run_in<3>(solution, resolution)
                                                      : run_in<2>(solution, resolution);
}

}  // namespace rgimp::verification
