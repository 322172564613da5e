#include "output_directory.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <system_error>
#include <utility>

#include "atomic_file.hpp"
#include "rgimp/error.hpp"
#include "snapshot.hpp"

namespace rgimp {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view kPictures = "pictures";
// Not .vtkhdf.series: ParaView 5.11 has a reader for what the snapshots hold, but looks for it by
// the ending .hdf alone.
constexpr std::string_view kSeries = "snapshots.hdf.series";

[[noreturn]] void fail(const fs::path& path, const std::error_code& error) {
  throw FileError(
      fmt::format("cannot use output directory '{}': {}", path.string(), error.message()));
}

/// The name a file has, or will have once it is finished.
std::string final_name(const fs::path& file) {
  std::string name = file.filename().string();
  if (name.ends_with(kTemporarySuffix)) {
    name.resize(name.size() - kTemporarySuffix.size());
  }
  return name;
}

template <std::size_t Count>
bool is_one_of(const fs::path& file, const std::array<std::string_view, Count>& names) {
  return std::find(names.begin(), names.end(), final_name(file)) != names.end();
}

constexpr std::array<std::string_view, 2> kCheckpoints{"checkpoint_a.rgimp", "checkpoint_b.rgimp"};

bool is_top_file(const fs::path& file) {
  constexpr std::array<std::string_view, 5> names{"case.toml", "history.csv", "summary.json",
                                                  kCheckpoints[0], kCheckpoints[1]};
  return is_one_of(file, names);
}

/// What rgimp-plot draws: beside new results, pictures of the replaced ones would mislead.
bool is_picture(const fs::path& file) {
  constexpr std::array<std::string_view, 6> names{"crack.png",  "slices.png",         "stress.png",
                                                  "growth.png", "stress_closure.png", "energy.png"};
  return is_one_of(file, names);
}

/// What rgimp-report writes, for the same reason.
bool is_report(const fs::path& file) {
  return file.filename() == "report.html";
}

bool is_snapshot_file(const fs::path& file) {
  const std::string name = final_name(file);
  return name == kSeries || name == kGridSeries || is_snapshot_name(name);
}

template <typename Choice>
void remove_files(const fs::path& directory, Choice is_ours) {
  if (!fs::is_directory(directory)) {
    return;
  }
  std::vector<fs::path> ours;  // listed first: removing under a running listing may skip files
  for (const fs::directory_entry& entry : fs::directory_iterator(directory)) {
    if (!entry.is_directory() && is_ours(entry.path())) {
      ours.push_back(entry.path());
    }
  }
  for (const fs::path& file : ours) {
    fs::remove(file);
  }
}

/// Removes what a run writes and nothing else. Throws std::filesystem::filesystem_error.
void remove_own_files(const fs::path& directory) {
  remove_files(directory / kSnapshots, is_snapshot_file);
  remove_files(directory / kGrid, is_snapshot_file);
  remove_files(directory / kPictures, is_picture);
  remove_files(directory, is_report);
  remove_files(directory, is_top_file);
  for (const std::string_view emptied : {kGrid, kPictures}) {  // the run makes none anew
    std::error_code not_empty;
    fs::remove(directory / emptied, not_empty);
  }
}

/// Through a link we would delete and write outside the output directory. A file's link is itself
/// replaced, but where a run goes on.
void refuse_links(const fs::path& directory, ExistingOutput existing) {
  for (const fs::directory_entry& entry : fs::directory_iterator(directory)) {
    const fs::path name = entry.path().filename();
    const bool is_followed = name == kSnapshots || name == kGrid || name == kPictures ||
                             (existing == ExistingOutput::resume && is_top_file(name));
    if (entry.is_symlink() && is_followed) {
      throw FileError(
          fmt::format("cannot use output directory '{}': '{}' in it is a symbolic link, which may "
                      "lead out of it",
                      directory.string(), name.string()));
    }
  }
}

}  // namespace

NewDirectories::~NewDirectories() {
  for (auto directory = made_.rbegin(); directory != made_.rend(); ++directory) {
    std::error_code ignored;  // it may hold files of others by now
    fs::remove(*directory, ignored);
  }
}

void NewDirectories::create(const fs::path& directory) {
  if (directory.empty() || fs::exists(directory)) {
    return;
  }
  create(directory.parent_path());
  if (fs::create_directory(directory)) {
    made_.push_back(directory);
  }
}

DirectoryLock::~DirectoryLock() {
  if (descriptor_) {
    close(*descriptor_);
  }
}

void DirectoryLock::take(const fs::path& directory) {
  descriptor_ = open(directory.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  // File systems that cannot lock are no reason not to run.
  if (flock(*descriptor_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
    throw CaseError(
        fmt::format("another run is at work in output directory '{}'", directory.string()));
  }
}

OutputDirectory::OutputDirectory(fs::path path, ExistingOutput existing) : path_(std::move(path)) {
  if (path_.empty()) {
    throw CaseError("the output directory has no name");
  }
  try {
    if (fs::exists(path_) && !fs::is_directory(path_)) {
      fail(path_, std::make_error_code(std::errc::not_a_directory));
    }
    new_directories_.create(path_);
    lock_.take(path_);  // before looking: another run may just come to its end here
    const bool is_used = !fs::is_empty(path_);
    if (is_used && existing == ExistingOutput::refuse) {
      throw CaseError(fmt::format(
          "output directory '{}' is not empty: choose another one, go on with its run with "
          "--resume, or replace its results with --force",
          path_.string()));
    }
    refuse_links(path_, existing);
    if (is_used && existing == ExistingOutput::replace) {
      clear();
    }
    kept_ = is_used && existing == ExistingOutput::resume;
    new_directories_.create(path_ / kSnapshots);
  } catch (const fs::filesystem_error& error) {
    fail(path_, error.code());
  }
}

OutputDirectory::~OutputDirectory() {
  if (kept_) {
    return;
  }
  try {
    remove_own_files(path_);
  } catch (const fs::filesystem_error&) {  // an error is under way already, and says more
  }
}

void OutputDirectory::keep() {
  kept_ = true;
  new_directories_.keep();
}

void OutputDirectory::clear() {
  try {
    remove_own_files(path_);
  } catch (const fs::filesystem_error& error) {
    fail(path_, error.code());
  }
}

void OutputDirectory::go_back_to(std::int64_t step) {
  const auto is_later = [step](const fs::path& file) {
    return is_snapshot_name(final_name(file)) && final_name(file) > snapshot_name(step);
  };
  const auto is_unfinished = [](const fs::path& file) {
    return file.filename() == "summary.json" ||
           (is_top_file(file) && file.filename() != final_name(file));
  };
  try {
    remove_files(path_ / kSnapshots, is_later);
    remove_files(path_ / kGrid, is_later);
    remove_files(path_, is_unfinished);
  } catch (const fs::filesystem_error& error) {
    fail(path_, error.code());
  }
}

std::array<fs::path, 2> OutputDirectory::checkpoint_files() const {
  return {path_ / kCheckpoints[0], path_ / kCheckpoints[1]};
}

fs::path OutputDirectory::snapshot_file(std::int64_t step) const {
  return path_ / kSnapshots / snapshot_name(step);
}

fs::path OutputDirectory::series_file() const {
  return path_ / kSnapshots / kSeries;
}

}  // namespace rgimp
