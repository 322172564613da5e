#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "history_file.hpp"
#include "output_directory.hpp"
#include "output_schedule.hpp"
#include "rgimp/simulation.hpp"
#include "snapshot.hpp"

namespace rgimp {

/// History and snapshots of one run, each written when the schedule asks for it.
class Recorder {
 public:
  /// Starts both anew.
  Recorder(const Simulation& simulation, OutputDirectory& directory);
  /// Goes on where a note was taken: the history is cut back to it, and later snapshots go. None,
  /// with nothing touched, where the note is not one of a recorder, or the history no longer what
  /// it was then. Throws FileError where the history cannot be read.
  static std::unique_ptr<Recorder> go_on(const Simulation& simulation, OutputDirectory& directory,
                                         std::string_view note);

  const OutputSchedule& schedule() const { return schedule_; }
  const HistoryRow& first_row() const { return first_row_; }
  const HistoryRow& last_row() const { return last_row_; }
  double largest_work() const { return largest_work_; }
  /// What the note's recorder computed with; empty for one that starts anew.
  const std::string& past_isa() const { return past_isa_; }

  void write_due();
  /// Whatever the schedule says: for the first step, and the last where the physics stopped early.
  void write_all();
  /// Brings the history to disk and says what a checkpoint must know to go on from here.
  std::string note();
  void close() { history_.close(); }

 private:
  struct Past;

  Recorder(const Simulation& simulation, OutputDirectory& directory, const Past& past,
           HistoryFile history);
  void write_history();
  void write_snapshot();

  const Simulation& simulation_;
  OutputDirectory& directory_;
  OutputSchedule schedule_;
  HistoryFile history_;
  HistoryRow first_row_;
  HistoryRow last_row_;
  std::optional<std::int64_t> history_step_;
  std::vector<SnapshotTime> snapshots_;
  double largest_work_ = 0.0;  // J
  std::string past_isa_;
};

}  // namespace rgimp
