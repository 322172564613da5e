#include "snapshot_reader.hpp"

#include <fmt/format.h>

#include <array>
#include <string>
#include <type_traits>
#include <vector>

#include "hdf5_image.hpp"
#include "rgimp/error.hpp"

namespace rgimp {

namespace {

/// The numbers in one element of a column.
template <typename Number>
constexpr std::size_t kColumns = 1;
template <typename Number, std::size_t Count>
constexpr std::size_t kColumns<std::array<Number, Count>> = Count;

template <typename Number>
struct BasicNumber {
  using Type = Number;
};
template <typename Number, std::size_t Count>
struct BasicNumber<std::array<Number, Count>> {
  using Type = Number;
};

class SnapshotReader {
 public:
  /// Of a case of `particles` particles.
  SnapshotReader(const std::filesystem::path& path, std::size_t particles, OnExit on_exit)
      : path_(path.string()),
        most_(particles),
        least_(on_exit == OnExit::remove ? 1 : particles),
        file_(H5Fopen(path_.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose,
              fmt::format("read '{}'", path_)) {}

  /// Nothing is read before the sizes in the file are known to be those of `values`. The first
  /// column read says how many particles there are, which holds for all others.
  template <typename Row>
  void read(const std::string& name, std::vector<Row>& values) {
    refuse_links(name);
    const std::string action = fmt::format("read '{}' of '{}'", name, path_);
    const Hdf5Handle dataset(H5Dopen2(file_.get(), name.c_str(), H5P_DEFAULT), H5Dclose, action);
    check_extent(dataset.get(), name, kColumns<Row>);
    check_type(dataset.get(), name,
               std::is_floating_point_v<typename BasicNumber<Row>::Type> ? H5T_FLOAT : H5T_INTEGER);
    check_storage(dataset.get(), name);
    values.resize(least_);
    const hid_t type = hdf5_type<typename BasicNumber<Row>::Type>();
    if (H5Dread(dataset.get(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) < 0) {
      refuse(fmt::format("'{}' cannot be read as numbers", name));
    }
  }

  [[noreturn]] void refuse(const std::string& reason) const {
    throw FileError(fmt::format("snapshot '{}': {}", path_, reason));
  }

 private:
  /// Links may lead to other files, which a snapshot has no business to read. No later part of the
  /// name is looked at before the earlier ones are known to lie in this file.
  void refuse_links(const std::string& name) const {
    for (std::size_t end = name.find('/');; end = name.find('/', end + 1)) {
      const std::string part = name.substr(0, end);
      H5L_info_t link{};
      if (H5Lget_info(file_.get(), part.c_str(), &link, H5P_DEFAULT) < 0) {
        refuse(fmt::format("there is no '{}' in it", part));
      }
      if (link.type != H5L_TYPE_HARD) {
        refuse(fmt::format("'{}' is a link, not data of this file", part));
      }
      if (end == std::string::npos) {
        return;
      }
    }
  }

  void check_type(hid_t dataset, const std::string& name, H5T_class_t wanted) const {
    const Hdf5Handle type(H5Dget_type(dataset), H5Tclose, fmt::format("read '{}'", path_));
    if (H5Tget_class(type.get()) != wanted) {
      refuse(fmt::format("'{}' does not hold {} numbers", name,
                         wanted == H5T_FLOAT ? "real" : "whole"));
    }
  }

  /// As rgimp writes them: numbers in one piece in this file. Everything else could be in other
  /// files, need filters, which HDF5 loads as plug-ins, or grow beyond the file's size.
  void check_storage(hid_t dataset, const std::string& name) const {
    const std::string action = fmt::format("read '{}'", path_);
    const Hdf5Handle properties(H5Dget_create_plist(dataset), H5Pclose, action);
    const H5D_layout_t layout = H5Pget_layout(properties.get());
    const bool is_plain = (layout == H5D_CONTIGUOUS || layout == H5D_COMPACT) &&
                          H5Pget_external_count(properties.get()) == 0 &&
                          H5Pget_nfilters(properties.get()) == 0;
    const Hdf5Handle type(H5Dget_type(dataset), H5Tclose, action);
    const Hdf5Handle space(H5Dget_space(dataset), H5Sclose, action);
    const auto values = static_cast<hsize_t>(H5Sget_simple_extent_npoints(space.get()));
    if (!is_plain || H5Dget_storage_size(dataset) != values * H5Tget_size(type.get())) {
      refuse(fmt::format("'{}' is not stored as plain numbers in one piece", name));
    }
  }

  void check_extent(hid_t dataset, const std::string& name, std::size_t columns) {
    const Hdf5Handle space(H5Dget_space(dataset), H5Sclose, fmt::format("read '{}'", path_));
    const int wanted_rank = columns == 1 ? 1 : 2;
    std::array<hsize_t, 2> extent{0, 1};
    if (H5Sget_simple_extent_ndims(space.get()) != wanted_rank ||
        H5Sget_simple_extent_dims(space.get(), extent.data(), nullptr) != wanted_rank ||
        extent[0] < least_ || extent[0] > most_ || extent[1] != columns) {
      refuse(fmt::format("'{}' is not the {} x {} numbers of this case's particles", name, most_,
                         columns));
    }
    least_ = most_ = extent[0];
  }

  Hdf5Access access_;
  std::string path_;
  std::size_t most_;  // particles
  std::size_t least_;
  Hdf5Handle file_;
};

/// Every id at most once, every failure with its step.
void check_values(const SnapshotReader& reader, const ParticleTable& table, std::size_t particles) {
  std::vector<char> seen(particles);
  for (std::size_t row = 0; row < table.size(); ++row) {
    const std::uint32_t id = table.id[row];
    if (id >= particles || seen[id] != 0) {
      reader.refuse(fmt::format("id {} is not there once", id));
    }
    seen[id] = 1;
    if (table.failed[row] > FailureMode::shear) {
      reader.refuse(fmt::format("particle {} has the unknown failure mode {}", id,
                                static_cast<int>(table.failed[row])));
    }
    if ((table.failed[row] == FailureMode::intact) != (table.failure_step[row] < 0)) {
      reader.refuse(fmt::format("'failed' and 'failure_step' of particle {} do not agree", id));
    }
  }
}

}  // namespace

ParticleTable read_snapshot(const std::filesystem::path& path, std::size_t particles,
                            OnExit on_exit) {
  SnapshotReader reader(path, particles, on_exit);
  ParticleTable table;
  reader.read("VTKHDF/PointData/id", table.id);
  reader.read("VTKHDF/Points", table.position);
  reader.read("VTKHDF/PointData/velocity", table.velocity);
  reader.read("VTKHDF/PointData/stress", table.stress);
  reader.read("VTKHDF/PointData/max_principal_stress", table.max_principal_stress);
  std::vector<std::uint8_t> modes;
  reader.read("VTKHDF/PointData/failed", modes);
  for (const std::uint8_t mode : modes) {
    table.failed.push_back(static_cast<FailureMode>(mode));
  }
  reader.read("VTKHDF/PointData/damage", table.damage);
  reader.read("VTKHDF/PointData/failure_step", table.failure_step);
  check_values(reader, table, particles);
  return table;
}

}  // namespace rgimp
