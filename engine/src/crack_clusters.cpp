#include "rgimp/crack_clusters.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "case_names.hpp"
#include "crack_geometry.hpp"
#include "failed_particles.hpp"
#include "neighbours.hpp"
#include "rgimp/error.hpp"

namespace rgimp {

namespace {

using Group = std::vector<std::size_t>;  ///< indices of failed particles, rising

/// The groups of failed particles that touch one another out of the flaws' layers, in the order of
/// their first failures. The layers are left out since they would join all cracks of a flaw whose
/// rim has failed all around.
std::vector<Group> find_groups(const std::vector<FailedParticle>& failed, double pitch) {
  const Neighbours neighbours(failed, pitch);
  std::vector<char> seen(failed.size());
  std::vector<Group> groups;
  for (std::size_t first = 0; first < failed.size(); ++first) {
    if (seen[first] != 0 || failed[first].flaw) {
      continue;
    }
    Group group{first};
    seen[first] = 1;
    for (std::size_t next = 0; next < group.size(); ++next) {  // the group grows meanwhile
      neighbours.for_each(group[next], [&](std::size_t other) {
        if (seen[other] == 0 && !failed[other].flaw) {
          seen[other] = 1;
          group.push_back(other);
        }
      });
    }
    std::sort(group.begin(), group.end());
    groups.push_back(group);
  }
  return groups;
}

class ClusterFinder {
 public:
  ClusterFinder(const Case& settings, const std::vector<FailedParticle>& failed)
      : settings_(settings), failed_(failed), two_cells_(2.0 * settings.grid.cell_size) {}

  CrackClusters find() {
    const double pitch = finest_pitch(settings_);
    cracks_.area_of_particle = pitch * pitch * pitch / settings_.grid.cell_size;
    if (!failed_.empty()) {
      cracks_.first = particle(0);
    }
    const auto in_layer = [](const FailedParticle& particle) { return particle.flaw.has_value(); };
    cracks_.outline =
        static_cast<std::size_t>(std::count_if(failed_.begin(), failed_.end(), in_layer));
    for (const Group& group : find_groups(failed_, pitch)) {
      add(group);
    }
    std::stable_sort(cracks_.events.begin(), cracks_.events.end(),
                     [](const ClusterEvent& a, const ClusterEvent& b) { return a.step < b.step; });
    return cracks_;
  }

 private:
  ClusterParticle particle(std::size_t index) const {
    const FailedParticle& failed = failed_[index];
    const bool near = failed.distance <= two_cells_;
    return {failed.step, failed.position, failed.distance,
            near ? failed.nearest_flaw : std::nullopt};
  }

  /// What never gets two cells from the flaws is a step of an oblique face that sticks out of the
  /// layer.
  void add(const Group& group) {
    CrackCluster cluster;
    std::set<std::size_t> flaws;
    for (const std::size_t index : group) {
      cluster.particles.push_back(particle(index));
      if (cluster.particles.back().flaw) {
        flaws.insert(*cluster.particles.back().flaw);
      }
    }
    if (flaws.empty()) {
      measure_from_start(cluster);
    }
    const auto is_away = [&](const ClusterParticle& at) { return at.distance > two_cells_; };
    if (std::none_of(cluster.particles.begin(), cluster.particles.end(), is_away)) {
      (flaws.empty() ? cracks_.elsewhere : cracks_.outline) += group.size();
      return;
    }
    cluster.flaws.assign(flaws.begin(), flaws.end());
    cluster.name = fmt::format("crack {}", cracks_.clusters.size() + 1);
    add_events(cluster);
    cracks_.clusters.push_back(std::move(cluster));
  }

  static void measure_from_start(CrackCluster& cluster) {
    const Vector start = cluster.particles.front().position;
    for (ClusterParticle& particle : cluster.particles) {
      particle.distance = (particle.position - start).norm();
    }
  }

  /// A side is reached where the cell there is touched, whose nodes a platen would hold.
  void add_events(const CrackCluster& cluster) {
    const ClusterParticle& first = cluster.particles.front();
    cracks_.events.push_back({first.step, cluster.name, std::nullopt, first.position});
    const double reach = settings_.grid.cell_size + 0.5 * finest_pitch(settings_);
    std::set<Side> reached;
    for (const ClusterParticle& particle : cluster.particles) {
      const auto side = side_within(settings_, particle.position, reach);
      if (side && reached.insert(*side).second) {
        cracks_.events.push_back({particle.step, cluster.name, side, particle.position});
      }
    }
  }

  const Case& settings_;
  const std::vector<FailedParticle>& failed_;
  double two_cells_;  // m
  CrackClusters cracks_;
};

}  // namespace

CrackClusters trace_clusters(const Case& settings, const ParticleTable& particles) {
  if (settings.dimension != 3) {
    throw CaseError(
        "clusters are measured in three dimensions; trace_cracks measures the wings of "
        "a two-dimensional case");
  }
  return ClusterFinder(settings, failed_particles(settings, particles)).find();
}

std::vector<ClusterExtent> trace_extent(const CrackClusters& cracks, const CrackCluster& cluster) {
  std::vector<ClusterExtent> extents;
  ClusterExtent now;
  now.min = now.max = cluster.particles.front().position;
  for (const ClusterParticle& particle : cluster.particles) {
    now.step = particle.step;
    now.area = static_cast<double>(++now.failed) * cracks.area_of_particle;
    now.min = now.min.cwiseMin(particle.position);
    now.max = now.max.cwiseMax(particle.position);
    if (extents.empty() || particle.distance > now.distance) {
      now.distance = particle.distance;
      now.farthest = particle.position;
      extents.push_back(now);
    }
  }
  if (extents.back().failed != now.failed) {
    extents.push_back(now);
  }
  return extents;
}

std::string describe(const ClusterEvent& event) {
  return event.side ? fmt::format("{} reaches the {} side", event.cluster, name_of(*event.side))
                    : fmt::format("{} starts", event.cluster);
}

}  // namespace rgimp
