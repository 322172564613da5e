#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "crack_table.hpp"
#include "format.hpp"

namespace rgimp::cli {

namespace {

std::string in_mm(const Vector& position) {
  return fmt::format("({:.2f}, {:.2f}, {:.2f})", position.x() * 1e3, position.y() * 1e3,
                     position.z() * 1e3);
}

std::string counted(std::size_t count) {
  return with_separators(static_cast<std::int64_t>(count));
}

constexpr std::string_view kClusterLine =
    "{:<9} {:>6} {:>8} {:>10} {:>24} {:>9} {:>24} {:>10} {:>22} {:>8}\n";

std::string format_cluster(const CrackClusters& cracks, const CrackCluster& cluster) {
  const ClusterParticle& first = cluster.particles.front();
  const std::vector<ClusterExtent> extents = trace_extent(cracks, cluster);
  const ClusterExtent& end = extents.back();
  // The last entry may only count more particles: the front's step is that of the farthest place.
  const auto front = std::find_if(extents.begin(), extents.end(), [&](const ClusterExtent& extent) {
    return extent.distance == end.distance;
  });
  const Vector size = (end.max - end.min) * 1e3;
  return fmt::format(kClusterLine, cluster.name,
                     cluster.flaws.empty() ? "-" : fmt::format("{}", fmt::join(cluster.flaws, ",")),
                     counted(cluster.particles.size()), with_separators(first.step),
                     in_mm(first.position), fmt::format("{:.2f}", end.distance * 1e3),
                     in_mm(end.farthest), with_separators(front->step),
                     fmt::format("{:.1f} x {:.1f} x {:.1f}", size.x(), size.y(), size.z()),
                     fmt::format("{:.0f}", end.area * 1e6));
}

std::string format_first(const ClusterParticle& first) {
  const std::string where =
      first.flaw ? fmt::format("{:.2f} mm from flaw[{}]", first.distance * 1e3, *first.flaw)
                 : std::string("near no flaw");
  return fmt::format("First failure: step {} at {} mm, {}\n", with_separators(first.step),
                     in_mm(first.position), where);
}

}  // namespace

std::string format_clusters(const CrackClusters& cracks) {
  std::size_t in_clusters = 0;
  for (const CrackCluster& cluster : cracks.clusters) {
    in_clusters += cluster.particles.size();
  }
  std::string text =
      fmt::format("{} failed: {} in cracks, {} along faces of flaws, {} elsewhere\n",
                  counted(in_clusters + cracks.outline + cracks.elsewhere), counted(in_clusters),
                  counted(cracks.outline), counted(cracks.elsewhere));
  if (cracks.first) {
    text += format_first(*cracks.first);
  }
  if (!cracks.clusters.empty()) {
    text +=
        "\nCracks: mm, farthest from the flaw or, without one, from the start; areas in mm2, "
        "failed "
        "volume / cell size\n";
    text += fmt::format(kClusterLine, "crack", "flaws", "failed", "from step", "from", "farthest",
                        "at", "at step", "extent", "area");
  }
  for (const CrackCluster& cluster : cracks.clusters) {
    text += format_cluster(cracks, cluster);
  }
  if (!cracks.events.empty()) {
    text += "\nEvents\n";
  }
  for (const ClusterEvent& event : cracks.events) {
    text += fmt::format("{:>11}  {}, {} mm\n", with_separators(event.step), describe(event),
                        in_mm(event.position));
  }
  return text;
}

}  // namespace rgimp::cli
