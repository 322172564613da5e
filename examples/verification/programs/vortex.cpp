#include "vortex.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

using std::numbers::pi;

namespace rgimp::verification {
namespace {

constexpr double kInner = 0.75;
constexpr double kOuter = 1.25;
constexpr int kSamples = 1000;  // of the radius, for largest values

/// h(R) and its derivatives.
struct Profile {
  explicit Profile(double radius) {
    const double u = radius - 1.0;
    value = 1.0 - 32.0 * u * u + 256.0 * u * u * u * u;
    slope = -64.0 * u + 1024.0 * u * u * u;
    curvature = -64.0 + 3072.0 * u * u;
  }
  double value;
  double slope;
  double curvature;
};

double radius_of(const Vector& point) {
  return std::hypot(point.x(), point.y());
}

Vector turned(const Vector& point, double angle) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  return {c * point.x() - s * point.y(), s * point.x() + c * point.y(), 0.0};
}

double sample_radius(int sample) {
  return kInner + (kOuter - kInner) * sample / kSamples;
}

}  // namespace

Vortex::Vortex(double amplitude)
    : amplitude_(amplitude),
      material_{.density = 1000.0, .youngs_modulus = 1000.0, .poisson_ratio = 0.3, .failure = {}} {}

Case Vortex::settings(const Resolution& resolution) const {
  Case settings = plain_case(resolution);
  Body ring;
  ring.shape = BodyShape::disk;
  ring.size = Vector(2.0 * kOuter, 0.0, 0.0);
  ring.material = "solid";
  ring.particles_per_cell = resolution.particles_per_cell;
  Flaw hole;
  hole.shape = FlawShape::circle;
  hole.length = 2.0 * kInner;
  settings.bodies = {ring};
  settings.flaws = {hole};
  settings.materials["solid"] = material_;
  return settings;
}

Vector Vortex::displacement(const Vector& point, double t) const {
  const Profile h(radius_of(point));
  return turned(point, amplitude_ * std::sin(pi * t) * h.value) - point;
}

Vector Vortex::velocity(const Vector& point, double t) const {
  const Profile h(radius_of(point));
  const double rate = amplitude_ * pi * std::cos(pi * t) * h.value;
  return rate * turned(point, amplitude_ * std::sin(pi * t) * h.value + 0.5 * pi);
}

// rho a_r = ds_rr/dr + (s_rr - s_tt)/r + rho b_r, rho a_t = ds_rt/dr + 2 s_rt/r + rho b_t.
Vortex::PolarForce Vortex::polar_force(double radius, double t) const {
  const Profile h(radius);
  const double swing = amplitude_ * std::sin(pi * t);
  const double rate = amplitude_ * pi * std::cos(pi * t) * h.value;
  const double acceleration = -pi * pi * swing * h.value;
  const double shear = radius * swing * h.slope;
  const double shear_slope = swing * (h.slope + radius * h.curvature);
  const double mu = Lame(material_).shear;
  const double radial =
      -mu * std::sin(shear) * shear_slope - 2.0 * mu * (1.0 - std::cos(shear)) / radius;
  const double tangential =
      mu * std::cos(shear) * shear_slope + 2.0 * mu * std::sin(shear) / radius;
  return {-radius * rate * rate - radial / material_.density,
          radius * acceleration - tangential / material_.density};
}

Vector Vortex::body_force(const Vector& point, double t) const {
  const double radius = radius_of(point);
  const PolarForce force = polar_force(radius, t);
  const Vector along =
      turned(point, amplitude_ * std::sin(pi * t) * Profile(radius).value) / radius;
  return force.radial * along + force.tangential * turned(along, 0.5 * pi);
}

Stress Vortex::stress(const Vector& point, double t) const {
  const double radius = radius_of(point);
  const Profile h(radius);
  const double swing = amplitude_ * std::sin(pi * t);
  const double shear = radius * swing * h.slope;
  const double mu = Lame(material_).shear;
  const double hoop = mu * (1.0 - std::cos(shear));
  const double slip = mu * std::sin(shear);
  const Vector r = turned(point, swing * h.value) / radius;
  const double xx = hoop * (r.y() * r.y() - r.x() * r.x()) - 2.0 * slip * r.x() * r.y();
  return {xx, -xx, 0.0, -2.0 * hoop * r.x() * r.y() + slip * (r.x() * r.x() - r.y() * r.y())};
}

double Vortex::largest_displacement() const {
  return 2.0 * std::sin(0.5 * amplitude_);
}

double Vortex::largest_stress() const {
  return Lame(material_).shear * std::sin(std::min(largest_shear(), 0.5 * pi));
}

double Vortex::largest_shear() const {
  double most = 0.0;
  for (int i = 0; i <= kSamples; ++i) {
    const double radius = sample_radius(i);
    most = std::max(most, std::abs(amplitude_ * radius * Profile(radius).slope));
  }
  return most;
}

double Vortex::distance_from_published_force() const {
  double apart = 0.0;
  double most = 0.0;
  const double shear_per_mass = Lame(material_).shear / material_.density;
  for (int i = 0; i <= kSamples; ++i) {
    const double r = sample_radius(i);
    const double t = static_cast<double>(i) / kSamples;
    const double squares = std::pow(4.0 * r - 3.0, 2) * std::pow(4.0 * r - 5.0, 2);
    const double cubic = 96.0 * r * r * r - 240.0 * r * r + 188.0 * r - 45.0;
    const double published =
        -amplitude_ * std::sin(pi * t) * (r * pi * pi * squares + 64.0 * shear_per_mass * cubic);
    apart = std::max(apart, std::abs(polar_force(r, t).tangential - published));
    most = std::max(most, std::abs(published));
  }
  return apart / most;
}

}  // namespace rgimp::verification
