#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <optional>

#include "case_arguments.hpp"
#include "messages.hpp"
#include "rgimp/grid_fields.hpp"
#include "verbs.hpp"

namespace rgimp::cli {

namespace {

struct GridArguments {
  std::filesystem::path directory;   // written by `rgimp run`
  std::optional<std::int64_t> step;  // none: of every snapshot
};

void write_fields(const GridArguments& arguments) {
  const WrittenGrids written = write_grids(arguments.directory, arguments.step);
  if (written.particles_outside > 0) {
    print_warning(
        fmt::format("{} particles of the last file lie outside the grid: no field has them",
                    written.particles_outside));
  }
  for (const std::filesystem::path& file : written.files) {
    fmt::print("{}\n", file.string());
  }
}

}  // namespace

void add_grid(CLI::App& app) {
  CLI::App* command = app.add_subcommand(
      "grid",
      "Write fields on the grid's nodes for every snapshot of an output directory: mass (kg), "
      "velocity (m/s), stress (Pa), damage");
  const auto arguments = std::make_shared<GridArguments>();
  add_results_option(*command, arguments->directory);
  command->add_option("--step", arguments->step, "Of the snapshot of this step only")
      ->type_name("N")
      ->check(at_least(0));
  command->footer(
      "Writes DIR/grid/step_*.vtkhdf, which ParaView and HDF5 readers open; grid.hdf.series "
      "beside\n"
      "them is all of them with their times. Nodes far from the rock have mass 0.\n"
      "Examples:\n"
      "  rgimp grid single_flaw\n"
      "  rgimp grid single_flaw --step 66240");
  command->callback([arguments] { write_fields(*arguments); });
}

}  // namespace rgimp::cli
