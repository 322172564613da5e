#pragma once

#include <hdf5.h>

#include <array>
#include <cstdint>
#include <mutex>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace rgimp {

/// Owns one HDF5 identifier and closes it.
class Hdf5Handle {
 public:
  using Release = herr_t (*)(hid_t);

  /// Throws FileError where `id` says that HDF5 failed to do `action`.
  Hdf5Handle(hid_t id, Release release, std::string_view action);
  ~Hdf5Handle();
  Hdf5Handle(Hdf5Handle&& other) noexcept;
  Hdf5Handle& operator=(Hdf5Handle&&) = delete;

  hid_t get() const { return id_; }

 private:
  hid_t id_;
  Release release_;
};

/// The right to use HDF5, whoever holds handles holds one: other threads of this library wait, as
/// HDF5 need not be built for threads and knows files in memory by one name. While it lives HDF5
/// prints no error stacks: failures become exceptions instead.
class Hdf5Access {
 public:
  Hdf5Access();
  ~Hdf5Access();
  Hdf5Access(const Hdf5Access&) = delete;
  Hdf5Access& operator=(const Hdf5Access&) = delete;

 private:
  std::lock_guard<std::mutex> alone_;
  H5E_auto2_t function_ = nullptr;
  void* data_ = nullptr;
};

/// The type in memory, and little surprise in the file, of a C++ number.
template <typename Number>
hid_t hdf5_type() {
  if constexpr (std::is_same_v<Number, double>) {
    return H5T_NATIVE_DOUBLE;
  } else if constexpr (std::is_same_v<Number, std::int64_t>) {
    return H5T_NATIVE_INT64;
  } else if constexpr (std::is_same_v<Number, std::int32_t>) {
    return H5T_NATIVE_INT32;
  } else if constexpr (std::is_same_v<Number, std::uint32_t>) {
    return H5T_NATIVE_UINT32;
  } else {
    static_assert(std::is_same_v<Number, std::uint8_t>, "no HDF5 type for this number");
    return H5T_NATIVE_UINT8;
  }
}

/// Numbers in memory, the last index first.
struct Hdf5Table {
  const void* data = nullptr;
  hid_t type = H5I_INVALID_HID;
  std::vector<hsize_t> shape;
};

template <typename Number>
Hdf5Table hdf5_table(std::span<const Number> values) {
  return {values.data(), hdf5_type<Number>(), {values.size()}};
}

template <typename Number, std::size_t Columns>
Hdf5Table hdf5_table(std::span<const std::array<Number, Columns>> rows) {
  return {rows.data(), hdf5_type<Number>(), {rows.size(), Columns}};
}

/// A group of an HDF5 file being built. Every call throws FileError where HDF5 fails.
class Hdf5Group {
 public:
  Hdf5Group(hid_t parent, const std::string& name);

  Hdf5Group create_group(const std::string& name) const;
  void write_attribute(const std::string& name, std::string_view text) const;
  void write_attribute(const std::string& name, const Hdf5Table& values) const;
  /// `units` become an attribute of the dataset; "1" marks a plain number.
  void write_dataset(const std::string& name, std::string_view units, const Hdf5Table& table) const;

 private:
  Hdf5Handle group_;
};

/// An HDF5 file built in memory, to be saved whole. HDF5 1.10 crashes where a disk runs full under
/// it, even much later, when the process ends; plain writing of the finished bytes does not.
class Hdf5Image {
 public:
  Hdf5Image();

  Hdf5Group create_group(const std::string& name) const;
  /// The file's bytes, valid until it changes or goes. Throws FileError.
  std::string_view bytes() const;

 private:
  Hdf5Access access_;
  Hdf5Handle file_;
};

}  // namespace rgimp
