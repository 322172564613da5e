#pragma once

namespace rgimp::cli {

/// What the command tells its caller. A run stopped by a signal gives kStoppedBySignal and the
/// signal's number, as shells have it.
enum ExitCode {
  kDone = 0,
  kUnexpected = 1,
  kWrongRequest = 2,
  kPhysicsStopped = 3,
  kFileTrouble = 4,
  kStoppedBySignal = 128
};

}  // namespace rgimp::cli
