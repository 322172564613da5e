#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "models.hpp"
#include "state_hash.hpp"

// A slab between front and back platens that stand still and let slip is in plane strain.
namespace rgimp::tests {
namespace {

/// `cells` deep.
Case slab_of(const Case& plane, int cells) {
  Case slab = in_space(plane, 1e3 * cells * plane.grid.cell_size);
  for (const Side side : {Side::front, Side::back}) {
    slab.platens.push_back(holding(side));
  }
  return slab;
}

/// Largest differences of a slab's particles from those of the plane they are copies of, relative
/// to the largest value there.
struct Difference {
  double velocity = 0.0;
  double stress = 0.0;
  double out_of_plane = 0.0;  // of xz and yz, to the stress in the plane
  std::int64_t modes = 0;     // particles of another mode
};

Difference compare(Model& plane, ModelIn<3>& slab) {
  const Particles<2>& a = plane.solver.particles();
  const Particles<3>& b = slab.solver.particles();
  const std::vector<std::size_t> in_plane = lanes_by_id(a);
  const std::vector<std::size_t> in_slab = lanes_by_id(b);
  REQUIRE(b.count % a.count == 0);
  Difference apart;
  double largest_velocity = 0.0;
  double largest_stress = 0.0;
  for (std::size_t id = 0; id < b.count; ++id) {
    const std::size_t i = in_plane[id % a.count];  // plane after plane
    const std::size_t j = in_slab[id];
    for (int axis = 0; axis < 2; ++axis) {
      largest_velocity = std::max(largest_velocity, std::abs(a.velocity[axis][i]));
      apart.velocity =
          std::max(apart.velocity, std::abs(a.velocity[axis][i] - b.velocity[axis][j]));
    }
    for (int c = 0; c < 4; ++c) {
      largest_stress = std::max(largest_stress, std::abs(a.stress[c][i]));
      apart.stress = std::max(apart.stress, std::abs(a.stress[c][i] - b.stress[c][j]));
    }
    for (int c = 4; c < 6; ++c) {
      apart.out_of_plane = std::max(apart.out_of_plane, std::abs(b.stress[c][j]));
    }
    apart.modes += a.failure_mode[i] != b.failure_mode[j] ? 1 : 0;
  }
  apart.velocity /= largest_velocity;
  apart.stress /= largest_stress;
  apart.out_of_plane /= largest_stress;
  return apart;
}

}  // namespace

// Sums over nodes have more terms in a slab. Velocities of particles at nearly empty nodes next to
// the crack amplify their round-off; local damping turns on the signs of velocities and lets it
// grow.
TEST_CASE("a cracking slab in plane strain is the plane to round-off") {
  struct Trial {
    double damping;
    int cells;
    double tolerance;  // of velocities, relative to the largest
  };
  for (const Trial& trial : {Trial{0.0, 1, 1e-8}, Trial{0.0, 2, 1e-8}, Trial{0.7, 1, 1e-5}}) {
    Case settings = cracking_block();
    settings.local_damping = trial.damping;
    Model plane(settings, 2);
    ModelIn<3> slab(slab_of(settings, trial.cells), 2);
    plane.steps(1000);
    slab.steps(1000);
    const Difference apart = compare(plane, slab);
    INFO("damping " << trial.damping << ", " << trial.cells << " cells deep: velocity "
                    << apart.velocity << ", stress " << apart.stress << ", out of the plane "
                    << apart.out_of_plane);
    const HistoryRow expected = plane.solver.history();
    const HistoryRow row = slab.solver.history();
    REQUIRE(expected.failed_tension > 100);
    REQUIRE(apart.modes == 0);
    REQUIRE(slab.solver.first_failure()->step == plane.solver.first_failure()->step);
    REQUIRE(apart.velocity < trial.tolerance);
    REQUIRE(apart.stress < 0.1 * trial.tolerance);
    REQUIRE(apart.out_of_plane < 0.1 * trial.tolerance);
    const double depth = trial.cells * settings.grid.cell_size;
    REQUIRE(row.reaction / depth == Approx(expected.reaction).epsilon(1e-9));
    REQUIRE(row.axial_stress == Approx(expected.axial_stress).epsilon(1e-9));
    REQUIRE(row.strain_energy / depth == Approx(expected.strain_energy).epsilon(1e-9));
    REQUIRE(row.released_energy / depth == Approx(expected.released_energy).epsilon(1e-7));
  }
}

// The band of a softening point is as wide in space as in the plane.
TEST_CASE("a softening slab in plane strain is the plane to round-off") {
  Case settings = softening_block();
  settings.local_damping = 0.0;
  Model plane(settings, 2);
  ModelIn<3> slab(slab_of(settings, 1), 2);
  plane.steps(1000);
  slab.steps(1000);
  const Difference apart = compare(plane, slab);
  INFO("velocity " << apart.velocity << ", stress " << apart.stress);
  const Particles<2>& p = plane.solver.particles();
  REQUIRE(std::count(p.failure_mode.begin(), p.failure_mode.end(), kernels::kSofteningInTension) >
          20);
  REQUIRE(plane.solver.history().failed_tension > 20);
  REQUIRE(apart.modes == 0);
  REQUIRE(apart.velocity < 1e-8);
  REQUIRE(apart.stress < 1e-9);
  REQUIRE(slab.solver.history().released_energy / settings.grid.cell_size ==
          Approx(plane.solver.history().released_energy).epsilon(1e-9));
}

// Contacts of a half width are strips along z.
TEST_CASE("a cylinder between strips, its ends held, is the disk to round-off") {
  Case disk = compressed_block(10.0, 10.0, 0.5);
  disk.bodies[0].shape = BodyShape::disk;
  disk.materials["rock"].failure = rock_failure();
  for (Platen& platen : disk.platens) {
    platen.half_width = 1e-3;
  }
  Case cylinder = slab_of(disk, 2);
  Body& body = cylinder.bodies[0];
  body.shape = BodyShape::cylinder;
  body.axis = Vector::UnitZ();
  body.size = Vector(body.size.x(), body.size.z(), 0.0);
  Model plane(disk, 2);
  ModelIn<3> slab(cylinder, 2);
  plane.steps(600);
  slab.steps(600);
  const Difference apart = compare(plane, slab);
  INFO("velocity " << apart.velocity << ", stress " << apart.stress);
  REQUIRE(plane.solver.history().failed_tension > 10);
  REQUIRE(apart.modes == 0);
  REQUIRE(apart.velocity < 1e-8);
  REQUIRE(apart.stress < 1e-9);
  REQUIRE(slab.solver.history().reaction / 1e-3 ==
          Approx(plane.solver.history().reaction).epsilon(1e-9));
}

}  // namespace rgimp::tests
