#include "time_step.hpp"

#include <algorithm>
#include <cmath>

namespace rgimp {
namespace {

constexpr double kStepTolerance = 1e-6;  // steps; a duration of n steps must not become n + 1

}  // namespace

double sound_speed(const Material& material) {
  const double nu = material.poisson_ratio;
  return std::sqrt(material.youngs_modulus * (1.0 - nu) /
                   ((1.0 + nu) * (1.0 - 2.0 * nu) * material.density));
}

double fastest_sound(const Case& settings) {
  double most = 0.0;
  for (const Body& body : settings.bodies) {
    most = std::max(most, sound_speed(settings.materials.at(body.material)));
  }
  return most;
}

double time_step(const Case& settings) {
  return settings.time.step_factor * (settings.grid.cell_size / fastest_sound(settings));
}

double total_steps(const Case& settings) {
  if (settings.time.steps) {
    return static_cast<double>(*settings.time.steps);
  }
  return std::ceil(settings.time.duration.value_or(0.0) / time_step(settings) - kStepTolerance);
}

}  // namespace rgimp
