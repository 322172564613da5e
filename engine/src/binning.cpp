#include "binning.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "lane_chunks.hpp"

namespace rgimp {
namespace {

using kernels::kGroupWidth;

/// Where a lane of the new layout takes its particle from.
using Source = Column<std::uint32_t>;
constexpr std::uint32_t kNoSource = std::numeric_limits<std::uint32_t>::max();

/// The particle's nearest node, whose neighbours on every side are in the grid too; none for a
/// particle that is not inside.
template <int Dim>
std::optional<std::uint32_t> bin_of(const Particles<Dim>& particles, const Grid<Dim>& grid,
                                    int layer, std::size_t index) {
  const GridExtent& extent = grid.extent(layer);
  const std::ptrdiff_t stride[3] = {1, grid.row_stride(), grid.row_stride() * extent.nodes[1]};
  std::ptrdiff_t bin = 0;
  for (int a = 0; a < Dim; ++a) {
    const double cells = (particles.position[a][index] - extent.origin[a]) / extent.spacing[a];
    const double node = std::floor(cells + 0.5);
    if (!(node >= 1.0 && node <= static_cast<double>(extent.nodes[a] - 2))) {
      return std::nullopt;
    }
    bin += static_cast<std::ptrdiff_t>(node) * stride[a];
  }
  return static_cast<std::uint32_t>(bin);
}

/// Bins from `first` to before `last`.
struct BinRange {
  std::uint32_t first;
  std::uint32_t last;
};

/// Bins that one task sorts into: whole groups. How many there are changes nothing but how evenly
/// tasks are spread.
class Stripes {
 public:
  Stripes(std::size_t groups, const Workers& workers)
      : groups_(groups), count_(std::min(groups, kPerThread * workers.threads())) {}

  std::size_t groups() const { return groups_; }

  /// visit(bins) for all stripes, on all threads.
  template <typename Visit>
  void for_each(Workers& workers, Visit visit) const {
    workers.for_each(static_cast<std::ptrdiff_t>(count_), [&](std::ptrdiff_t index) {
      visit(BinRange{first_bin(static_cast<std::size_t>(index)),
                     first_bin(static_cast<std::size_t>(index) + 1)});
    });
  }

 private:
  static constexpr std::size_t kPerThread = 4;

  std::uint32_t first_bin(std::size_t stripe) const {
    return static_cast<std::uint32_t>(groups_ * stripe / count_ * kGroupWidth);
  }

  std::size_t groups_;
  std::size_t count_;
};

/// The bins that the particles of all lanes belong in.
class BinsOfLanes {
 public:
  template <int Dim>
  BinsOfLanes(const Particles<Dim>& particles, const Grid<Dim>& grid, int layer, Workers& workers)
      : bin_(particles.lanes()), chunks_(chunks_of(particles.lanes())) {
    for_each_chunk(bin_.size(), workers, [&](std::size_t chunk, LaneRange lanes) {
      chunks_[chunk] = find_bins(particles, grid, layer, lanes);
    });
  }

  /// Lanes of the particles that belong in none.
  std::vector<std::size_t> outside() const {
    std::vector<std::size_t> lanes;
    for (const Chunk& chunk : chunks_) {
      lanes.insert(lanes.end(), chunk.outside.begin(), chunk.outside.end());
    }
    return lanes;
  }

  /// visit(lane, bin) for the particles of some bins, by rising lane. As lanes lie in about the
  /// order of their bins already, few chunks have any.
  template <typename Visit>
  void for_each_in(BinRange bins, Visit visit) const {
    for (std::size_t chunk = 0; chunk < chunks_.size(); ++chunk) {
      if (chunks_[chunk].lowest >= bins.last || chunks_[chunk].highest < bins.first) {
        continue;
      }
      const LaneRange lanes = lanes_of_chunk(chunk, bin_.size());
      for (std::size_t lane = lanes.first; lane < lanes.last; ++lane) {
        if (bin_[lane] >= bins.first && bin_[lane] < bins.last) {
          visit(lane, bin_[lane]);
        }
      }
    }
  }

 private:
  static constexpr std::uint32_t kNoBin = std::numeric_limits<std::uint32_t>::max();

  struct Chunk {
    std::uint32_t lowest = kNoBin;
    std::uint32_t highest = 0;
    std::vector<std::size_t> outside;
  };

  template <int Dim>
  Chunk find_bins(const Particles<Dim>& particles, const Grid<Dim>& grid, int layer,
                  LaneRange lanes) {
    Chunk chunk;
    for (std::size_t lane = lanes.first; lane < lanes.last; ++lane) {
      bin_[lane] = kNoBin;
      if (particles.is_padding(lane)) {
        continue;
      }
      if (const std::optional<std::uint32_t> bin = bin_of(particles, grid, layer, lane)) {
        bin_[lane] = *bin;
        chunk.lowest = std::min(chunk.lowest, *bin);
        chunk.highest = std::max(chunk.highest, *bin);
      } else {
        chunk.outside.push_back(lane);
      }
    }
    return chunk;
  }

  Column<std::uint32_t> bin_;  // by lane
  std::vector<Chunk> chunks_;  // of lanes
};

/// The new layout: every slot of a group holds one material, so that kernels read its constants
/// once for eight lanes.
class Layout {
 public:
  Layout(std::size_t bins, std::size_t materials)
      : materials_(materials), count_(bins * materials) {}

  void add(std::size_t bin, std::size_t material) { ++count_[bin * materials_ + material]; }

  template <int Dim>
  void place_slots(Particles<Dim>& particles) {
    const std::size_t groups = count_.size() / materials_ / kGroupWidth;
    particles.group_begin.assign(groups + 1, 0);
    particles.slot_material.clear();
    first_slot_.resize(groups * materials_);
    for (std::size_t group = 0; group < groups; ++group) {
      for (std::size_t material = 0; material < materials_; ++material) {
        first_slot_[group * materials_ + material] =
            static_cast<std::uint32_t>(particles.slot_material.size());
        particles.slot_material.insert(particles.slot_material.end(), deepest(group, material),
                                       static_cast<std::uint8_t>(material));
      }
      particles.group_begin[group + 1] = static_cast<std::uint32_t>(particles.slot_material.size());
    }
    std::fill(count_.begin(), count_.end(), 0);
  }

  /// The next free lane of a bin, after place_slots.
  std::size_t next_lane(std::size_t bin, std::size_t material) {
    const std::size_t slot = first_slot_[bin / kGroupWidth * materials_ + material] +
                             count_[bin * materials_ + material]++;
    return slot * kGroupWidth + bin % kGroupWidth;
  }

 private:
  std::uint32_t deepest(std::size_t group, std::size_t material) const {
    std::uint32_t most = 0;
    for (std::size_t bin = group * kGroupWidth; bin < (group + 1) * kGroupWidth; ++bin) {
      most = std::max(most, count_[bin * materials_ + material]);
    }
    return most;
  }

  std::size_t materials_;
  std::vector<std::uint32_t> count_;  // by bin, then material
  std::vector<std::uint32_t> first_slot_;
};

template <typename Column, typename Value>
void permute(Column& column, const Source& source, Value padding, Workers& workers) {
  Column scratch(source.size());
  for_each_chunk(source.size(), workers, [&](std::size_t, LaneRange lanes) {
    for (std::size_t lane = lanes.first; lane < lanes.last; ++lane) {
      scratch[lane] = source[lane] == kNoSource ? padding : column[source[lane]];
    }
  });
  std::swap(column, scratch);
}

template <int Dim>
LaneRange lanes_of(const Particles<Dim>& particles, BinRange bins) {
  return {particles.group_begin[bins.first / kGroupWidth] * kGroupWidth,
          particles.group_begin[bins.last / kGroupWidth] * kGroupWidth};
}

template <int Dim>
void put_padding_on_nodes(Particles<Dim>& particles, const Grid<Dim>& grid, int layer,
                          BinRange group) {
  const LaneRange lanes = lanes_of(particles, group);
  for (std::size_t index = lanes.first; index < lanes.last; ++index) {
    if (particles.is_padding(index)) {
      const std::size_t bin = group.first + index % kGroupWidth;
      const Vector node = grid.position(static_cast<std::ptrdiff_t>(bin), layer);
      for (int a = 0; a < Dim; ++a) {
        particles.position[a][index] = node[a];
      }
    }
  }
}

template <int Dim>
void put_padding_on_nodes(Particles<Dim>& particles, const Grid<Dim>& grid, int layer,
                          const Stripes& stripes, Workers& workers) {
  stripes.for_each(workers, [&](BinRange stripe) {
    for (std::uint32_t bin = stripe.first; bin < stripe.last; bin += kGroupWidth) {
      put_padding_on_nodes(particles, grid, layer, {bin, bin + kGroupWidth});
    }
  });
}

/// Lays the particles out anew, and says where each lane takes its particle from.
template <int Dim>
Source lay_out(Particles<Dim>& particles, const BinsOfLanes& bins, const Stripes& stripes,
               const std::vector<std::uint8_t>& material_of_id, Workers& workers) {
  const std::size_t materials =
      1 + static_cast<std::size_t>(*std::max_element(material_of_id.begin(), material_of_id.end()));
  Layout layout(stripes.groups() * kGroupWidth, materials);
  stripes.for_each(workers, [&](BinRange stripe) {
    bins.for_each_in(stripe, [&](std::size_t lane, std::uint32_t bin) {
      layout.add(bin, material_of_id[particles.id[lane]]);
    });
  });
  layout.place_slots(particles);
  Source source(particles.slot_material.size() * kGroupWidth);
  stripes.for_each(workers, [&](BinRange stripe) {
    const LaneRange lanes = lanes_of(particles, stripe);
    std::fill(source.data() + lanes.first, source.data() + lanes.last, kNoSource);
    bins.for_each_in(stripe, [&](std::size_t lane, std::uint32_t bin) {
      source[layout.next_lane(bin, material_of_id[particles.id[lane]])] =
          static_cast<std::uint32_t>(lane);
    });
  });
  return source;
}

}  // namespace

template <int Dim>
std::vector<std::size_t> bin_particles(Particles<Dim>& particles,
                                       const std::vector<std::uint8_t>& material_of_id,
                                       const Grid<Dim>& grid, Workers& workers, int layer) {
  const BinsOfLanes bins(particles, grid, layer, workers);
  if (std::vector<std::size_t> outside = bins.outside(); !outside.empty()) {
    std::sort(outside.begin(), outside.end(),
              [&](std::size_t a, std::size_t b) { return particles.id[a] < particles.id[b]; });
    return outside;
  }
  const Stripes stripes(static_cast<std::size_t>(grid.rows() * grid.groups_in_row()), workers);
  const Source source = lay_out(particles, bins, stripes, material_of_id, workers);
  particles.for_each_column(
      [&](auto& column, auto padding) { permute(column, source, padding, workers); });
  put_padding_on_nodes(particles, grid, layer, stripes, workers);
  return {};
}

template std::vector<std::size_t> bin_particles<2>(Particles<2>&, const std::vector<std::uint8_t>&,
                                                   const Grid<2>&, Workers&, int);
template std::vector<std::size_t> bin_particles<3>(Particles<3>&, const std::vector<std::uint8_t>&,
                                                   const Grid<3>&, Workers&, int);

}  // namespace rgimp
