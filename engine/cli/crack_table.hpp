#pragma once

#include <string>

#include "rgimp/crack_clusters.hpp"
#include "rgimp/cracks.hpp"

namespace rgimp::cli {

/// Counts, a line for each wing and one for each event, for people.
std::string format_cracks(const Cracks& cracks);

/// The same of a three-dimensional case, with a line for each cluster.
std::string format_clusters(const CrackClusters& cracks);

}  // namespace rgimp::cli
