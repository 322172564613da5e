#pragma once

#include <stdexcept>

namespace rgimp {

/// What RGIMP throws. The command turns each kind into its own exit code.
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

/// The physics stopped the run (exit code 3): time step past critical, a value that is not a
/// number, a particle out of the grid.
class PhysicsError : public Error {
 public:
  using Error::Error;
};

/// Reading or writing files failed (exit code 4).
class FileError : public Error {
 public:
  using Error::Error;
};

}  // namespace rgimp
