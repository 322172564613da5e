#include "toml_reader.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rgimp {
namespace {

std::string_view type_name(const toml::node& node) {
  switch (node.type()) {
    case toml::node_type::table:
      return "a table";
    case toml::node_type::array:
      return "an array";
    case toml::node_type::string:
      return "a string";
    case toml::node_type::integer:
      return "an integer";
    case toml::node_type::floating_point:
      return "a real number";
    case toml::node_type::boolean:
      return "a boolean";
    default:
      return "a date or time";
  }
}

}  // namespace

TomlReader::TomlReader(const toml::table& table, std::string path, const CaseSource& source,
                       int dimension)
    : table_(table), path_(std::move(path)), source_(source), dimension_(dimension) {}

void TomlReader::allow_only(std::span<const std::string_view> known) const {
  const toml::key* first = nullptr;
  for (const auto& [key, value] : table_) {
    const bool is_known = std::find(known.begin(), known.end(), key.str()) != known.end();
    if (!is_known && (first == nullptr || key.source().begin < first->source().begin)) {
      first = &key;
    }
  }
  if (first != nullptr) {
    const std::string all = fmt::format("; the keys here are {}", fmt::join(known, ", "));
    refuse(first->str(), "unknown key" + suggestion(first->str(), known, all));
  }
}

std::vector<std::string> TomlReader::keys() const {
  std::vector<std::string> keys;
  for (const auto& [key, value] : table_) {
    keys.emplace_back(key.str());
  }
  return keys;
}

std::string TomlReader::path_of(std::string_view key) const {
  return path_.empty() ? std::string(key) : fmt::format("{}.{}", path_, key);
}

void TomlReader::refuse(std::string_view key, std::string_view what) const {
  rgimp::refuse(source_, path_of(key), what);
}

TomlReader TomlReader::table(std::string_view key) const {
  const toml::node& found = node(key, "a table");
  if (!found.is_table()) {
    refuse_type(found, path_of(key), "a table");
  }
  return {*found.as_table(), path_of(key), source_, dimension_};
}

std::optional<TomlReader> TomlReader::table_if_any(std::string_view key) const {
  return has(key) ? std::optional<TomlReader>(table(key)) : std::nullopt;
}

std::vector<TomlReader> TomlReader::tables(std::string_view key) const {
  std::vector<TomlReader> readers;
  if (!has(key)) {
    return readers;
  }
  const toml::node& found = node(key, "");
  if (!found.is_array()) {
    refuse_type(found, path_of(key), fmt::format("an array of tables, [[{}]]", key));
  }
  const toml::array& array = *found.as_array();
  for (std::size_t i = 0; i < array.size(); ++i) {
    const std::string path = fmt::format("{}[{}]", path_of(key), i);
    if (!array[i].is_table()) {
      refuse_type(array[i], path, "a table");
    }
    readers.emplace_back(*array[i].as_table(), path, source_, dimension_);
  }
  return readers;
}

const toml::node& TomlReader::node(std::string_view key, std::string_view what_is_expected) const {
  const toml::node* found = table_.get(key);
  if (found == nullptr) {
    refuse(key, fmt::format("missing; expected {}", what_is_expected));
  }
  return *found;
}

void TomlReader::refuse_type(const toml::node& found, const std::string& path,
                             std::string_view what_is_expected) const {
  rgimp::refuse(source_, path,
                fmt::format("found {}; expected {}", type_name(found), what_is_expected));
}

void TomlReader::refuse_word(const std::string& path, const std::string& word,
                             std::span<const std::string_view> names) const {
  rgimp::refuse(source_, path,
                fmt::format("\"{}\" is not one of {}{}", word, fmt::join(names, ", "),
                            suggestion(word, names, "")));
}

void TomlReader::convert(const toml::node& from, const std::string& path, double& to) const {
  if (const auto* integer = from.as_integer()) {
    to = static_cast<double>(integer->get());
  } else if (const auto* real = from.as_floating_point()) {
    to = real->get();
  } else {
    refuse_type(from, path, expected(to));
  }
  if (!std::isfinite(to)) {
    rgimp::refuse(source_, path, fmt::format("is {}; expected a finite number", to));
  }
}

void TomlReader::convert(const toml::node& from, const std::string& path, int& to) const {
  std::int64_t wide = 0;
  convert(from, path, wide);
  if (wide < std::numeric_limits<int>::min() || wide > std::numeric_limits<int>::max()) {
    rgimp::refuse(source_, path, fmt::format("is {}; expected an integer of 32 bits", wide));
  }
  to = static_cast<int>(wide);
}

void TomlReader::convert(const toml::node& from, const std::string& path, std::int64_t& to) const {
  if (!from.is_integer()) {
    refuse_type(from, path, expected(to));
  }
  to = from.as_integer()->get();
}

void TomlReader::convert(const toml::node& from, const std::string& path, std::string& to) const {
  if (!from.is_string()) {
    refuse_type(from, path, expected(to));
  }
  to = from.as_string()->get();
}

void TomlReader::convert(const toml::node& from, const std::string& path, Vector& to) const {
  to = Vector::Zero();
  convert_numbers(from, path, {to.data(), static_cast<std::size_t>(dimension_)});
}

void TomlReader::convert(const toml::node& from, const std::string& path, Pair& to) const {
  convert_numbers(from, path, to);
}

void TomlReader::convert_numbers(const toml::node& from, const std::string& path,
                                 std::span<double> to) const {
  if (!from.is_array()) {
    refuse_type(from, path, expected_numbers(to.size()));
  }
  const toml::array& array = *from.as_array();
  if (array.size() != to.size()) {
    rgimp::refuse(source_, path,
                  fmt::format("has {} components; expected {}", array.size(), to.size()));
  }
  for (std::size_t i = 0; i < to.size(); ++i) {
    convert(array[i], fmt::format("{}[{}]", path, i), to[i]);
  }
}

void TomlReader::convert(const toml::node& from, const std::string& path,
                         std::vector<std::int64_t>& to) const {
  if (!from.is_array()) {
    refuse_type(from, path, expected(to));
  }
  to.clear();
  for (const toml::node& element : *from.as_array()) {
    const std::string place = fmt::format("{}[{}]", path, to.size());
    convert(element, place, to.emplace_back());
  }
}

}  // namespace rgimp
