#include "main.hpp"

#include <benchmark/benchmark.h>

#include <vector>

#include "machine_context.hpp"

namespace {

/// The reporter that --benchmark_format asks for, with a memory for errors.
class ErrorWatch : public benchmark::BenchmarkReporter {
 public:
  bool ReportContext(const Context& context) override { return shown_.ReportContext(context); }
  void ReportRuns(const std::vector<Run>& runs) override {
    shown_.ReportRuns(runs);
    for (const Run& run : runs) {
      any_error_ = any_error_ || run.error_occurred;
    }
  }
  void Finalize() override { shown_.Finalize(); }

  bool any_error() const { return any_error_; }

 private:
  benchmark::BenchmarkReporter& shown_ = *benchmark::CreateDefaultDisplayReporter();
  bool any_error_ = false;
};

/// The arguments, behind defaults that they may override: medians of repetitions that take turns,
/// so that the drift of a machine hits all alike.
std::vector<char*> with_defaults(int argc, char** argv) {
  static char interleave[] = "--benchmark_enable_random_interleaving=true";
  static char repeat[] = "--benchmark_repetitions=5";
  static char aggregate[] = "--benchmark_report_aggregates_only=true";
  static char tabular[] = "--benchmark_counters_tabular=true";
  static char time[] = "--benchmark_min_time=0.3";
  std::vector<char*> arguments{argv[0], interleave, repeat, aggregate, tabular, time};
  arguments.insert(arguments.end(), argv + 1, argv + argc);
  return arguments;
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<char*> arguments = with_defaults(argc, argv);
  int count = static_cast<int>(arguments.size());
  benchmark::Initialize(&count, arguments.data());
  if (benchmark::ReportUnrecognizedArguments(count, arguments.data())) {
    return 2;
  }
  rgimp::bench::add_machine_context();
  rgimp::bench::add_benchmarks();
  ErrorWatch watch;
  benchmark::RunSpecifiedBenchmarks(&watch);
  return watch.any_error() ? 1 : 0;
}
