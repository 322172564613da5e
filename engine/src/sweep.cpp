#include "rgimp/sweep.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <set>

#include "rgimp/case_file.hpp"
#include "rgimp/error.hpp"
#include "sweep_ranges.hpp"

namespace rgimp {

namespace {

constexpr std::size_t kMostCases = 10000;  // more is a slip of the pen

/// An override as it is given, and its values; what it sets is fixed where there is one alone.
struct Change {
  std::string key;
  std::vector<std::string> values;

  bool varies() const { return values.size() > 1; }
};

std::vector<Change> read_changes(std::span<const std::string> overrides) {
  std::vector<Change> changes;
  std::set<std::string> varied;
  for (const std::string& text : overrides) {
    changes.push_back({range_key(text), range_values(text)});
    if (changes.back().varies() && !varied.insert(changes.back().key).second) {
      throw CaseError(fmt::format("--set {}: {} is varied already", text, changes.back().key));
    }
  }
  if (varied.empty()) {
    throw CaseError(
        "nothing to sweep over: expected a range, as in --set 'flaw[0].angle=0:90:15' or "
        "--set 'time.integrator=musl|usl'");
  }
  return changes;
}

std::size_t count_cases(const std::vector<SweepRange>& ranges) {
  std::size_t count = 1;
  for (const SweepRange& range : ranges) {
    count *= range.values.size();
    if (count > kMostCases) {
      throw CaseError(fmt::format("the ranges make more than {} cases", kMostCases));
    }
  }
  return count;
}

/// Of combination `index`, the last range varying fastest.
std::vector<std::string> values_of(const std::vector<SweepRange>& ranges, std::size_t index) {
  std::vector<std::string> values(ranges.size());
  for (std::size_t i = ranges.size(); i-- > 0;) {
    values[i] = ranges[i].values[index % ranges[i].values.size()];
    index /= ranges[i].values.size();
  }
  return values;
}

/// The overrides of one case, in the order in which they were given.
std::vector<std::string> overrides_of(const std::vector<Change>& changes,
                                      const std::vector<std::string>& values) {
  std::vector<std::string> overrides;
  overrides.reserve(changes.size());
  auto value = values.begin();
  for (const Change& change : changes) {
    overrides.push_back(
        fmt::format("{}={}", change.key, change.varies() ? *value++ : change.values.front()));
  }
  return overrides;
}

}  // namespace

Sweep read_sweep(const std::filesystem::path& path, std::span<const std::string> overrides) {
  const std::vector<Change> changes = read_changes(overrides);
  Sweep sweep;
  for (const Change& change : changes) {
    if (change.varies()) {
      sweep.ranges.push_back({change.key, change.values});
    }
  }
  const std::size_t count = count_cases(sweep.ranges);
  const std::size_t digits = std::max<std::size_t>(3, std::to_string(count).size());
  for (std::size_t i = 0; i < count; ++i) {
    SweepCase one{fmt::format("{:0{}}", i + 1, digits), values_of(sweep.ranges, i), {}};
    try {
      one.settings = read_case(path, overrides_of(changes, one.values));
    } catch (const CaseError& error) {
      throw CaseError(
          fmt::format("case {} ({}): {}", one.name, describe(sweep, one), error.what()));
    }
    if (!one.settings.source.overridden.contains("tuning.threads")) {
      one.settings.tuning.threads = 1;
    }
    sweep.cases.push_back(std::move(one));
  }
  return sweep;
}

std::string describe(const Sweep& sweep, const SweepCase& one) {
  std::string text;
  for (std::size_t i = 0; i < sweep.ranges.size(); ++i) {
    text += fmt::format("{}{}={}", i == 0 ? "" : ", ", sweep.ranges[i].key, one.values[i]);
  }
  return text;
}

std::string_view describe(SweepStatus status) {
  switch (status) {
    case SweepStatus::pending:
      break;
    case SweepStatus::finished:
      return "finished";
    case SweepStatus::stopped:
      return "stopped";
    case SweepStatus::physics_stopped:
      return "physics stopped";
    case SweepStatus::failed:
      return "failed";
  }
  return "pending";
}

}  // namespace rgimp
