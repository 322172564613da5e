#pragma once

#include <optional>

namespace rgimp::cli {

/// While it lives SIGINT and SIGTERM are noted instead of ending the process, so that a run can
/// save itself; the second one ends it. A file that outgrows the allowed size fails like a full
/// disk, instead of raising a signal.
class Interruption {
 public:
  Interruption();
  ~Interruption();
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;

  /// The number of the signal that came.
  std::optional<int> signal() const;
};

}  // namespace rgimp::cli
