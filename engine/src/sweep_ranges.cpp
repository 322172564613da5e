#include "sweep_ranges.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <optional>

#include "rgimp/error.hpp"
#include "trim.hpp"

namespace rgimp {
namespace {

constexpr double kMostValues = 10000.0;  // more is a slip of the pen

[[noreturn]] void refuse(std::string_view change, std::string_view what) {
  throw CaseError(fmt::format("--set {}: {}", change, what));
}

/// At every `separator` that is in no string.
std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  char quote = '\0';  // that of the string around the character, if it is in one
  std::size_t start = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (quote != '\0') {
      if (c == '\\' && quote == '"') {
        ++i;  // what is escaped ends no string
      } else if (c == quote) {
        quote = '\0';
      }
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == separator) {
      parts.push_back(trim(text.substr(start, i - start)));
      start = i + 1;
    }
  }
  parts.push_back(trim(text.substr(start)));
  return parts;
}

std::optional<double> number(std::string_view text) {
  double value = 0.0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  const bool is_number = error == std::errc{} && stop == end && std::isfinite(value);
  return is_number ? std::optional(value) : std::nullopt;
}

/// Rounded to 12 digits: 0.1:0.3:0.1 gives 0.3 and not 0.30000000000000004.
std::vector<std::string> steps(std::string_view change,
                               const std::vector<std::string_view>& parts) {
  constexpr double kShareOfStep = 1e-9;  // round-off
  std::array<double, 3> values{};
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto value = parts.size() == values.size() ? number(parts[i]) : std::nullopt;
    if (!value) {
      refuse(change, "expected numbers as START:STOP:STEP, or values as A|B|C");
    }
    values[i] = *value;
  }
  const auto [start, stop, step] = values;
  const double count = std::floor((stop - start) / step + kShareOfStep) + 1.0;
  if (step == 0.0 || count < 1.0) {
    refuse(change, fmt::format("steps of {:g} do not lead from {:g} to {:g}", step, start, stop));
  }
  if (count > kMostValues) {
    refuse(change, fmt::format("makes {:.4g} values; expected at most {:.0f}", count, kMostValues));
  }
  std::vector<std::string> texts;
  texts.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < static_cast<int>(count); ++i) {
    texts.push_back(fmt::format("{:.12g}", start + i * step + 0.0));  // never -0
  }
  return texts;
}

}  // namespace

std::string range_key(std::string_view change) {
  return std::string(trim(change.substr(0, change.find('='))));
}

std::vector<std::string> range_values(const std::string& change) {
  const std::size_t equals = change.find('=');
  if (equals == std::string::npos) {
    refuse(change, "expected KEY=VALUE, KEY=START:STOP:STEP or KEY=A|B|C");
  }
  const std::string_view value = trim(std::string_view(change).substr(equals + 1));
  const std::vector<std::string_view> alternatives = split(value, '|');
  if (alternatives.size() > 1) {
    return {alternatives.begin(), alternatives.end()};
  }
  const std::vector<std::string_view> parts = split(value, ':');
  return parts.size() > 1 ? steps(change, parts) : std::vector<std::string>{std::string(value)};
}

}  // namespace rgimp
