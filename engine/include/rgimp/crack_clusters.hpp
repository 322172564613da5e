#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "rgimp/case.hpp"
#include "rgimp/simulation.hpp"

/// Cracks of three-dimensional cases. Lines that grow from tips, the wings of cracks.hpp, are not
/// what a crack is in space: along the rim of a flaw there are no tips to tell cracks apart by.
/// Here a crack is a cluster: failed particles that touch one another, none of them in the layer of
/// one cell around a flaw. It starts within two cells of a flaw and gets farther than two cells
/// from all of them; or it comes near none, and gets two cells from its first particle. Places are
/// those of step 0.
namespace rgimp {

/// A failed particle of a cluster.
struct ClusterParticle {
  std::int64_t step = 0;             ///< at which it failed
  Vector position = Vector::Zero();  ///< m, at step 0
  /// m, from the nearest flaw's surface; in a cluster that comes near none, from its first particle
  double distance = 0.0;
  std::optional<std::size_t> flaw;  ///< that one, where it is within two cells
};

/// Failed particles that touch, two cells or more from end to end; see above.
struct CrackCluster {
  std::string name;                        ///< "crack 1", ...: in the order of their first failures
  std::vector<std::size_t> flaws;          ///< that it comes within two cells of, rising; or none
  std::vector<ClusterParticle> particles;  ///< in the order of `step`
};

/// How far a cluster had come at a step.
struct ClusterExtent {
  /// At its end.
  std::int64_t step = 0;
  /// Particles.
  std::size_t failed = 0;
  Vector min = Vector::Zero();       ///< m, of the failed particles' centres
  Vector max = Vector::Zero();       ///< m
  Vector farthest = Vector::Zero();  ///< m, the place of the largest ClusterParticle::distance
  double distance = 0.0;             ///< m, that distance
  /// m2, volume that failed / cell size. The bands that fail are about a cell wide, wider where a
  /// crack is oblique to the grid, and this is then too large.
  double area = 0.0;
};

/// A cluster starts, or comes within one cell of a side of the bodies.
struct ClusterEvent {
  /// At its end.
  std::int64_t step = 0;
  /// Of CrackClusters::clusters, by name.
  std::string cluster;
  std::optional<Side> side;  ///< none: its first failure
  /// m, of the particle.
  Vector position = Vector::Zero();
};

/// All that is known about the cracks of one state in three dimensions.
struct CrackClusters {
  /// Of all particles, in a cluster or not; its distance is infinite in a case without flaws.
  std::optional<ClusterParticle> first;
  /// In the order of their first failures.
  std::vector<CrackCluster> clusters;
  std::vector<ClusterEvent> events;  ///< in order of step
  std::size_t outline = 0;           ///< failed along faces of flaws, in no cluster
  std::size_t elsewhere = 0;         ///< failed, in no cluster, near no flaw
  double area_of_particle = 0.0;     ///< m2, volume of a particle / cell size
};

/// The cracks in `particles`, a state of the case `settings`. Throws CaseError where the case has
/// not three dimensions, or the particles are not those of the case.
CrackClusters trace_clusters(const Case& settings, const ParticleTable& particles);

/// The cluster's extent over the steps: an entry each time that it got farther, and one for all of
/// it. Of particles that have failed by then, also of those that the crack came to
/// only later.
std::vector<ClusterExtent> trace_extent(const CrackClusters& cracks, const CrackCluster& cluster);

/// "crack 1 starts", "crack 2 reaches the top side".
std::string describe(const ClusterEvent& event);

/// Clusters with their extents over the steps, and events, as JSON; lengths in m.
std::string json_text(const CrackClusters& cracks);

/// Writes json_text(). Throws FileError.
void write_clusters(const std::filesystem::path& path, const CrackClusters& cracks);

}  // namespace rgimp
