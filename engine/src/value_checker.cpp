#include <cmath>

#include "case_check.hpp"
#include "case_error.hpp"

namespace rgimp {

void ValueChecker::refuse(std::string_view key, std::string_view what) const {
  rgimp::refuse(case_.source, key, what);
}

void ValueChecker::finite(std::string_view key, double value) const {
  if (!std::isfinite(value)) {
    refuse(key, fmt::format("is {}; expected a finite number", value));
  }
}

void ValueChecker::positive(std::string_view key, double value) const {
  finite(key, value);
  if (value <= 0.0) {
    refuse(key, fmt::format("is {}; expected a number above 0", value));
  }
}

void ValueChecker::not_negative(std::string_view key, double value) const {
  finite(key, value);
  if (value < 0.0) {
    refuse(key, fmt::format("is {}; expected 0 or more", value));
  }
}

void ValueChecker::vector(std::string_view key, const Vector& value) const {
  for (int axis = 0; axis < 3; ++axis) {
    finite(fmt::format("{}[{}]", key, axis), value[axis]);
  }
  if (case_.dimension == 2 && value.z() != 0.0) {
    refuse(key, fmt::format("is {} along z; expected 0 in two dimensions", value.z()));
  }
}

void ValueChecker::direction(std::string_view key, const Vector& value) const {
  vector(key, value);
  const double length = std::hypot(value.x(), value.y(), value.z());
  constexpr double kLongest = 1e100;  // squares of lengths from 1 / kLongest on are numbers
  if (!(length >= 1.0 / kLongest && length <= kLongest)) {
    refuse(key, fmt::format("is of length {:.4g}; expected a direction", length));
  }
}

void ValueChecker::edges(std::string_view key, const Vector& value) const {
  vector(key, value);
  for (int axis = 0; axis < case_.dimension; ++axis) {
    positive(fmt::format("{}[{}]", key, axis), value[axis]);
  }
}

void ValueChecker::at_least_one(std::string_view key, std::int64_t value) const {
  if (value < 1) {
    refuse(key, fmt::format("is {}; expected 1 or more", value));
  }
}

}  // namespace rgimp
