#pragma once

#include <cstdint>
#include <filesystem>
#include <istream>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "atomic_file.hpp"
#include "checksum.hpp"
#include "output_stream.hpp"

/// The format of a checkpoint: named columns of numbers and two texts.
///
///   16 bytes  "RGIMPcheckpoint\n"
///    8        version of the format
///    8        step
///    ...      the columns, one after the other, as they lie in memory
///    ...      index: JSON with the texts, and name, type and length of every column in order
///    8        length of the index
///    8        checksum of everything before
///
/// Numbers are little-endian. The index comes last, so that columns are written as they come and no
/// second copy of the particles is needed. HDF5 was not taken: it would parse damaged bytes before
/// any checksum of the whole could be looked at.
namespace rgimp {

inline constexpr std::uint64_t kCheckpointVersion = 1;

/// What a checkpoint says besides numbers.
struct CheckpointLabel {
  std::string case_text;  ///< the case, as far as it bears on the state
  std::string note;       ///< of whoever asked for the checkpoint
  /// Names of the program's functions that acted on the state; no checkpoint can hold them.
  std::vector<std::string> own_functions = {};
};

/// The name of a type of number in the index.
template <typename Number>
constexpr std::string_view number_type() {
  if constexpr (std::is_same_v<Number, double>) {
    return "float64";
  } else if constexpr (std::is_same_v<Number, std::int64_t>) {
    return "int64";
  } else if constexpr (std::is_same_v<Number, std::int32_t>) {
    return "int32";
  } else if constexpr (std::is_same_v<Number, std::uint32_t>) {
    return "uint32";
  } else {
    static_assert(std::is_same_v<Number, std::uint8_t>, "no checkpoint type for this number");
    return "uint8";
  }
}

/// Writes a checkpoint beside its place; finish() puts it there. Every call throws FileError.
class CheckpointWriter {
 public:
  CheckpointWriter(const std::filesystem::path& target, std::int64_t step);
  ~CheckpointWriter();

  template <typename Number, typename Allocator>
  void operator()(std::string_view name, const std::vector<Number, Allocator>& column) {
    add(name, number_type<Number>(), column.size(),
        {reinterpret_cast<const char*>(column.data()), column.size() * sizeof(Number)});
  }
  /// A single number is a column of length 1.
  template <typename Number>
  requires std::is_arithmetic_v<Number>
  void operator()(std::string_view name, const Number& value) {
    add(name, number_type<Number>(), 1, {reinterpret_cast<const char*>(&value), sizeof(Number)});
  }

  /// Nothing may be written afterwards.
  void finish(const CheckpointLabel& label);

 private:
  struct Index;

  void add(std::string_view name, std::string_view type, std::size_t length,
           std::string_view bytes);
  void write(std::string_view bytes);

  AtomicFile file_;
  OutputStream stream_;
  Checksum checksum_;
  std::unique_ptr<Index> index_;
};

/// A checkpoint, of which each column is read when it is asked for. Nothing is believed before the
/// checksum is right, and nothing is read from outside a column after it. Every call throws
/// FileError naming the file. Holding the whole file, resuming 16.0 M particles took 7.3 GiB, of
/// which 2.5 GB were the file.
class CheckpointReader {
 public:
  /// Of all of `file`; `name` is for messages.
  CheckpointReader(std::string name, std::unique_ptr<std::istream> file);
  CheckpointReader(const CheckpointReader&) = delete;
  CheckpointReader& operator=(const CheckpointReader&) = delete;

  const CheckpointLabel& label() const { return label_; }
  std::int64_t step() const { return step_; }

  template <typename Number, typename Allocator>
  void operator()(std::string_view name, std::vector<Number, Allocator>& column) const {
    const Column& found = find(name, number_type<Number>());
    column.resize(found.length);
    read(found.place, {reinterpret_cast<char*>(column.data()), found.length * sizeof(Number)});
  }
  template <typename Number>
  requires std::is_arithmetic_v<Number>
  void operator()(std::string_view name, Number& value) const {
    const Column& found = find(name, number_type<Number>());
    if (found.length != 1) {
      refuse("'" + std::string(name) + "' is not a single number");
    }
    read(found.place, {reinterpret_cast<char*>(&value), sizeof(Number)});
  }

  [[noreturn]] void refuse(const std::string& reason) const;

 private:
  struct Column {
    std::string type;
    std::size_t place;   // of its first byte in the file
    std::size_t length;  // numbers
  };

  void read(std::size_t place, std::span<char> bytes) const;
  std::uint64_t word_at(std::size_t place) const;
  std::uint64_t checksum_before(std::size_t end) const;
  std::size_t checked_size() const;
  void read_index(std::size_t end);
  const Column& find(std::string_view name, std::string_view type) const;

  std::string name_;
  std::unique_ptr<std::istream> file_;
  std::int64_t step_ = 0;
  CheckpointLabel label_;
  std::map<std::string, Column, std::less<>> columns_;
};

/// The step that a file says it is a checkpoint of, for choosing between several before one is
/// read; none where there is no such file.
std::optional<std::int64_t> claimed_step(const std::filesystem::path& path);

}  // namespace rgimp
