#include "ledger.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry.hpp"

namespace rgimp {
namespace {

constexpr double kAxisTolerance = 1e-9;

/// Of the bounding box, but of the circle for one cylinder that is loaded along its axis.
double area_across(const Case& settings, int load_axis) {
  const Box box = bounds(settings);
  const Vector size = box.max - box.min;
  if (settings.dimension == 2) {
    return size[load_axis == 0 ? 1 : 0];
  }
  const Body& body = settings.bodies.front();
  const bool is_core = settings.bodies.size() == 1 && body.shape == BodyShape::cylinder &&
                       std::abs(body.axis.normalized()[load_axis]) > 1.0 - kAxisTolerance;
  const double rectangle = size[(load_axis + 1) % 3] * size[(load_axis + 2) % 3];
  return is_core ? 0.25 * std::numbers::pi * body.size.x() * body.size.x() : rectangle;
}

}  // namespace

Ledger::Ledger(const Case& settings, std::size_t rows)
    : platens_(settings.platens),
      load_axis_(load_axis(settings).value_or(1)),
      area_(area_across(settings, load_axis_)),
      nodes_(rows),
      particles_(rows),
      reach_(rows),
      platen_sums_(rows, PlatenSums{0.0, std::vector<double>(platens_.size(), 0.0)}),
      reaction_of_platen_(platens_.size(), 0.0) {}

void Ledger::add_nodes() {
  std::fill(reaction_of_platen_.begin(), reaction_of_platen_.end(), 0.0);
  for (std::size_t row = 0; row < nodes_.size(); ++row) {
    budget_.external_work += nodes_[row].body_force_work + platen_sums_[row].work;
    budget_.damping_work += nodes_[row].damping_work;
    for (std::size_t p = 0; p < platens_.size(); ++p) {
      reaction_of_platen_[p] += platen_sums_[row].reaction[p];
    }
  }
  peak_axial_stress_ = std::max(peak_axial_stress_, axial_stress());
}

void Ledger::add_particles(double dt) {
  farthest_ = 0.0;
  double longest_move = 0.0;
  for (std::size_t row = 0; row < particles_.size(); ++row) {
    budget_.viscous_work += particles_[row].viscous_work;
    budget_.released_energy += particles_[row].released_energy;
    failed_tension_ += particles_[row].failed_tension;
    failed_shear_ += particles_[row].failed_shear;
    farthest_ = std::max(farthest_, reach_[row].distance);
    longest_move = std::max(longest_move, reach_[row].step);
  }
  max_speed_ = longest_move / dt;
}

void Ledger::add_failures(const OwnFailures& failures) {
  budget_.released_energy += failures.released_energy;
  failed_tension_ += failures.tension;
  failed_shear_ += failures.shear;
}

bool Ledger::is_on_load_axis(const Platen& platen) const {
  return axis_of(platen.side).axis == load_axis_;
}

double Ledger::reaction() const {
  double sum = 0.0;
  int opposed = 0;
  for (std::size_t p = 0; p < platens_.size(); ++p) {
    if (is_on_load_axis(platens_[p])) {
      sum += reaction_of_platen_[p];
      ++opposed;
    }
  }
  return opposed > 0 ? sum / opposed : 0.0;
}

double Ledger::closure(double time) const {
  double sum = 0.0;
  for (const Platen& platen : platens_) {
    sum += is_on_load_axis(platen) ? platen_travel(platen, time) : 0.0;
  }
  return sum;
}

void Ledger::remove(double mass, double energy) {
  ++removed_.particles;
  removed_.mass += mass;
  removed_.energy += energy;
}

bool Ledger::is_finite() const {
  return std::isfinite(budget_.damping_work) && std::isfinite(budget_.external_work) &&
         std::isfinite(budget_.viscous_work) && std::isfinite(budget_.released_energy);
}

std::vector<double> Ledger::pending() const {
  std::vector<double> values;
  for (std::size_t row = 0; row < nodes_.size(); ++row) {
    values.push_back(nodes_[row].damping_work);
    values.push_back(nodes_[row].body_force_work);
    values.push_back(platen_sums_[row].work);
    values.insert(values.end(), platen_sums_[row].reaction.begin(),
                  platen_sums_[row].reaction.end());
  }
  return values;
}

bool Ledger::set_pending(const std::vector<double>& values) {
  if (values.size() != nodes_.size() * (3 + platens_.size()) ||
      reaction_of_platen_.size() != platens_.size()) {
    return false;
  }
  auto value = values.begin();
  for (std::size_t row = 0; row < nodes_.size(); ++row) {
    nodes_[row].damping_work = *value++;
    nodes_[row].body_force_work = *value++;
    platen_sums_[row].work = *value++;
    for (double& reaction : platen_sums_[row].reaction) {
      reaction = *value++;
    }
  }
  return true;
}

}  // namespace rgimp
