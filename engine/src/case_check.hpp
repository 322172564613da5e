#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "rgimp/case.hpp"

/// The parts of check_case; each throws CaseError at the first thing wrong. Later parts rely on
/// what earlier ones have found right, in this order.
namespace rgimp {

void check_dimension(const Case& settings);
void check_materials(const Case& settings);
void check_time(const Case& settings);
/// Number of nodes and particles, against what can be counted, and their memory against
/// `available_bytes`, where that is known. Allocates nothing.
void check_amount(const Case& settings, std::optional<double> available_bytes);
/// Number of nodes and particles, and where the bodies and platens lie in the grid.
void check_grid(const Case& settings);
/// How bodies and flaws lie to each other and to the lattice. Returns warnings.
std::vector<std::string> check_bodies_and_flaws(const Case& settings);

/// Single numbers and vectors under the name of their key.
class ValueChecker {
 public:
  explicit ValueChecker(const Case& settings) : case_(settings) {}

  void positive(std::string_view key, double value) const;
  void not_negative(std::string_view key, double value) const;
  void finite(std::string_view key, double value) const;
  /// Finite, and zero along z in two dimensions.
  void vector(std::string_view key, const Vector& value) const;
  /// Such a vector that is not zero.
  void direction(std::string_view key, const Vector& value) const;
  /// Above 0 along every axis.
  void edges(std::string_view key, const Vector& value) const;
  void at_least_one(std::string_view key, std::int64_t value) const;
  [[noreturn]] void refuse(std::string_view key, std::string_view what) const;

 private:
  const Case& case_;
};

}  // namespace rgimp
