#include "binning.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace rgimp {
namespace {

using kernels::kGroupWidth;

/// Where a lane of the new layout takes its particle from.
using Source = std::vector<std::uint32_t>;
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
  constexpr std::size_t kChunk = 1 << 14;
  Column scratch(source.size());
  const auto chunks = static_cast<std::ptrdiff_t>((source.size() + kChunk - 1) / kChunk);
  workers.for_each(chunks, [&](std::ptrdiff_t chunk) {
    const std::size_t first = static_cast<std::size_t>(chunk) * kChunk;
    const std::size_t last = std::min(first + kChunk, source.size());
    for (std::size_t lane = first; lane < last; ++lane) {
      scratch[lane] = source[lane] == kNoSource ? padding : column[source[lane]];
    }
  });
  std::swap(column, scratch);
}

template <int Dim>
void put_padding_on_nodes(Particles<Dim>& particles, const Grid<Dim>& grid, int layer) {
  for (std::size_t group = 0; group + 1 < particles.group_begin.size(); ++group) {
    const std::size_t first = particles.group_begin[group] * kGroupWidth;
    const std::size_t last = particles.group_begin[group + 1] * kGroupWidth;
    for (std::size_t index = first; index < last; ++index) {
      if (particles.is_padding(index)) {
        const std::size_t bin = group * kGroupWidth + index % kGroupWidth;
        const Vector node = grid.position(static_cast<std::ptrdiff_t>(bin), layer);
        for (int a = 0; a < Dim; ++a) {
          particles.position[a][index] = node[a];
        }
      }
    }
  }
}

}  // namespace

template <int Dim>
Particles<Dim> particles_from(const std::vector<ParticleSeed>& seeds) {
  Particles<Dim> particles;
  particles.count = seeds.size();
  particles.for_each_column([&](auto& column, auto) { column.assign(seeds.size(), {}); });
  for (std::size_t i = 0; i < seeds.size(); ++i) {
    for (int a = 0; a < Dim; ++a) {
      particles.position[a][i] = seeds[i].position[a];
      particles.velocity[a][i] = seeds[i].velocity[a];
    }
    particles.volume[i] = seeds[i].volume;
    particles.mass[i] = seeds[i].mass;
    particles.failure_step[i] = -1;
    particles.id[i] = static_cast<std::uint32_t>(i);
  }
  return particles;
}

template <int Dim>
std::vector<std::size_t> bin_particles(Particles<Dim>& particles,
                                       const std::vector<std::uint8_t>& material_of_id,
                                       const Grid<Dim>& grid, Workers& workers, int layer) {
  const std::size_t materials =
      1 + static_cast<std::size_t>(*std::max_element(material_of_id.begin(), material_of_id.end()));
  Layout layout(static_cast<std::size_t>(grid.rows() * grid.row_stride()), materials);
  std::vector<std::uint32_t> bin(particles.lanes());
  std::vector<std::size_t> outside;
  for (std::size_t i = 0; i < particles.lanes(); ++i) {
    if (particles.is_padding(i)) {
      continue;
    }
    if (const std::optional<std::uint32_t> home = bin_of(particles, grid, layer, i)) {
      bin[i] = *home;
      layout.add(bin[i], material_of_id[particles.id[i]]);
    } else {
      outside.push_back(i);
    }
  }
  if (!outside.empty()) {
    std::sort(outside.begin(), outside.end(),
              [&](std::size_t a, std::size_t b) { return particles.id[a] < particles.id[b]; });
    return outside;
  }
  layout.place_slots(particles);
  Source source(particles.slot_material.size() * kGroupWidth, kNoSource);
  for (std::size_t i = 0; i < particles.lanes(); ++i) {
    if (!particles.is_padding(i)) {
      source[layout.next_lane(bin[i], material_of_id[particles.id[i]])] =
          static_cast<std::uint32_t>(i);
    }
  }
  particles.for_each_column(
      [&](auto& column, auto padding) { permute(column, source, padding, workers); });
  put_padding_on_nodes(particles, grid, layer);
  return {};
}

template Particles<2> particles_from<2>(const std::vector<ParticleSeed>&);
template Particles<3> particles_from<3>(const std::vector<ParticleSeed>&);
template std::vector<std::size_t> bin_particles<2>(Particles<2>&, const std::vector<std::uint8_t>&,
                                                   const Grid<2>&, Workers&, int);
template std::vector<std::size_t> bin_particles<3>(Particles<3>&, const std::vector<std::uint8_t>&,
                                                   const Grid<3>&, Workers&, int);

}  // namespace rgimp
