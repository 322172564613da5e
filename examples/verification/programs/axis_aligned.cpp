#include "axis_aligned.hpp"

#include <cmath>
#include <numbers>
#include <vector>

using std::numbers::pi;

namespace rgimp::verification {

AxisAligned::AxisAligned(double amplitude, int dimension)
    : amplitude_(amplitude),
      sign_(1.0, -1.0, dimension == 3 ? 1.0 : 0.0),
      material_{.density = 1.0, .youngs_modulus = 1e4, .poisson_ratio = 0.3, .failure = {}},
      wave_speed_(std::sqrt(material_.youngs_modulus / material_.density)) {}

Case AxisAligned::settings(const Resolution& resolution) const {
  Case settings = plain_case(resolution);
  const Vector extent = sign_.cwiseAbs();
  Body solid;
  solid.center = 0.5 * extent;
  solid.size = extent;
  solid.material = "solid";
  solid.particles_per_cell = resolution.particles_per_cell;
  settings.bodies = {solid};
  settings.materials["solid"] = material_;
  std::vector<Side> sides = {Side::top, Side::bottom, Side::left, Side::right};
  if (extent.z() > 0.0) {
    settings.dimension = 3;
    sides.insert(sides.end(), {Side::front, Side::back});
  }
  for (const Side side : sides) {
    Platen wall;
    wall.side = side;
    settings.platens.push_back(wall);
  }
  return settings;
}

Vector AxisAligned::swing(double t) const {
  return amplitude_ * std::sin(pi * wave_speed_ * t) * sign_;
}

Vector AxisAligned::stretch(const Vector& point, double t) const {
  const Vector cosine = (pi * point).array().cos();
  return Vector::Ones() + pi * swing(t).cwiseProduct(cosine);
}

Vector AxisAligned::displacement(const Vector& point, double t) const {
  const Vector sine = (pi * point).array().sin();
  return swing(t).cwiseProduct(sine);
}

Vector AxisAligned::velocity(const Vector& point, double t) const {
  const Vector sine = (pi * point).array().sin();
  return amplitude_ * pi * wave_speed_ * std::cos(pi * wave_speed_ * t) * sign_.cwiseProduct(sine);
}

// b = a - (J / rho_0) d sigma_xx / dX / F_x with d sigma_xx / dX = (lambda + 2 mu) F_x' / F_x.
Vector AxisAligned::body_force(const Vector& point, double t) const {
  const Vector amplitude = swing(t);
  const Vector f = stretch(point, t);
  const Lame lame(material_);
  Vector force = Vector::Zero();
  for (int a = 0; a < 3; ++a) {
    const double wave = pi * pi * amplitude[a] * std::sin(pi * point[a]);
    const double acceleration = -wave_speed_ * wave_speed_ * wave;
    const double gradient = -(lame.lambda + 2.0 * lame.shear) * wave / (f[a] * f[a]);
    force[a] = acceleration - f.prod() / material_.density * gradient;
  }
  return force;
}

Stress AxisAligned::stress(const Vector& point, double t) const {
  const Vector strain = stretch(point, t).array().log();
  const Lame lame(material_);
  const Vector normal = lame.lambda * strain.sum() * Vector::Ones() + 2.0 * lame.shear * strain;
  return {normal.x(), normal.y(), normal.z()};
}

double AxisAligned::largest_stress() const {
  return pi * amplitude_ * material_.youngs_modulus;
}

double AxisAligned::duration() const {
  return 2.0 / wave_speed_;  // one period
}

}  // namespace rgimp::verification
