#pragma once

#include "manufactured_solution.hpp"

namespace rgimp::verification {

/// Axis-aligned displacement in the unit square or cube (Wallstedt & Guilkey, J. Comput. Phys. 227
/// (2008) 9628, with its E, nu, rho and one half-wave a side as in Uintah's MMS): u_x = A sin(pi X)
/// sin(pi c t), u_y = -A sin(pi Y) sin(pi c t), c = sqrt(E / rho), and in the cube u_z as u_x. F is
/// diagonal at all times and nothing spins, so our law integrates to sigma = lambda ln J I + 2 mu
/// ln F where the paper's neo-Hookean law gives lambda ln J / J I + mu / J (F F^T - I).
class AxisAligned final : public ManufacturedSolution {
 public:
  AxisAligned(double amplitude, int dimension);

  Case settings(const Resolution& resolution) const override;
  Vector displacement(const Vector& point, double t) const override;
  Vector velocity(const Vector& point, double t) const override;
  Vector body_force(const Vector& point, double t) const override;
  Stress stress(const Vector& point, double t) const override;
  double largest_displacement() const override { return amplitude_; }
  double largest_stress() const override;
  double duration() const override;

 private:
  /// A sin(pi c t) along each axis, m: phase 0, along y pi.
  Vector swing(double t) const;
  /// The diagonal of F.
  Vector stretch(const Vector& point, double t) const;

  double amplitude_;
  Vector sign_;  // of each axis; 0 for z in the plane
  Material material_;
  double wave_speed_;
};

}  // namespace rgimp::verification
