#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "output_directory.hpp"
#include "recorder.hpp"

namespace rgimp {

/// Whether a run in the directory has done all steps of the simulation's case already.
bool is_finished(const OutputDirectory& directory, const Simulation& simulation);

/// Throws CaseError where the case file of an output directory is there and is another case's.
void require_case_of(const std::filesystem::path& case_file, const Case& settings);

/// Where a run goes on.
struct Resumption {
  std::filesystem::path checkpoint;
  std::unique_ptr<Recorder> recorder;
};

using Notice = std::function<void(const std::string&)>;

/// Restores the newest checkpoint of the directory that is whole and fits its history; none where
/// there is no checkpoint at all. Each one that cannot be used is told to `notice`. Throws
/// FileError where none of them can, or the files of the run cannot be read and written, CaseError
/// for another case's checkpoint and for one past the last step.
std::optional<Resumption> restore_newest(Simulation& simulation, OutputDirectory& directory,
                                         const Notice& notice);

}  // namespace rgimp
