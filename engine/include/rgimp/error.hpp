#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>

namespace rgimp {

/// What RGIMP throws, beside std::bad_alloc where memory runs out. It never ends the process and
/// prints nothing. The command turns each kind into its own exit code.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The case, or the request around it, is wrong (exit code 2). The message says where
/// (file, line, key), what is wrong and what was expected.
class CaseError : public Error {
 public:
  using Error::Error;
};

/// Where the physics stopped.
struct PhysicsReport {
  /// After which the guard saw it.
  std::int64_t step = 0;
  std::optional<std::uint32_t> particle;  ///< id, the lowest of several; none: no single particle
  std::array<double, 3> position{};       ///< m, of the particle
  std::array<double, 3> velocity{};       ///< m/s, of the particle
  double critical_step_ratio = 0.0;       ///< dt/dt_cr, Eq. 22
};

/// The physics stopped the run (exit code 3): time step past critical, a value that is not finite,
/// a volume that is not positive, a particle out of the grid. The message says what happened, where
/// and what to do.
class PhysicsError : public Error {
 public:
  /// `message` is for people; it says what the report does, and what to do.
  explicit PhysicsError(const std::string& message, const PhysicsReport& report = {})
      : Error(message), report_(report) {}

  /// For programs.
  const PhysicsReport& report() const { return report_; }

 private:
  PhysicsReport report_;
};

/// Reading or writing files failed (exit code 4).
class FileError : public Error {
 public:
  using Error::Error;
};

}  // namespace rgimp
