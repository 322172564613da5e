#pragma once

#include <fmt/format.h>
#include <toml++/toml.h>

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "case_error.hpp"
#include "case_names.hpp"
#include "nearest_name.hpp"

namespace rgimp {

/// A table of a case file whose values are read by key into variables of the right type. What
/// does not fit is refused with the place of the key.
class TomlReader {
 public:
  /// Two numbers in the file whatever the dimension.
  using Pair = std::array<double, 2>;

  /// `path` is the table's own key path, empty for the file; both references must outlive this.
  /// Vectors have `dimension` components in the file.
  TomlReader(const toml::table& table, std::string path, const CaseSource& source, int dimension);

  /// Refuses the first key, in order of the file, that is not among `known`.
  void allow_only(std::span<const std::string_view> known) const;

  int dimension() const { return dimension_; }
  bool has(std::string_view key) const { return table_.contains(key); }
  std::vector<std::string> keys() const;
  std::string path_of(std::string_view key) const;
  [[noreturn]] void refuse(std::string_view key, std::string_view what) const;

  /// A value that must be there.
  template <typename Value>
  void require(std::string_view key, Value& target) const {
    convert(node(key, expected(target)), path_of(key), target);
  }

  /// A value that keeps its default where the key is left out.
  template <typename Value>
  void accept(std::string_view key, Value& target) const {
    if (has(key)) {
      require(key, target);
    }
  }
  template <typename Value>
  void accept(std::string_view key, std::optional<Value>& target) const {
    if (has(key)) {
      require(key, target.emplace());
    }
  }

  TomlReader table(std::string_view key) const;
  std::optional<TomlReader> table_if_any(std::string_view key) const;
  /// The tables of an array, none where the key is left out.
  std::vector<TomlReader> tables(std::string_view key) const;

 private:
  const toml::node& node(std::string_view key, std::string_view what_is_expected) const;
  [[noreturn]] void refuse_type(const toml::node& found, const std::string& path,
                                std::string_view what_is_expected) const;

  static std::string expected_numbers(std::size_t count) {
    return fmt::format("an array of {} real numbers", count);
  }
  static std::string_view expected(double) { return "a real number"; }
  static std::string_view expected(int) { return "an integer"; }
  static std::string_view expected(std::int64_t) { return "an integer"; }
  static std::string_view expected(const std::string&) { return "a string"; }
  std::string expected(const Vector&) const {
    return expected_numbers(static_cast<std::size_t>(dimension_));
  }
  static std::string expected(const Pair& pair) { return expected_numbers(pair.size()); }
  static std::string_view expected(const std::vector<std::int64_t>&) {
    return "an array of integers";
  }
  template <typename Enum>
  requires std::is_enum_v<Enum> std::string expected(Enum)
  const { return fmt::format("one of {}", fmt::join(all_names<Enum>(dimension_), ", ")); }

  void convert(const toml::node& from, const std::string& path, double& to) const;
  void convert(const toml::node& from, const std::string& path, int& to) const;
  void convert(const toml::node& from, const std::string& path, std::int64_t& to) const;
  void convert(const toml::node& from, const std::string& path, std::string& to) const;
  void convert(const toml::node& from, const std::string& path, Vector& to) const;
  void convert(const toml::node& from, const std::string& path, Pair& to) const;
  void convert_numbers(const toml::node& from, const std::string& path, std::span<double> to) const;
  void convert(const toml::node& from, const std::string& path,
               std::vector<std::int64_t>& to) const;
  template <typename Enum>
  requires std::is_enum_v<Enum>
  void convert(const toml::node& from, const std::string& path, Enum& to) const {
    std::string word;
    convert(from, path, word);
    for (const Named<Enum>& entry : names_of(to)) {
      if (entry.name == word && exists_in(dimension_, entry.value)) {
        to = entry.value;
        return;
      }
    }
    refuse_word(path, word, all_names<Enum>(dimension_));
  }
  [[noreturn]] void refuse_word(const std::string& path, const std::string& word,
                                std::span<const std::string_view> names) const;

  const toml::table& table_;
  std::string path_;
  const CaseSource& source_;
  int dimension_;
};

}  // namespace rgimp
