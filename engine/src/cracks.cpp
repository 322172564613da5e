#include "rgimp/cracks.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "crack_geometry.hpp"
#include "crack_growth.hpp"
#include "failed_particles.hpp"
#include "platen_geometry.hpp"
#include "rgimp/error.hpp"

namespace rgimp {

namespace {

/// The place of its flaw that a particle within one cell of a flaw lies at.
void assign_sources(const std::vector<CrackSource>& sources, std::vector<FailedParticle>& failed) {
  for (FailedParticle& particle : failed) {
    double nearest_source = std::numeric_limits<double>::infinity();
    for (std::size_t s = 0; s < sources.size(); ++s) {
      const double distance = (sources[s].position - particle.position).norm();
      if (particle.flaw == sources[s].flaw && distance < nearest_source) {
        nearest_source = distance;
        particle.source = s;
      }
    }
  }
}

/// The events of one wing alone: its start, and the sides of the bodies that it reaches. A particle
/// reaches a side where it touches the cell there, whose nodes a platen would hold.
void add_events(std::vector<CrackEvent>& events, const Case& settings, const Wing& wing) {
  const CrackParticle& first = wing.particles.front();
  events.push_back({first.step, CrackEventKind::first_failure, wing.name, std::nullopt,
                    std::nullopt, first.position});
  const double reach = settings.grid.cell_size + 0.5 * finest_pitch(settings);
  std::vector<Side> reached;
  for (const CrackParticle& particle : wing.particles) {
    const auto side = side_within(settings, particle.position, reach);
    if (side && std::find(reached.begin(), reached.end(), *side) == reached.end()) {
      reached.push_back(*side);
      events.push_back({particle.step, CrackEventKind::arrival, wing.name, std::nullopt, side,
                        particle.position});
    }
  }
}

/// Wings of a source are numbered from the second on: A, A2, A3.
std::vector<std::string> crack_names(const std::vector<CrackSource>& sources,
                                     const std::vector<Crack>& cracks) {
  std::vector<int> count(sources.size());
  std::vector<std::string> names;
  for (const Crack& crack : cracks) {
    const int number = crack.particles.empty() ? 0 : ++count[crack.source];
    names.push_back(sources[crack.source].name + (number > 1 ? fmt::format("{}", number) : ""));
  }
  return names;
}

std::vector<Wing> collect_wings(const std::vector<CrackSource>& sources,
                                const std::vector<Crack>& cracks,
                                const std::vector<std::string>& names) {
  std::vector<Wing> wings;
  for (std::size_t s = 0; s < sources.size(); ++s) {
    bool cracked = false;
    for (std::size_t c = 0; c < cracks.size(); ++c) {
      if (cracks[c].source == s && !cracks[c].particles.empty()) {
        cracked = true;
        wings.push_back({names[c], sources[s].flaw, sources[s].position, cracks[c].particles});
      }
    }
    if (!cracked && sources[s].is_tip) {
      wings.push_back({sources[s].name, sources[s].flaw, sources[s].position, {}});
    }
  }
  return wings;
}

}  // namespace

Cracks trace_cracks(const Case& settings, const ParticleTable& particles) {
  if (settings.dimension != 2) {
    throw CaseError(
        "wings are measured in two dimensions; trace_clusters measures the cracks of "
        "a three-dimensional case");
  }
  const std::vector<CrackSource> sources = crack_sources(settings);
  std::vector<FailedParticle> failed = failed_particles(settings, particles);
  assign_sources(sources, failed);
  const CrackGrowth growth = grow_cracks(failed, {finest_pitch(settings), settings.grid.cell_size});
  const std::vector<std::string> names = crack_names(sources, growth.cracks);
  const auto name_of = [&](const CrackPlace& place) {
    return place.crack ? names[*place.crack] : sources[place.source].name;
  };

  Cracks cracks;
  cracks.wings = collect_wings(sources, growth.cracks, names);
  cracks.outline = growth.outline;
  cracks.elsewhere = growth.elsewhere;
  cracks.load_axis = load_axis(settings);
  for (const Wing& wing : cracks.wings) {
    if (!wing.particles.empty()) {
      add_events(cracks.events, settings, wing);
    }
  }
  for (const Meeting& meeting : growth.meetings) {
    cracks.events.push_back({meeting.step, CrackEventKind::coalescence, name_of(meeting.one),
                             name_of(meeting.other), std::nullopt, meeting.position});
  }
  std::stable_sort(cracks.events.begin(), cracks.events.end(),
                   [](const CrackEvent& a, const CrackEvent& b) { return a.step < b.step; });
  return cracks;
}

std::vector<CrackFront> trace_front(const Wing& wing) {
  std::vector<CrackFront> front;
  for (const CrackParticle& particle : wing.particles) {
    const double length = (particle.position - wing.particles.front().position).norm();
    if (front.empty() || length > front.back().length) {
      front.push_back({particle.step, particle.position, length});
    }
  }
  return front;
}

std::optional<double> wing_angle(const Wing& wing, double span) {
  Vector sum = Vector::Zero();
  Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
  double count = 0.0;
  for (const CrackParticle& particle : wing.particles) {
    const Vector offset = particle.position - wing.particles.front().position;
    sum += offset;
    moments += offset * offset.transpose();
    count += 1.0;
    if (offset.norm() >= span) {
      const Eigen::Matrix3d scatter = moments - sum * sum.transpose() / count;
      const Vector line = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(scatter)
                              .eigenvectors()
                              .rightCols<1>();  // of the largest eigenvalue
      const Vector way = line.dot(sum) < 0.0 ? Vector(-line) : line;
      return std::atan2(way.y(), way.x()) * 180.0 / std::numbers::pi;
    }
  }
  return std::nullopt;
}

std::optional<double> angle_to_load(const Cracks& cracks, double angle) {
  if (!cracks.load_axis) {
    return std::nullopt;
  }
  return std::abs(std::remainder(angle - 90.0 * *cracks.load_axis, 180.0));
}

}  // namespace rgimp
