#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "rgimp/case.hpp"
#include "rgimp/simulation.hpp"

namespace rgimp {

/// A case and its particles as a run of it left them.
struct Results {
  /// As in the case.toml of the run.
  Case settings;
  /// Of the last snapshot.
  ParticleTable particles;
};

/// The last snapshot of an output directory of run_case, however far the run got. With `until`,
/// what failed after that step is intact again; all else stays. Throws CaseError where it is no
/// output directory or `until` lies past its last snapshot, FileError where a file cannot be read
/// or is damaged.
Results read_results(const std::filesystem::path& directory,
                     std::optional<std::int64_t> until = std::nullopt);

}  // namespace rgimp
