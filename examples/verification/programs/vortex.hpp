#pragma once

#include "manufactured_solution.hpp"

namespace rgimp::verification {

/// Generalised vortex (Kamojjala, Brannon, Sadeghirad & Guilkey, Eng. Comput. 31 (2015) 193): a
/// ring 0.75 < R < 1.25 whose points turn about its centre by
/// alpha = A sin(pi c t) h(R), h = 1 - 32 (R - 1)^2 + 256 (R - 1)^4, c = 1 m/s; both faces free.
/// Along e_r, e_theta of a point its path is simple shear of gamma = R d alpha / dR, for which the
/// Jaumann rate integrates to s_rt = mu sin(gamma), s_tt = -s_rr = mu (1 - cos(gamma)) (Dienes,
/// Acta Mech. 32 (1979) 217). The paper's neo-Hookean law has s_rt = mu gamma, s_tt = mu gamma^2.
class Vortex final : public ManufacturedSolution {
 public:
  explicit Vortex(double amplitude);

  Case settings(const Resolution& resolution) const override;
  Vector displacement(const Vector& point, double t) const override;
  Vector velocity(const Vector& point, double t) const override;
  Vector body_force(const Vector& point, double t) const override;
  Stress stress(const Vector& point, double t) const override;
  double largest_displacement() const override;
  double largest_stress() const override;
  double duration() const override { return 1.0; }

  /// Largest |gamma| of the ring at the middle of the duration. Past pi / 2 shear softens and the
  /// motion stops being one that a solid of this law can hold.
  double largest_shear() const;
  /// Largest difference of b_theta, t in the duration, from the neo-Hookean law's, which the paper
  /// prints and which ours must meet at small amplitudes; relative to the largest b_theta.
  double distance_from_published_force() const;

 private:
  struct PolarForce {
    double radial;
    double tangential;
  };
  PolarForce polar_force(double radius, double t) const;

  double amplitude_;
  Material material_;
};

}  // namespace rgimp::verification
