#include <catch2/catch.hpp>
#include <string>

#include "output_directory.hpp"
#include "rgimp/error.hpp"
#include "temporary_directory.hpp"

namespace {

using namespace rgimp;
namespace fs = std::filesystem;

}  // namespace

TEST_CASE("a new output directory is created, with those above it") {
  const TemporaryDirectory temporary;
  const fs::path path = temporary / "a" / "b";
  {
    OutputDirectory directory(path, ExistingOutput::refuse);
    directory.keep();
  }
  CHECK(fs::is_directory(path / "snapshots"));
}

TEST_CASE("a run that never starts takes away what it created") {
  const TemporaryDirectory temporary;
  {
    const OutputDirectory directory(temporary / "a" / "b", ExistingOutput::refuse);
    write_text(directory.case_file(), "title");
    write_text(directory.snapshot_file(0), "");
    write_text(directory.series_file(), "");
  }
  CHECK(fs::is_empty(temporary.path()));
}

TEST_CASE("a run that never starts leaves the directory it was given, and files of others") {
  const TemporaryDirectory temporary;
  {
    const OutputDirectory directory(temporary.path(), ExistingOutput::refuse);
    write_text(directory.history_file(), "step");
    write_text(temporary / "notes.txt", "mine");
  }
  CHECK(fs::exists(temporary / "notes.txt"));
  CHECK_FALSE(fs::exists(temporary / "history.csv"));
  CHECK_FALSE(fs::exists(temporary / "snapshots"));
}

TEST_CASE("a directory that is not empty is refused and stays as it is") {
  const TemporaryDirectory temporary;
  write_text(temporary / "history.csv", "step");
  CHECK_THROWS_AS(OutputDirectory(temporary.path(), ExistingOutput::refuse), CaseError);
  CHECK_THROWS_WITH(OutputDirectory(temporary.path(), ExistingOutput::refuse),
                    Catch::Contains(temporary.path().string()) && Catch::Contains("--force"));
  CHECK(fs::exists(temporary / "history.csv"));
  CHECK_FALSE(fs::exists(temporary / "snapshots"));
}

TEST_CASE("replacing deletes our own files and no others") {
  const TemporaryDirectory temporary;
  fs::create_directories(temporary / "snapshots" / "step_mine.vtkhdf");
  fs::create_directory(temporary / "pictures");
  const auto ours = {"case.toml",
                     "history.csv",
                     "summary.json",
                     "summary.json.tmp",
                     "checkpoint_a.rgimp",
                     "checkpoint_b.rgimp.tmp",
                     "pictures/crack.png",
                     "pictures/slices.png",
                     "report.html",
                     "snapshots/step_000000000.vtkhdf",
                     "snapshots/step_000000100.vtkhdf.tmp",
                     "snapshots/step_1234567890.vtkhdf",
                     "snapshots/snapshots.hdf.series"};
  const auto others = {"notes.txt",
                       "history.csv.bak",
                       "checkpoint_c.rgimp",
                       "pictures/photo.png",
                       "crack.png",
                       "snapshots/view.pvsm",
                       "snapshots/step_.vtkhdf",
                       "snapshots/step_00000100.vtkhdf",
                       "snapshots/step_000000100_smoothed.vtkhdf",
                       "snapshots/step_000000100.vtkhdf.old",
                       "snapshots/my_step_000000100.vtkhdf"};
  for (const std::string name : ours) {
    write_text(temporary / name, "");
  }
  for (const std::string name : others) {
    write_text(temporary / name, "");
  }
  OutputDirectory directory(temporary.path(), ExistingOutput::replace);
  directory.keep();
  for (const std::string name : ours) {
    CHECK_FALSE(fs::exists(temporary / name));
  }
  for (const std::string name : others) {
    CHECK(fs::exists(temporary / name));
  }
  CHECK(fs::is_directory(temporary / "snapshots" / "step_mine.vtkhdf"));
}

TEST_CASE("places that cannot be written are errors of files") {
  const TemporaryDirectory temporary;
  write_text(temporary / "file", "");
  for (const ExistingOutput existing : {ExistingOutput::refuse, ExistingOutput::replace}) {
    CHECK_THROWS_AS(OutputDirectory(temporary / "file", existing), FileError);
    CHECK_THROWS_AS(OutputDirectory(temporary / "file" / "below", existing), FileError);
  }
  CHECK_THROWS_AS(OutputDirectory("", ExistingOutput::refuse), CaseError);
}

TEST_CASE("directories created on the way to a failure go again") {
  const TemporaryDirectory temporary;
  const std::string too_long(300, 'x');  // longer than names may be
  CHECK_THROWS_AS(OutputDirectory(temporary / "a" / too_long, ExistingOutput::refuse), FileError);
  CHECK(fs::is_empty(temporary.path()));
}

TEST_CASE("a directory that is resumed keeps what it holds, also where the run never starts") {
  const TemporaryDirectory temporary;
  write_text(temporary / "history.csv", "step");
  {
    const OutputDirectory directory(temporary.path(), ExistingOutput::resume);
    CHECK(fs::exists(temporary / "history.csv"));
  }
  CHECK(fs::exists(temporary / "history.csv"));
}

TEST_CASE("going back to a step removes what came later and what is unfinished") {
  const TemporaryDirectory temporary;
  fs::create_directory(temporary / "snapshots");
  const auto later = {"summary.json", "history.csv.tmp", "checkpoint_a.rgimp.tmp",
                      "snapshots/step_000000101.vtkhdf", "snapshots/step_000000300.vtkhdf.tmp"};
  const auto stays = {"history.csv",
                      "case.toml",
                      "checkpoint_a.rgimp",
                      "notes.tmp",
                      "snapshots/step_000000100.vtkhdf",
                      "snapshots/snapshots.hdf.series"};
  for (const std::string name : later) {
    write_text(temporary / name, "");
  }
  for (const std::string name : stays) {
    write_text(temporary / name, "");
  }
  OutputDirectory directory(temporary.path(), ExistingOutput::resume);
  directory.go_back_to(100);
  for (const std::string name : later) {
    CHECK_FALSE(fs::exists(temporary / name));
  }
  for (const std::string name : stays) {
    CHECK(fs::exists(temporary / name));
  }
}

TEST_CASE("a directory belongs to one run at a time") {
  const TemporaryDirectory temporary;
  {
    const OutputDirectory directory(temporary.path(), ExistingOutput::refuse);
    CHECK_THROWS_WITH(OutputDirectory(temporary.path(), ExistingOutput::replace),
                      Catch::Contains("another run is at work"));
  }
  const OutputDirectory directory(temporary.path(), ExistingOutput::replace);
  CHECK(fs::exists(temporary / "snapshots"));
}
