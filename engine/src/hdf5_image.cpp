#include "hdf5_image.hpp"

#include <fmt/format.h>

#include <utility>

#include "rgimp/error.hpp"

namespace rgimp {

namespace {

/// The library's one variable of the whole process, as HDF5 is one library of the whole process.
std::mutex hdf5_mutex;

/// HDF5's innermost complaint: the one that holds the system's reason.
std::string last_complaint() {
  std::string text;
  H5Ewalk2(
      H5E_DEFAULT, H5E_WALK_UPWARD,
      [](unsigned depth, const H5E_error2_t* error, void* data) -> herr_t {
        if (depth == 0 && error->desc != nullptr) {
          *static_cast<std::string*>(data) = error->desc;
        }
        return 0;
      },
      &text);
  return text.empty() ? "HDF5 gives no reason" : text;
}

[[noreturn]] void fail(std::string_view action) {
  throw FileError(fmt::format("cannot {}: {}", action, last_complaint()));
}

void require(herr_t status, std::string_view action) {
  if (status < 0) {
    fail(action);
  }
}

Hdf5Handle create_space(const Hdf5Table& table) {
  const int rank = static_cast<int>(table.shape.size());
  return {H5Screate_simple(rank, table.shape.data(), nullptr), H5Sclose, "size HDF5 data"};
}

/// Fixed length: VTK reads no other strings.
void write_text(hid_t owner, const std::string& name, std::string_view text) {
  const std::string action = fmt::format("write attribute '{}'", name);
  const Hdf5Handle type(H5Tcopy(H5T_C_S1), H5Tclose, action);
  require(H5Tset_size(type.get(), text.size()), action);
  require(H5Tset_strpad(type.get(), H5T_STR_NULLPAD), action);
  const Hdf5Handle space(H5Screate(H5S_SCALAR), H5Sclose, action);
  const Hdf5Handle attribute(
      H5Acreate2(owner, name.c_str(), type.get(), space.get(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose,
      action);
  require(H5Awrite(attribute.get(), type.get(), text.data()), action);
}

/// Without the time of day, which HDF5 notes by default: equal runs write equal bytes.
Hdf5Handle timeless() {
  constexpr std::string_view action = "leave the time out of HDF5 data";
  Hdf5Handle properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, action);
  require(H5Pset_obj_track_times(properties.get(), 0), action);
  return properties;
}

Hdf5Handle create_in_memory() {
  constexpr std::string_view action = "build an HDF5 file in memory";
  constexpr std::size_t growth = std::size_t{1} << 22;
  constexpr hbool_t written_by_hdf5 = 0;
  const Hdf5Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, action);
  require(H5Pset_fapl_core(access.get(), growth, written_by_hdf5), action);
  return {H5Fcreate("rgimp image", H5F_ACC_TRUNC, H5P_DEFAULT, access.get()), H5Fclose, action};
}

}  // namespace

Hdf5Handle::Hdf5Handle(hid_t id, Release release, std::string_view action)
    : id_(id), release_(release) {
  if (id < 0) {
    fail(action);
  }
}

Hdf5Handle::~Hdf5Handle() {
  if (id_ >= 0) {
    release_(id_);
  }
}

Hdf5Handle::Hdf5Handle(Hdf5Handle&& other) noexcept
    : id_(std::exchange(other.id_, H5I_INVALID_HID)), release_(other.release_) {}

Hdf5Access::Hdf5Access() : alone_(hdf5_mutex) {
  H5Eget_auto2(H5E_DEFAULT, &function_, &data_);
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

Hdf5Access::~Hdf5Access() {
  H5Eset_auto2(H5E_DEFAULT, function_, data_);
}

Hdf5Group::Hdf5Group(hid_t parent, const std::string& name)
    : group_(H5Gcreate2(parent, name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose,
             fmt::format("write HDF5 group '{}'", name)) {}

Hdf5Group Hdf5Group::create_group(const std::string& name) const {
  return {group_.get(), name};
}

void Hdf5Group::write_attribute(const std::string& name, std::string_view text) const {
  write_text(group_.get(), name, text);
}

void Hdf5Group::write_attribute(const std::string& name, const Hdf5Table& values) const {
  const std::string action = fmt::format("write attribute '{}'", name);
  const Hdf5Handle space = create_space(values);
  const Hdf5Handle attribute(
      H5Acreate2(group_.get(), name.c_str(), values.type, space.get(), H5P_DEFAULT, H5P_DEFAULT),
      H5Aclose, action);
  require(H5Awrite(attribute.get(), values.type, values.data), action);
}

void Hdf5Group::write_dataset(const std::string& name, std::string_view units,
                              const Hdf5Table& table) const {
  const std::string action = fmt::format("write dataset '{}'", name);
  const Hdf5Handle space = create_space(table);
  const Hdf5Handle properties = timeless();
  const Hdf5Handle dataset(H5Dcreate2(group_.get(), name.c_str(), table.type, space.get(),
                                      H5P_DEFAULT, properties.get(), H5P_DEFAULT),
                           H5Dclose, action);
  write_text(dataset.get(), "units", units);
  require(H5Dwrite(dataset.get(), table.type, H5S_ALL, H5S_ALL, H5P_DEFAULT, table.data), action);
}

Hdf5Image::Hdf5Image() : file_(create_in_memory()) {}

Hdf5Group Hdf5Image::create_group(const std::string& name) const {
  return {file_.get(), name};
}

std::string_view Hdf5Image::bytes() const {
  constexpr std::string_view action = "build an HDF5 file";
  require(H5Fflush(file_.get(), H5F_SCOPE_GLOBAL), action);
  const ssize_t size = H5Fget_file_image(file_.get(), nullptr, 0);
  require(size < 0 ? -1 : 0, action);
  // The memory itself: H5Fget_file_image would copy it.
  void* handle = nullptr;
  require(H5Fget_vfd_handle(file_.get(), H5P_DEFAULT, &handle), action);
  return {*static_cast<const char* const*>(handle), static_cast<std::size_t>(size)};
}

}  // namespace rgimp
