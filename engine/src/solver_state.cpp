#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "solver.hpp"

/// Saving and restoring a solver: what changes from step to step. All else follows from the case.
namespace rgimp {
namespace {

/// Calls archive(name, column) for all columns of the particles.
template <int Dim, typename Archive>
void archive_particles(Particles<Dim>& particles, const Archive& archive) {
  int number = 0;
  particles.for_each_column(
      [&](auto& column, auto) { archive(fmt::format("particle column {}", number++), column); });
  archive("first slots of groups", particles.group_begin);
  archive("materials of slots", particles.slot_material);
}

/// The numbers of a first failure, empty for none.
std::vector<double> pack(const std::optional<FirstFailure>& failure) {
  if (!failure) {
    return {};
  }
  return {static_cast<double>(failure->step),
          failure->closure,
          failure->axial_stress,
          failure->position.x(),
          failure->position.y(),
          failure->position.z(),
          static_cast<double>(failure->mode)};
}

std::optional<FirstFailure> unpack(const std::vector<double>& numbers,
                                   const CheckpointReader& checkpoint) {
  if (numbers.empty()) {
    return std::nullopt;
  }
  const auto tension = static_cast<double>(FailureMode::tension);
  const auto shear = static_cast<double>(FailureMode::shear);
  if (numbers.size() != 7 || !(numbers[0] >= 0.0 && numbers[0] <= 4294967296.0) ||
      (numbers[6] != tension && numbers[6] != shear)) {
    checkpoint.refuse("its first failure is none");
  }
  FirstFailure failure;
  failure.step = static_cast<std::int64_t>(numbers[0]);
  failure.closure = numbers[1];
  failure.axial_stress = numbers[2];
  failure.position = Vector(numbers[3], numbers[4], numbers[5]);
  failure.mode = numbers[6] == tension ? FailureMode::tension : FailureMode::shear;
  return failure;
}

/// The groups hold their slots in order, and all slots are in one.
bool has_layout(const Column<std::uint32_t>& group_begin, std::size_t groups, std::size_t slots) {
  return group_begin.size() == groups + 1 && group_begin.front() == 0 &&
         group_begin.back() == slots && std::is_sorted(group_begin.begin(), group_begin.end());
}

/// Kernels trust the layout and ids; what they would reach outside the columns with is refused.
template <int Dim>
void check_particles(Particles<Dim>& particles, std::size_t groups, std::size_t materials,
                     const std::vector<std::uint8_t>& material_of_id,
                     const CheckpointReader& checkpoint) {
  const std::size_t slots = particles.slot_material.size();
  if (!has_layout(particles.group_begin, groups, slots)) {
    checkpoint.refuse("its groups are not those of this case");
  }
  particles.for_each_column([&](const auto& column, auto) {
    if (column.size() != slots * kernels::kGroupWidth) {
      checkpoint.refuse("its columns of particles are not of one length");
    }
  });
  std::vector<char> seen(material_of_id.size());
  for (std::size_t i = 0; i < particles.lanes(); ++i) {
    const std::size_t material = particles.slot_material[i / kernels::kGroupWidth];
    if (material >= materials) {
      checkpoint.refuse(fmt::format("material {} of {}", material, materials));
    }
    if (particles.is_padding(i)) {
      continue;
    }
    const std::uint32_t id = particles.id[i];
    if (id >= seen.size() || seen[id] != 0 || material_of_id[id] != material) {
      checkpoint.refuse(fmt::format("particle {} is not there once, or of another material", id));
    }
    seen[id] = 1;
    ++particles.count;
  }
}

}  // namespace

template <int Dim>
void Solver<Dim>::save(CheckpointWriter& checkpoint) {
  const auto write = [&](const auto& name, const auto& value) { checkpoint(name, value); };
  write("steps", steps_done_);
  write("sortings into bins", rebins_);
  write("is prepared", static_cast<std::uint8_t>(is_prepared_));
  write("first failure", pack(first_failure_));
  archive_particles(particles_, write);
  ledger_.for_each_total(write);
  write("pending", ledger_.pending());
  if (is_prepared_) {
    grid_.for_each_prepared_field(layer_, write);
  }
}

template <int Dim>
Particles<Dim> Solver<Dim>::read_particles(const CheckpointReader& checkpoint) const {
  Particles<Dim> particles;
  particles.damage.resize(particles_.damage.empty() ? 0 : 1);  // whether there is such a column
  archive_particles(particles, checkpoint);
  const auto groups = static_cast<std::size_t>(grid_.rows() * grid_.groups_in_row());
  check_particles(particles, groups, materials_.size(), material_of_id_, checkpoint);
  return particles;
}

template <int Dim>
Ledger Solver<Dim>::read_ledger(const CheckpointReader& checkpoint) const {
  Ledger ledger = ledger_;
  ledger.for_each_total([&](const char* name, auto& total) { checkpoint(name, total); });
  std::vector<double> pending;
  checkpoint("pending", pending);
  if (!ledger.set_pending(pending)) {
    checkpoint.refuse("its sums are not those of this case");
  }
  return ledger;
}

template <int Dim>
Grid<Dim> Solver<Dim>::read_grid(const CheckpointReader& checkpoint) const {
  Grid<Dim> grid = grid_;
  grid.for_each_prepared_field(0, [&](const std::string& name, auto& field) {
    const std::size_t size = field.size();
    checkpoint(name, field);
    if (field.size() != size) {
      checkpoint.refuse("its grid is not that of this case");
    }
  });
  return grid;
}

// All is read before any of it is taken: a file that turns out wrong must not leave half of it
// here.

template <int Dim>
void Solver<Dim>::restore(const CheckpointReader& checkpoint) {
  std::int64_t steps = 0;
  std::int64_t rebins = 0;
  std::uint8_t is_prepared = 0;
  std::vector<double> failure;
  checkpoint("steps", steps);
  checkpoint("sortings into bins", rebins);
  checkpoint("is prepared", is_prepared);
  checkpoint("first failure", failure);
  if (steps != checkpoint.step() || rebins < 0) {
    checkpoint.refuse("its numbers of steps are none");
  }
  Particles<Dim> particles = read_particles(checkpoint);
  Ledger ledger = read_ledger(checkpoint);
  const auto there = static_cast<std::int64_t>(particles.count);
  if (there == 0 || ledger.removed().particles != std::ssize(material_of_id_) - there) {
    checkpoint.refuse(fmt::format("holds {} of {} particles", there, material_of_id_.size()));
  }
  const std::optional<FirstFailure> first_failure = unpack(failure, checkpoint);
  const auto most = static_cast<std::int64_t>(material_of_id_.size());
  const bool is_count = ledger.failed_tension() >= 0 && ledger.failed_tension() <= most &&
                        ledger.failed_shear() >= 0 && ledger.failed_shear() <= most;
  const bool has_failed = ledger.failed_tension() != 0 || ledger.failed_shear() != 0;
  // The next step would look for a first failure among particles of which none need have failed.
  if (!is_count || has_failed != first_failure.has_value()) {
    checkpoint.refuse("its numbers of failed particles do not fit its first failure");
  }
  if (is_prepared != 0) {
    grid_ = read_grid(checkpoint);
  }
  steps_done_ = steps;
  rebins_ = rebins;
  is_prepared_ = is_prepared != 0;
  first_failure_ = first_failure;
  particles_ = std::move(particles);
  ledger_ = std::move(ledger);
  layer_ = 0;
  place_layer(layer_, steps_done_);
  place_layer(1 - layer_, steps_done_);
  attach_particles();
}

template void Solver<2>::save(CheckpointWriter&);
template void Solver<2>::restore(const CheckpointReader&);
template void Solver<3>::save(CheckpointWriter&);
template void Solver<3>::restore(const CheckpointReader&);

}  // namespace rgimp
