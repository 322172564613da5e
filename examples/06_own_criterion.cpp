// Rock with bedding: it slips along planes of weakness. A criterion of one's own, against theory.
#include <cmath>
#include <cstdio>
#include <numbers>

#include "rgimp/rgimp.hpp"

namespace {

constexpr double kCohesion = 1e6;  // Pa, of the planes
constexpr double kFriction = 30.0 * std::numbers::pi / 180.0;

/// Of planes at `angle` from horizontal: slips where the shear stress on them reaches cohesion and
/// friction (Jaeger, 1960). Stresses are tensors, tension positive.
rgimp::FailureCriterion slip_along_planes(double angle) {
  const rgimp::Vector normal(-std::sin(angle), std::cos(angle), 0.0);
  return [normal](const rgimp::IntactParticle& particle) {
    const rgimp::Vector traction = particle.stress * normal;
    const double pressure = -traction.dot(normal);
    const double shear = (traction + pressure * normal).norm();
    return shear >= kCohesion + pressure * std::tan(kFriction) ? rgimp::FailureMode::shear
                                                               : rgimp::FailureMode::intact;
  };
}

/// Axial stress at which a slender block slips along planes at `angle`, Pa.
double jaeger(double angle) {
  return kCohesion / (std::cos(angle) * (std::sin(angle) - std::cos(angle) * std::tan(kFriction)));
}

/// Axial stress at the first failure, Pa; 0 where there was none.
double simulate(double angle) {
  // 1. A block under slow compression, of a material that never fails by itself. One with a
  //    criterion would keep it: a program's own acts beside it.
  rgimp::Case c;
  c.grid.cell_size = 0.5e-3;
  c.materials["rock"] = {.density = 2600.0, .youngs_modulus = 17e9, .poisson_ratio = 0.14};
  c.bodies.push_back({.size = {10e-3, 20e-3, 0.0}, .material = "rock"});
  c.platens.push_back({.side = rgimp::Side::top, .speed = 0.02, .ramp = 5e-5});
  c.platens.push_back({.side = rgimp::Side::bottom, .speed = 0.02, .ramp = 5e-5});
  c.local_damping = 0.7;
  c.time.step_factor = 0.4;
  c.time.steps = 10000;

  // 2. The criterion is asked about every intact particle after every step. What fails is treated
  //    as the paper does: it carries pressure, but no shear and no tension.
  rgimp::Simulation simulation(c);
  simulation.set_criterion(slip_along_planes(angle));
  while (!simulation.first_failure() && simulation.steps_done() < *c.time.steps) {
    simulation.step();
  }
  const auto first = simulation.first_failure();
  return first ? first->axial_stress : 0.0;
}

}  // namespace

int main() {
  // 3. Steep planes slip more easily than flat ones; below the friction angle none does.
  bool is_right = true;
  std::printf("angle of planes, degrees   strength, MPa   theory, MPa\n");
  for (const double degrees : {45.0, 52.5, 60.0, 67.5}) {
    const double angle = degrees * std::numbers::pi / 180.0;
    const double strength = simulate(angle);
    std::printf("%24.1f   %13.3f   %11.3f\n", degrees, 1e-6 * strength, 1e-6 * jaeger(angle));
    is_right = is_right && std::abs(strength / jaeger(angle) - 1.0) < 0.02;
  }
  return is_right ? 0 : 1;
}
