#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "atomic_file.hpp"
#include "grid_of_seeds.hpp"
#include "hdf5_image.hpp"
#include "output_directory.hpp"
#include "result_files.hpp"
#include "rgimp/error.hpp"
#include "snapshot.hpp"
#include "time_step.hpp"

/// Files of grid fields.
namespace rgimp {

namespace fs = std::filesystem;

namespace {

template <typename Number, std::size_t Count>
Hdf5Table list_of(const std::array<Number, Count>& values) {
  return hdf5_table(std::span<const Number>(values));
}

std::array<double, 3> numbers(const Vector& vector) {
  return {vector.x(), vector.y(), vector.z()};
}

/// Layers of nodes along z in a file: VTK 9.1's reader writes past its memory where there is one.
std::int64_t layers(const GridFields& fields) {
  return std::max<std::int64_t>(fields.nodes[2], 2);
}

/// In VTK's order of the axes: x runs fastest.
template <typename Value>
void write_field(const Hdf5Group& data, const std::string& name, std::string_view units,
                 const std::vector<Value>& values, const GridFields& fields) {
  std::vector<Value> twice;
  if (fields.nodes[2] == 1) {
    twice = values;
    twice.insert(twice.end(), values.begin(), values.end());
  }
  Hdf5Table table = hdf5_table(std::span<const Value>(twice.empty() ? values : twice));
  std::vector<hsize_t> shape{static_cast<hsize_t>(layers(fields)),
                             static_cast<hsize_t>(fields.nodes[1]),
                             static_cast<hsize_t>(fields.nodes[0])};
  shape.insert(shape.end(), table.shape.begin() + 1, table.shape.end());
  table.shape = shape;
  data.write_dataset(name, units, table);
}

void write_place(const Hdf5Group& image, const GridFields& fields) {
  image.write_attribute("Version", list_of(std::array<std::int64_t, 2>{1, 0}));
  image.write_attribute("Type", "ImageData");
  image.write_attribute(
      "WholeExtent", list_of(std::array<std::int64_t, 6>{
                         0, fields.nodes[0] - 1, 0, fields.nodes[1] - 1, 0, layers(fields) - 1}));
  image.write_attribute("Origin", list_of(numbers(fields.origin)));
  std::array<double, 3> spacing = numbers(fields.spacing);
  if (fields.nodes[2] == 1) {
    spacing[2] = spacing[0];
  }
  image.write_attribute("Spacing", list_of(spacing));
  image.write_attribute("Direction",
                        list_of(std::array{1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0}));
}

fs::path grid_file(const fs::path& directory, std::int64_t step) {
  return directory / kGrid / snapshot_name(step);
}

void make_place(const fs::path& directory) {
  std::error_code error;
  if (fs::is_symlink(directory / kGrid)) {
    throw FileError(
        fmt::format("cannot write to '{}': it is a symbolic link, which may lead out of "
                    "the output directory",
                    (directory / kGrid).string()));
  }
  fs::create_directory(directory / kGrid, error);
  if (error) {
    throw FileError(
        fmt::format("cannot write to '{}': {}", (directory / kGrid).string(), error.message()));
  }
}

std::vector<SnapshotTime> times_of(const std::vector<std::int64_t>& steps, const Case& settings) {
  std::vector<SnapshotTime> times;
  times.reserve(steps.size());
  for (const std::int64_t step : steps) {
    times.push_back({step, time_step(settings) * static_cast<double>(step)});
  }
  return times;
}

}  // namespace

void write_grid_fields(const fs::path& path, const GridFields& fields) {
  const Hdf5Image image;
  const Hdf5Group root = image.create_group("VTKHDF");
  write_place(root, fields);
  const Hdf5Group data = root.create_group("PointData");
  write_field(data, "mass", "kg", fields.mass, fields);
  write_field(data, "velocity", "m/s", fields.velocity, fields);
  write_field(data, "stress", "Pa", fields.stress, fields);
  write_field(data, "damage", "1", fields.damage, fields);
  // Attributes, as VTK 9.1's reader takes field data of images for nodes' and refuses it.
  root.write_attribute("step", list_of(std::array{fields.step}));
  root.write_attribute("time_s", list_of(std::array{fields.time}));
  write_file(path, image.bytes());
}

WrittenGrids write_grids(const fs::path& directory, std::optional<std::int64_t> step) {
  const Case settings = read_case_of_results(directory);
  std::vector<std::int64_t> steps = snapshot_steps(directory);
  if (step) {
    if (std::find(steps.begin(), steps.end(), *step) == steps.end()) {
      throw CaseError(fmt::format("there is no snapshot of step {} in '{}'; there are those of {}",
                                  *step, directory.string(), fmt::join(steps, ", ")));
    }
    steps = {*step};
  }
  make_place(directory);
  const std::vector<ParticleSeed> seeds = seed_particles(settings);
  WrittenGrids written;
  for (const std::int64_t each : steps) {
    const GridFields fields =
        grid_fields(settings, seeds, read_particles(directory, settings, seeds.size(), each), each);
    write_grid_fields(grid_file(directory, each), fields);
    written.files.push_back(grid_file(directory, each));
    written.particles_outside = fields.particles_outside;
  }
  write_series(directory / kGrid / kGridSeries, times_of(steps_in(directory / kGrid), settings));
  return written;
}

}  // namespace rgimp
