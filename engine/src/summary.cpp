#include "summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "rgimp/version.hpp"

namespace rgimp {

namespace {

using Json = nlohmann::ordered_json;

Json to_json(const FirstFailure& failure) {
  const Vector& at = failure.position;
  return {{"step", failure.step},
          {"closure_m", failure.closure},
          {"axial_stress_Pa", failure.axial_stress},
          {"position_m", {at.x(), at.y(), at.z()}},
          {"mode", failure.mode == FailureMode::tension ? "tension" : "shear"}};
}

Json to_json(const RemovedParticles& removed) {
  return {
      {"particles", removed.particles}, {"mass_kg", removed.mass}, {"energy_J", removed.energy}};
}

/// Work that is neither stored nor spent, J.
double residual(const HistoryRow& row) {
  return row.external_work - row.kinetic_energy - row.strain_energy - row.damping_work -
         row.viscous_work - row.released_energy - row.removed_energy;
}

}  // namespace

std::string format_summary(const Summary& summary) {
  const Json failure = summary.first_failure ? to_json(*summary.first_failure) : Json();
  const Json json{{"particles", summary.particles},
                  {"steps", summary.steps},
                  {"dt_s", summary.dt},
                  {"wall_s", summary.wall_seconds},
                  {"particle_steps_per_second", summary.particle_steps_per_second},
                  {"isa", summary.isa},
                  {"threads", summary.threads},
                  {"version", version()},
                  {"first_failure", failure},
                  {"failed_tension", summary.failed_tension},
                  {"failed_shear", summary.failed_shear},
                  {"peak_axial_stress_Pa", summary.peak_axial_stress},
                  {"energy_error", summary.energy_error},
                  {"removed", to_json(summary.removed)},
                  {"state_hash", fmt::format("{:016x}", summary.state_hash)}};
  return json.dump(2) + "\n";
}

double energy_error(const HistoryRow& first, const HistoryRow& last, double largest_work) {
  const double scale = std::max({largest_work, first.kinetic_energy, first.strain_energy});
  return scale > 0.0 ? (residual(last) - residual(first)) / scale : 0.0;
}

}  // namespace rgimp
