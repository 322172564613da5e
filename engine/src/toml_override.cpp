#include "toml_override.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <string_view>
#include <vector>

#include "case_error.hpp"
#include "trim.hpp"

namespace rgimp {
namespace {

class Override {
 public:
  Override(const std::string& text, CaseSource& source) : text_(text), source_(source) {}

  void apply_to(toml::table& root);

 private:
  [[noreturn]] void refuse(std::string_view what) const {
    throw CaseError(fmt::format("--set {}: {}", text_, what));
  }
  std::vector<std::string> segments(std::string_view key) const;
  toml::table parse_value(std::string_view value) const;
  /// What `segment` names inside `parent`, made where `parent` is a table that lacks it.
  toml::node& descend(toml::node& parent, const std::string& segment);
  void assign(toml::node& parent, const std::string& segment, toml::node& value);
  std::size_t index_in(const toml::array& array, const std::string& segment) const;
  void enter(const toml::node& parent, const std::string& segment);
  void note_source();

  const std::string& text_;
  CaseSource& source_;
  std::string path_;  // of the node reached so far, "body[0].size"
};

constexpr std::string_view kValue = "value";

bool is_below(std::string_view key, std::string_view path) {
  return key.starts_with(path) &&
         (key.size() == path.size() || key[path.size()] == '.' || key[path.size()] == '[');
}

std::size_t word_length(std::string_view text) {
  const auto* const end = std::find_if_not(text.begin(), text.end(), [](unsigned char c) {
    return std::isalnum(c) != 0 || c == '-' || c == '_';
  });
  return static_cast<std::size_t>(end - text.begin());
}

/// "body[0].size" -> body, 0, size.
std::vector<std::string> Override::segments(std::string_view key) const {
  std::vector<std::string> names;
  std::string_view rest = trim(key);
  for (char before = '.'; before == '.' || before == '[';) {
    const std::size_t length = word_length(rest);
    if (length == 0) {
      break;
    }
    names.emplace_back(rest.substr(0, length));
    rest.remove_prefix(length);
    if (before == '[') {
      if (!rest.starts_with(']')) {
        break;
      }
      rest.remove_prefix(1);
    }
    if (rest.empty()) {
      return names;
    }
    before = rest.front();
    rest.remove_prefix(1);
  }
  refuse("expected a dotted key before '=', as in body[0].size=[0.05, 0.1]");
}

toml::table Override::parse_value(std::string_view value) const {
  try {
    toml::table parsed = toml::parse(std::string_view(fmt::format("{} = {}", kValue, value)));
    if (parsed.size() == 1) {
      return parsed;
    }
  } catch (const toml::parse_error&) {
    const std::string_view word = trim(value);
    if (!word.empty() && word_length(word) == word.size() &&
        std::isalpha(static_cast<unsigned char>(word.front())) != 0) {
      toml::table quoted;
      quoted.insert(kValue, std::string(word));
      return quoted;
    }
  }
  refuse(
      fmt::format("\"{}\" is not a TOML value; expected a number, a \"string\", an [array] or "
                  "a bare word",
                  value));
}

void Override::apply_to(toml::table& root) {
  const std::size_t equals = text_.find('=');
  if (equals == std::string::npos) {
    refuse("expected KEY=VALUE");
  }
  const std::vector<std::string> way = segments(std::string_view(text_).substr(0, equals));
  toml::table parsed = parse_value(std::string_view(text_).substr(equals + 1));
  toml::node* parent = &root;
  for (std::size_t i = 0; i + 1 < way.size(); ++i) {
    parent = &descend(*parent, way[i]);
  }
  assign(*parent, way.back(), *parsed.get(kValue));
  note_source();
}

toml::node& Override::descend(toml::node& parent, const std::string& segment) {
  enter(parent, segment);
  if (toml::array* array = parent.as_array()) {
    return (*array)[index_in(*array, segment)];
  }
  return parent.as_table()->insert(segment, toml::table{}).first->second;
}

void Override::assign(toml::node& parent, const std::string& segment, toml::node& value) {
  enter(parent, segment);
  value.visit([&](auto& typed) {
    if (toml::array* array = parent.as_array()) {
      const auto index = static_cast<std::ptrdiff_t>(index_in(*array, segment));
      array->replace(array->cbegin() + index, std::move(typed));
    } else {
      parent.as_table()->insert_or_assign(segment, std::move(typed));
    }
  });
}

std::size_t Override::index_in(const toml::array& array, const std::string& segment) const {
  std::size_t index = array.size();
  const auto [end, error] = std::from_chars(segment.data(), segment.data() + segment.size(), index);
  if (error != std::errc{} || end != segment.data() + segment.size() || index >= array.size()) {
    refuse(fmt::format("{} does not exist; the array's length is {}", path_, array.size()));
  }
  return index;
}

void Override::enter(const toml::node& parent, const std::string& segment) {
  if (!parent.is_table() && !parent.is_array()) {
    refuse(fmt::format("{} is a single value and has no \"{}\"", path_, segment));
  }
  if (parent.is_array()) {
    path_ += fmt::format("[{}]", segment);
  } else {
    path_ += path_.empty() ? segment : "." + segment;
  }
}

void Override::note_source() {
  const auto replaced = [&](const auto& entry) { return is_below(entry.first, path_); };
  std::erase_if(source_.line, replaced);
  std::erase_if(source_.overridden, replaced);
  source_.overridden[path_] = text_;
}

}  // namespace

void apply_override(toml::table& root, const std::string& text, CaseSource& source) {
  Override(text, source).apply_to(root);
}

}  // namespace rgimp
