#pragma once

#include "rgimp/case.hpp"
#include "rgimp/kernels/views.hpp"

namespace rgimp {

/// The criteria of the paper's section 3.1 as limits on principal stresses s1 >= s2 >= s3, tension
/// positive; strains are eps = C^-1 sigma of linear elasticity.
///
/// mohr-coulomb         s1 >= sigma_t, else (s1 - s3)/2 + (s1 + s3)/2 sin(phi) >= c cos(phi)
///                      [Eq. 20, 21]
/// hydrostatic-tension  tr sigma / 3 >= tensile_strength
/// principal-stress     s1 >= tensile_strength
/// shear-stress         (s1 - s3) / 2 >= shear_strength
/// principal-strain     eps1 = ((1 + nu) s1 - nu tr sigma) / E >= tensile_strain
/// shear-strain         eps1 - eps3 = (1 + nu) (s1 - s3) / E >= shear_strain
kernels::FailureLimits failure_limits(const Material& material);

/// The cell at which a particle softens no longer but fails at once, m: there the elastic energy
/// of a band of cells is all of the fracture energy. Infinite without one.
struct LargestCell {
  /// 2 (lambda + 2 mu) G_f / sigma_t^2 over the root of the dimension: of a band along a diagonal
  double tension;
  double shear;  ///< 2 mu G_II / c^2
};
LargestCell largest_cell(const Material& material, int dimension);

/// Everything a kernel needs of a material. The cell size enters the bulk viscosity
/// q = rho (c0 L^2 (tr D)^2 + c1 L c |tr D|) (Zhang, Chen & Liu, The material point method, 2017).
kernels::MaterialConstants material_constants(const Material& material, const Case& settings);

}  // namespace rgimp
