#include "snapshot.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <numeric>
#include <span>

#include "atomic_file.hpp"
#include "hdf5_image.hpp"

namespace rgimp {

namespace {

constexpr std::uint8_t kVtkVertex = 1;  // VTK's number for a cell that is one point

template <typename Number>
Hdf5Table table_of(const std::vector<Number>& values) {
  return hdf5_table(std::span<const Number>(values));
}

Hdf5Table table_of(const std::vector<FailureMode>& modes) {
  static_assert(sizeof(FailureMode) == sizeof(std::uint8_t));
  const auto* numbers = reinterpret_cast<const std::uint8_t*>(modes.data());
  return hdf5_table(std::span<const std::uint8_t>(numbers, modes.size()));
}

template <typename Number>
void write_number(const Hdf5Group& group, const std::string& name, std::string_view units,
                  Number value) {
  group.write_dataset(name, units, hdf5_table(std::span<const Number>(&value, 1)));
}

/// One vertex cell for each point, in the order of the points.
void write_cells(const Hdf5Group& grid, std::size_t points) {
  const auto count = static_cast<std::int64_t>(points);
  write_number(grid, "NumberOfPoints", "1", count);
  write_number(grid, "NumberOfCells", "1", count);
  write_number(grid, "NumberOfConnectivityIds", "1", count);
  std::vector<std::int64_t> offsets(points + 1);
  std::iota(offsets.begin(), offsets.end(), 0);
  grid.write_dataset("Offsets", "1", table_of(offsets));
  grid.write_dataset("Connectivity", "1",
                     hdf5_table(std::span<const std::int64_t>(offsets).first(points)));
  grid.write_dataset("Types", "1", table_of(std::vector<std::uint8_t>(points, kVtkVertex)));
}

/// Frees the values, as the file in memory has them now.
template <typename Values>
void move_dataset(const Hdf5Group& group, const std::string& name, std::string_view units,
                  Values& values) {
  group.write_dataset(name, units, table_of(values));
  values = Values();
}

void write_point_data(const Hdf5Group& data, ParticleTable& particles) {
  move_dataset(data, "id", "1", particles.id);
  move_dataset(data, "velocity", "m/s", particles.velocity);
  move_dataset(data, "stress", "Pa", particles.stress);
  move_dataset(data, "max_principal_stress", "Pa", particles.max_principal_stress);
  move_dataset(data, "failed", "1", particles.failed);
  move_dataset(data, "damage", "1", particles.damage);
  move_dataset(data, "failure_step", "1", particles.failure_step);
}

void write_grid(const Hdf5Group& grid, ParticleTable& particles, const SnapshotTime& when) {
  constexpr std::array<std::int64_t, 2> version{1, 0};
  grid.write_attribute("Version", hdf5_table(std::span<const std::int64_t>(version)));
  grid.write_attribute("Type", "UnstructuredGrid");
  write_cells(grid, particles.size());
  move_dataset(grid, "Points", "m", particles.position);
  write_point_data(grid.create_group("PointData"), particles);
  const Hdf5Group field = grid.create_group("FieldData");
  write_number(field, "step", "1", when.step);
  write_number(field, "time", "s", when.time);
}

}  // namespace

std::string snapshot_name(std::int64_t step) {
  return fmt::format("step_{:09}.vtkhdf", step);
}

bool is_snapshot_name(std::string_view name) {
  constexpr std::string_view prefix = "step_";
  constexpr std::string_view suffix = ".vtkhdf";
  constexpr std::size_t fewest_digits = 9;
  if (name.size() < prefix.size() + fewest_digits + suffix.size() || !name.starts_with(prefix) ||
      !name.ends_with(suffix)) {
    return false;
  }
  name.remove_prefix(prefix.size());
  name.remove_suffix(suffix.size());
  return name.find_first_not_of("0123456789") == std::string_view::npos;
}

void write_snapshot(const std::filesystem::path& path, ParticleTable particles,
                    const SnapshotTime& when) {
  const Hdf5Image image;
  write_grid(image.create_group("VTKHDF"), particles, when);
  write_file(path, image.bytes());
}

void write_series(const std::filesystem::path& path, const std::vector<SnapshotTime>& snapshots) {
  auto files = nlohmann::ordered_json::array();
  for (const SnapshotTime& snapshot : snapshots) {
    files.push_back({{"name", snapshot_name(snapshot.step)}, {"time", snapshot.time}});
  }
  const nlohmann::ordered_json series{{"file-series-version", "1.0"}, {"files", files}};
  write_file(path, series.dump(2) + "\n");
}

}  // namespace rgimp
