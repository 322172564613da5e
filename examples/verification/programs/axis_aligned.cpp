#include "axis_aligned.hpp"

#include <cmath>
#include <numbers>

using std::numbers::pi;

namespace rgimp::verification {

AxisAligned::AxisAligned(double amplitude)
    : amplitude_(amplitude),
      material_{.density = 1.0, .youngs_modulus = 1e4, .poisson_ratio = 0.3, .failure = {}},
      wave_speed_(std::sqrt(material_.youngs_modulus / material_.density)) {}

Case AxisAligned::settings(const Resolution& resolution) const {
  Case settings = plain_case(resolution);
  Body square;
  square.center = Vector(0.5, 0.5, 0.0);
  square.size = Vector(1.0, 1.0, 0.0);
  square.material = "solid";
  square.particles_per_cell = resolution.particles_per_cell;
  settings.bodies = {square};
  settings.materials["solid"] = material_;
  for (const Side side : {Side::top, Side::bottom, Side::left, Side::right}) {
    Platen wall;
    wall.side = side;
    settings.platens.push_back(wall);
  }
  return settings;
}

std::array<double, 2> AxisAligned::swing(double t) const {
  const double swing = amplitude_ * std::sin(pi * wave_speed_ * t);
  return {swing, -swing};
}

std::array<double, 2> AxisAligned::stretch(const Vector& point, double t) const {
  const auto [x, y] = swing(t);
  return {1.0 + pi * x * std::cos(pi * point.x()), 1.0 + pi * y * std::cos(pi * point.y())};
}

Vector AxisAligned::displacement(const Vector& point, double t) const {
  const auto [x, y] = swing(t);
  return {x * std::sin(pi * point.x()), y * std::sin(pi * point.y()), 0.0};
}

Vector AxisAligned::velocity(const Vector& point, double t) const {
  const double rate = amplitude_ * pi * wave_speed_ * std::cos(pi * wave_speed_ * t);
  return {rate * std::sin(pi * point.x()), -rate * std::sin(pi * point.y()), 0.0};
}

// b = a - (J / rho_0) d sigma_xx / dX / F_x with d sigma_xx / dX = (lambda + 2 mu) F_x' / F_x.
Vector AxisAligned::body_force(const Vector& point, double t) const {
  const std::array<double, 2> amplitude = swing(t);
  const std::array<double, 2> f = stretch(point, t);
  const Lame lame(material_);
  Vector force = Vector::Zero();
  for (int a = 0; a < 2; ++a) {
    const double wave = pi * pi * amplitude[a] * std::sin(pi * point[a]);
    const double acceleration = -wave_speed_ * wave_speed_ * wave;
    const double gradient = -(lame.lambda + 2.0 * lame.shear) * wave / (f[a] * f[a]);
    force[a] = acceleration - f[0] * f[1] / material_.density * gradient;
  }
  return force;
}

Stress AxisAligned::stress(const Vector& point, double t) const {
  const std::array<double, 2> f = stretch(point, t);
  const Lame lame(material_);
  const double pressure = lame.lambda * std::log(f[0] * f[1]);
  return {pressure + 2.0 * lame.shear * std::log(f[0]),
          pressure + 2.0 * lame.shear * std::log(f[1]), pressure, 0.0};
}

double AxisAligned::largest_stress() const {
  return pi * amplitude_ * material_.youngs_modulus;
}

double AxisAligned::duration() const {
  return 2.0 / wave_speed_;  // one period
}

}  // namespace rgimp::verification
