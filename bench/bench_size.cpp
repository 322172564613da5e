// Time per particle-step and start-up from a thousand to twenty million particles of example 1.

#include "main.hpp"
#include "step_timing.hpp"

namespace rgimp::bench {

void add_benchmarks() {
  // Each about three times the particles of the one before.
  constexpr int kCellsAcross[] = {11, 19, 34, 58, 100, 175, 300, 525, 910, 1580};
  for (const int cells : kCellsAcross) {
    for (const int threads : kThreadCounts) {
      Setting setting;
      setting.isa = kernels::best_isa();
      setting.threads = threads;
      setting.cells_across = cells;
      add_step_benchmark("size", setting);
    }
  }
}

}  // namespace rgimp::bench
