#include "failure_limits.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "time_step.hpp"

namespace rgimp {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

kernels::FailureLimits never_fails() {
  return {.tension = kNever,
          .tension_per_trace = 0.0,
          .trace = kNever,
          .shear_major = 0.5,
          .shear_minor = 0.5,
          .shear = kNever};
}

kernels::FailureLimits mohr_coulomb(const Failure& failure) {
  const double angle = failure.friction_angle * std::numbers::pi / 180.0;
  kernels::FailureLimits limits = never_fails();
  limits.tension = failure.tensile_strength;
  limits.shear_major = 0.5 * (1.0 + std::sin(angle));
  limits.shear_minor = 0.5 * (1.0 - std::sin(angle));
  limits.shear = failure.cohesion * std::cos(angle);
  return limits;
}

void set_failed_pressure(const Failure& failure, kernels::MaterialConstants& constants) {
  switch (failure.treatment) {
    case Treatment::no_tension:
      constants.failed_pressure_min = 0.0;
      constants.failed_pressure_max = kNever;
      return;
    case Treatment::stress_free:
      constants.failed_pressure_min = 0.0;
      constants.failed_pressure_max = 0.0;
      return;
    case Treatment::pressure_window:
      constants.failed_pressure_min = failure.pressure_min;
      constants.failed_pressure_max = failure.pressure_max;
      return;
  }
}

double shear_modulus(const Material& material) {
  return 0.5 * material.youngs_modulus / (1.0 + material.poisson_ratio);
}

/// The width of a band whose elastic energy at the strength is all of its fracture energy, m.
double largest_band(double strength, double modulus, double fracture_energy) {
  return fracture_energy > 0.0 ? 2.0 * modulus * fracture_energy / (strength * strength) : kNever;
}

/// A cell's diagonal over its edge.
double diagonal(int dimension) {
  return std::sqrt(static_cast<double>(dimension));
}

kernels::Softening softening_of(const Material& material, const Case& settings) {
  const double cell = settings.grid.cell_size;
  const LargestCell largest = largest_cell(material, settings.dimension);
  const double widest = diagonal(settings.dimension);
  return {.tension = std::isfinite(largest.tension) ? cell / (widest * largest.tension) : 1.0,
          .shear = std::isfinite(largest.shear) ? cell / largest.shear : 1.0};
}

}  // namespace

LargestCell largest_cell(const Material& material, int dimension) {
  if (!material.failure) {
    return {kNever, kNever};
  }
  const Failure& failure = *material.failure;
  const double oedometric_modulus = material.density * std::pow(sound_speed(material), 2);
  const double shear_strength =
      failure.criterion == Criterion::mohr_coulomb ? failure.cohesion : failure.shear_strength;
  return {.tension =
              largest_band(failure.tensile_strength, oedometric_modulus, failure.fracture_energy) /
              diagonal(dimension),
          .shear =
              largest_band(shear_strength, shear_modulus(material), failure.shear_fracture_energy)};
}

kernels::FailureLimits failure_limits(const Material& material) {
  kernels::FailureLimits limits = never_fails();
  if (!material.failure) {
    return limits;
  }
  const Failure& failure = *material.failure;
  const double modulus = material.youngs_modulus;
  const double ratio = material.poisson_ratio;
  switch (failure.criterion) {
    case Criterion::mohr_coulomb:
      return mohr_coulomb(failure);
    case Criterion::hydrostatic_tension:
      limits.trace = 3.0 * failure.tensile_strength;
      return limits;
    case Criterion::principal_stress:
      limits.tension = failure.tensile_strength;
      return limits;
    case Criterion::shear_stress:
      limits.shear = failure.shear_strength;
      return limits;
    case Criterion::principal_strain:
      limits.tension = modulus * failure.tensile_strain / (1.0 + ratio);
      limits.tension_per_trace = ratio / (1.0 + ratio);
      return limits;
    case Criterion::shear_strain:
      limits.shear = 0.5 * modulus * failure.shear_strain / (1.0 + ratio);
      return limits;
  }
  return limits;
}

kernels::MaterialConstants material_constants(const Material& material, const Case& settings) {
  const double modulus = material.youngs_modulus;
  const double ratio = material.poisson_ratio;
  const double cell = settings.grid.cell_size;
  kernels::MaterialConstants constants{};
  constants.lambda = modulus * ratio / ((1.0 + ratio) * (1.0 - 2.0 * ratio));
  constants.shear_modulus = shear_modulus(material);
  constants.quadratic_viscosity = settings.quadratic_viscosity * cell * cell;
  constants.linear_viscosity = settings.linear_viscosity * cell * sound_speed(material);
  constants.energy_of_square = 0.5 * (1.0 + ratio) / modulus;
  constants.energy_of_trace = 0.5 * ratio / modulus;
  constants.limits = failure_limits(material);
  constants.softening = softening_of(material, settings);
  constants.softens = constants.softening.tension < 1.0 || constants.softening.shear < 1.0;
  // One without a criterion can still fail by the program's own, see Simulation::set_criterion.
  set_failed_pressure(material.failure.value_or(Failure{}), constants);
  return constants;
}

}  // namespace rgimp
