#pragma once

#include <array>

#include "resolution.hpp"

namespace rgimp::verification {

/// xx, yy, zz, xy, yz, xz; the last two are 0 in the plane.
using Stress = std::array<double, 6>;

/// A motion that is given and the body force that makes it a solution of the hypoelastic law with
/// the Jaumann rate. Points are material ones, where they lie without displacement, m; t in s.
class ManufacturedSolution {
 public:
  virtual ~ManufacturedSolution() = default;

  virtual Case settings(const Resolution& resolution) const = 0;
  virtual Vector displacement(const Vector& point, double t) const = 0;  ///< m
  virtual Vector velocity(const Vector& point, double t) const = 0;      ///< m/s
  virtual Vector body_force(const Vector& point, double t) const = 0;    ///< m/s2, per mass
  virtual Stress stress(const Vector& point, double t) const = 0;        ///< Pa, Cauchy
  virtual double largest_displacement() const = 0;                       ///< m
  virtual double largest_stress() const = 0;                             ///< Pa
  virtual double duration() const = 0;                                   ///< s
};

/// Lame's constants, Pa.
struct Lame {
  explicit Lame(const Material& material)
      : lambda(material.youngs_modulus * material.poisson_ratio /
               ((1.0 + material.poisson_ratio) * (1.0 - 2.0 * material.poisson_ratio))),
        shear(0.5 * material.youngs_modulus / (1.0 + material.poisson_ratio)) {}
  double lambda;
  double shear;
};

}  // namespace rgimp::verification
