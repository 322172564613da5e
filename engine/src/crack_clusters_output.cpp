#include <cmath>

#include "atomic_file.hpp"
#include "case_names.hpp"
#include "json.hpp"
#include "rgimp/crack_clusters.hpp"

namespace rgimp {

namespace {

Json to_json(const ClusterExtent& extent) {
  return {{"step", extent.step},
          {"failed", extent.failed},
          {"min_m", vector_json(extent.min)},
          {"max_m", vector_json(extent.max)},
          {"farthest_m", vector_json(extent.farthest)},
          {"distance_m", extent.distance},
          {"area_m2", extent.area}};
}

Json to_json(const CrackCluster& cluster, const CrackClusters& cracks) {
  Json extents = Json::array();
  for (const ClusterExtent& extent : trace_extent(cracks, cluster)) {
    extents.push_back(to_json(extent));
  }
  return {{"name", cluster.name},
          {"flaws", cluster.flaws},
          {"failed", cluster.particles.size()},
          {"extent", extents}};
}

Json to_json(const ClusterEvent& event) {
  return {{"step", event.step},
          {"event", describe(event)},
          {"crack", event.cluster},
          {"side", event.side ? Json(name_of(*event.side)) : Json()},
          {"position_m", vector_json(event.position)}};
}

Json to_json(const std::optional<ClusterParticle>& first) {
  if (!first) {
    return {};
  }
  return {{"step", first->step},
          {"position_m", vector_json(first->position)},
          {"distance_m", std::isfinite(first->distance) ? Json(first->distance) : Json()},
          {"flaw", first->flaw ? Json(*first->flaw) : Json()}};
}

}  // namespace

std::string json_text(const CrackClusters& cracks) {
  Json clusters = Json::array();
  std::size_t failed = cracks.outline + cracks.elsewhere;
  for (const CrackCluster& cluster : cracks.clusters) {
    failed += cluster.particles.size();
    clusters.push_back(to_json(cluster, cracks));
  }
  Json events = Json::array();
  for (const ClusterEvent& event : cracks.events) {
    events.push_back(to_json(event));
  }
  const Json json{{"failed", failed},
                  {"outline", cracks.outline},
                  {"elsewhere", cracks.elsewhere},
                  {"first_failure", to_json(cracks.first)},
                  {"cracks", clusters},
                  {"events", events}};
  return json.dump(1) + "\n";
}

void write_clusters(const std::filesystem::path& path, const CrackClusters& cracks) {
  write_file(path, json_text(cracks));
}

}  // namespace rgimp
