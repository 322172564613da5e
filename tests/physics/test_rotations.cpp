#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <numbers>
#include <tuple>

#include "geometry.hpp"
#include "models.hpp"
#include "platen_geometry.hpp"
#include "state_hash.hpp"

// A case turned by 90 degrees about an axis gives the same result turned. Not the same bits: sums
// over nodes run along x first, and the grid begins with a wider margin there.
namespace rgimp::tests {
namespace {

using Eigen::Matrix3d;

Matrix3d quarter_turn(int axis) {
  const Matrix3d turn =
      Eigen::AngleAxisd(0.5 * std::numbers::pi, Vector::Unit(axis)).toRotationMatrix();
  return turn.array().round();
}

Side turned(Side side, const Matrix3d& turn) {
  const PlatenAxis from = axis_of(side);
  const Vector towards = turn * (from.towards * Vector::Unit(from.axis));
  for (const Side to :
       {Side::top, Side::bottom, Side::left, Side::right, Side::front, Side::back}) {
    const PlatenAxis axis = axis_of(to);
    if (towards == axis.towards * Vector::Unit(axis.axis)) {
      return to;
    }
  }
  throw std::logic_error("no side looks there");
}

Case turned(Case settings, const Matrix3d& turn) {
  for (Body& body : settings.bodies) {
    body.center = turn * body.center;
    body.size = (turn * body.size).cwiseAbs();
    body.velocity = turn * body.velocity;
  }
  for (Flaw& flaw : settings.flaws) {
    flaw.center = turn * flaw.center;
    flaw.direction = turn * *flaw.direction;
    flaw.normal = turn * *flaw.normal;
  }
  for (Platen& platen : settings.platens) {
    platen.side = turned(platen.side, turn);
  }
  settings.body_acceleration = turn * settings.body_acceleration;
  return settings;
}

/// Ids of a turned case's particles in the order of those of the case.
std::vector<std::size_t> counterparts(const Case& settings, const Matrix3d& turn) {
  const auto key = [&](const Vector& position) {
    const Vector cells = 8.0 * position / settings.grid.cell_size;  // particles are 4 apart
    return std::tuple(std::lround(cells.x()), std::lround(cells.y()), std::lround(cells.z()));
  };
  std::map<std::tuple<long, long, long>, std::size_t> id_at;
  const std::vector<ParticleSeed> after = seed_particles(turned(settings, turn));
  for (std::size_t id = 0; id < after.size(); ++id) {
    id_at[key(after[id].position)] = id;
  }
  std::vector<std::size_t> ids;
  for (const ParticleSeed& seed : seed_particles(settings)) {
    ids.push_back(id_at.at(key(turn * seed.position)));
  }
  return ids;
}

/// An oblique embedded slot off the centre, pressed along y, stuck to a platen along x and pulled
/// by a body force: no symmetry at all.
Case lopsided_block() {
  Case settings = in_space(compressed_block(6.0, 8.0, 0.2), 5.0);
  settings.materials["rock"].failure = rock_failure();
  settings.platens.push_back(holding(Side::left));
  settings.platens.back().lateral = Lateral::stick;
  settings.body_acceleration = Vector(300.0, 100.0, -2000.0);
  Flaw slot;
  slot.center = Vector(0.3e-3, -0.2e-3, 0.4e-3);
  slot.length = 3.4e-3;
  slot.width = 1.6e-3;
  slot.depth = 3e-3;
  slot.direction = Vector(1.0, 1.1, 0.3);
  slot.normal = Vector(-1.1, 1.0, 0.0);
  settings.flaws = {slot};
  return settings;
}

Matrix3d stress_of(const Particles<3>& p, std::size_t i) {
  Matrix3d s;
  for (int a = 0; a < 3; ++a) {
    for (int b = 0; b < 3; ++b) {
      s(a, b) = p.stress[static_cast<std::size_t>(kernels::kStressColumn[a][b])][i];
    }
  }
  return s;
}

Vector velocity_of(const Particles<3>& p, std::size_t i) {
  return {p.velocity[0][i], p.velocity[1][i], p.velocity[2][i]};
}

/// Largest differences from the turned model turned back, relative to the largest value.
struct TurnedDifference {
  double velocity;
  double stress;
  std::int64_t modes;
};

TurnedDifference compare(ModelIn<3>& upright, ModelIn<3>& lying, const Matrix3d& turn) {
  const Particles<3>& a = upright.solver.particles();
  const Particles<3>& b = lying.solver.particles();
  const std::vector<std::size_t> ids = counterparts(upright.settings, turn);
  const std::vector<std::size_t> lanes_a = lanes_by_id(a);
  const std::vector<std::size_t> lanes_b = lanes_by_id(b);
  double speed = 0.0;
  double stress = 0.0;
  TurnedDifference apart{};
  for (std::size_t id = 0; id < ids.size(); ++id) {
    const std::size_t i = lanes_a[id];
    const std::size_t j = lanes_b[ids[id]];
    speed = std::max(speed, velocity_of(a, i).norm());
    stress = std::max(stress, stress_of(a, i).norm());
    apart.velocity =
        std::max(apart.velocity, (turn * velocity_of(a, i) - velocity_of(b, j)).norm());
    apart.stress = std::max(apart.stress,
                            (turn * stress_of(a, i) * turn.transpose() - stress_of(b, j)).norm());
    apart.modes += a.failure_mode[i] != b.failure_mode[j] ? 1 : 0;
  }
  apart.velocity /= speed;
  apart.stress /= stress;
  return apart;
}

}  // namespace

TEST_CASE("a block turned by 90 degrees about an axis cracks the same way, turned") {
  for (const double damping : {0.0, 0.7}) {
    Case settings = lopsided_block();
    settings.local_damping = damping;
    ModelIn<3> upright(settings, 2);
    upright.steps(300);
    const HistoryRow expected = upright.solver.history();
    REQUIRE(expected.failed_tension > 100);
    for (int axis = 0; axis < 3; ++axis) {
      const Matrix3d turn = quarter_turn(axis);
      ModelIn<3> lying(turned(settings, turn), 2);
      lying.steps(300);
      const TurnedDifference apart = compare(upright, lying, turn);
      INFO("damping " << damping << ", about axis " << axis << ": velocity " << apart.velocity
                      << ", stress " << apart.stress);
      REQUIRE(apart.modes == 0);
      REQUIRE(apart.velocity < 1e-8);
      REQUIRE(apart.stress < 1e-9);
      const HistoryRow row = lying.solver.history();
      REQUIRE(row.closure == expected.closure);
      REQUIRE(row.reaction == Approx(expected.reaction).epsilon(1e-10));
      REQUIRE(row.axial_stress == Approx(expected.axial_stress).epsilon(1e-10));
      REQUIRE(row.strain_energy == Approx(expected.strain_energy).epsilon(1e-10));
      REQUIRE(lying.solver.first_failure()->step == upright.solver.first_failure()->step);
    }
  }
}

}  // namespace rgimp::tests
