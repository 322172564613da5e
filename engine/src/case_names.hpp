#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "rgimp/case.hpp"

/// The words of a case file, in one place for reading, checking and writing it.
namespace rgimp {

template <typename Enum>
struct Named {
  Enum value;
  std::string_view name;
};

std::span<const Named<OnExit>> names_of(OnExit);
std::span<const Named<BodyShape>> names_of(BodyShape);
std::span<const Named<FlawShape>> names_of(FlawShape);
std::span<const Named<SlotEnds>> names_of(SlotEnds);
std::span<const Named<Criterion>> names_of(Criterion);
std::span<const Named<Treatment>> names_of(Treatment);
std::span<const Named<Side>> names_of(Side);
std::span<const Named<Lateral>> names_of(Lateral);
std::span<const Named<Integrator>> names_of(Integrator);

template <typename Enum>
std::string_view name_of(Enum value) {
  for (const Named<Enum>& entry : names_of(value)) {
    if (entry.value == value) {
      return entry.name;
    }
  }
  return {};
}

/// Some shapes and sides are of two or of three dimensions only.
bool exists_in(int dimension, BodyShape shape);
bool exists_in(int dimension, FlawShape shape);
bool exists_in(int dimension, Side side);
template <typename Enum>
bool exists_in(int, Enum) {
  return true;
}

/// The words that a case of this dimension may use.
template <typename Enum>
std::vector<std::string_view> all_names(int dimension) {
  std::vector<std::string_view> names;
  for (const Named<Enum>& entry : names_of(Enum{})) {
    if (exists_in(dimension, entry.value)) {
      names.push_back(entry.name);
    }
  }
  return names;
}

/// A number that a criterion or a treatment reads.
struct FailureKey {
  std::string_view key;
  double Failure::*member;
  std::string_view unit;
};

std::span<const FailureKey> strengths_of(Criterion criterion);
/// Every strength that some criterion reads, each key once.
std::span<const FailureKey> all_strengths();
/// The fracture energies that go with a criterion; each may be left out.
std::span<const FailureKey> fracture_energies_of(Criterion criterion);
/// The limits of the pressure window; none for the other treatments.
std::span<const FailureKey> limits_of(Treatment treatment);
std::vector<std::string_view> keys_of(std::span<const FailureKey> entries);

/// The keys that describe a flaw besides `shape` and `center`.
std::span<const std::string_view> dimensions_of(FlawShape shape, int dimension);

}  // namespace rgimp
