#include "machine_context.hpp"

#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <unistd.h>

#include <fstream>
#include <string>

#include "rgimp/kernels/table.hpp"
#include "rgimp/version.hpp"

namespace rgimp::bench {
namespace {

/// The first value of a key in /proc/cpuinfo, "key : value" by line.
std::string cpu_info(const std::string& key) {
  std::ifstream file("/proc/cpuinfo");
  std::string line;
  while (std::getline(file, line)) {
    const std::size_t colon = line.find(": ");
    if (colon != std::string::npos &&
        line.substr(0, line.find_last_not_of("\t ", colon - 1) + 1) == key) {
      return line.substr(colon + 2);
    }
  }
  return "unknown";
}

std::string memory() {
  constexpr double kGibibyte = 1024.0 * 1024.0 * 1024.0;
  const double bytes =
      static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
  return fmt::format("{:.0f} GiB", bytes / kGibibyte);
}

std::string available_isas() {
  std::string names;
  for (const kernels::Isa isa : kernels::kAllIsas) {
    if (kernels::available(isa)) {
      names += (names.empty() ? "" : ", ") + std::string(kernels::name(isa));
    }
  }
  return names;
}

}  // namespace

void add_machine_context() {
  using benchmark::AddCustomContext;
  AddCustomContext("cpu", fmt::format("{} (family {}, model {})", cpu_info("model name"),
                                      cpu_info("cpu family"), cpu_info("model")));
  AddCustomContext("memory", memory());
  AddCustomContext("isas", available_isas());
  AddCustomContext("compiler", RGIMP_BENCH_COMPILER);
  AddCustomContext("flags", RGIMP_BENCH_FLAGS);
  AddCustomContext("avx2_flags", RGIMP_BENCH_AVX2_FLAGS);
  AddCustomContext("avx512_flags", RGIMP_BENCH_AVX512_FLAGS);
  AddCustomContext("version", std::string(version()));
}

}  // namespace rgimp::bench
