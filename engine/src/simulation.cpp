#include "rgimp/simulation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "case_of_state.hpp"
#include "checkpoint_file.hpp"
#include "input_file.hpp"
#include "rgimp/case_file.hpp"
#include "rgimp/error.hpp"
#include "solver.hpp"
#include "state_hash.hpp"
#include "time_step.hpp"

namespace rgimp {
namespace {

/// The machine's best, or what RGIMP_ISA names.
kernels::Isa choose_isa() {
  const char* wanted = std::getenv("RGIMP_ISA");
  if (wanted == nullptr || *wanted == '\0') {
    return kernels::best_isa();
  }
  std::string known;
  for (const kernels::Isa isa : kernels::kAllIsas) {
    if (kernels::name(isa) == std::string_view(wanted)) {
      if (!kernels::available(isa)) {
        throw CaseError(fmt::format("RGIMP_ISA: this machine lacks {}", wanted));
      }
      return isa;
    }
    known += fmt::format("{}{}", known.empty() ? "" : ", ", kernels::name(isa));
  }
  throw CaseError(fmt::format("RGIMP_ISA: unknown ISA \"{}\", expected one of {}", wanted, known));
}

Case checked(Case settings) {
  check_case(settings);
  if (settings.dimension == 3) {
    throw CaseError("dimension: is 3; three dimensions cannot be run yet");
  }
  return settings;
}

double max_principal(const std::array<double, 6>& s) {
  const double centre = 0.5 * (s[0] + s[1]);
  const double radius = std::hypot(0.5 * (s[0] - s[1]), s[3]);
  return std::max(centre + radius, s[2]);
}

FailureMode failure_mode(double mode) {
  if (mode == kernels::kFailedInTension) {
    return FailureMode::tension;
  }
  return mode == kernels::kFailedInShear ? FailureMode::shear : FailureMode::intact;
}

}  // namespace

class Simulation::Implementation {
 public:
  explicit Implementation(Case settings)
      : settings_(checked(std::move(settings))),
        isa_(choose_isa()),
        workers_(settings_.tuning.threads),
        solver_(settings_, isa_, workers_) {}

  void run_until(std::int64_t step) {
    workers_.region([&] {
      while (solver_.steps_done() < step) {
        solver_.step();
      }
    });
  }

  HistoryRow history() {
    HistoryRow row;
    workers_.region([&] { row = solver_.history(); });
    return row;
  }

  void verify() {
    workers_.region([&] { solver_.verify(); });
  }

  void save(const std::filesystem::path& path, std::string_view note) {
    verify();  // a checkpoint is the last good state
    CheckpointWriter checkpoint(path, solver_.steps_done());
    solver_.save(checkpoint);
    checkpoint.finish({case_of_state(settings_), std::string(note)});
  }

  std::string restore(const std::filesystem::path& path) {
    // A file far larger than any state of this case must not be read to find out.
    constexpr std::uintmax_t kLabel = 16U << 20;
    std::error_code ignored;  // reading says more
    const std::uintmax_t size = std::filesystem::file_size(path, ignored);
    if (!ignored && size > 2 * solver_.memory_bytes() + kLabel) {
      throw FileError(
          fmt::format("checkpoint '{}': {} bytes are too many for this case", path.string(), size));
    }
    const CheckpointReader checkpoint(path.string(), read_bytes(path));
    require_same_case(settings_, checkpoint.label().case_text, path.string());
    solver_.restore(checkpoint);
    return checkpoint.label().note;
  }

  Solver<2>& solver() { return solver_; }
  const Case& settings() const { return settings_; }

  Facts facts() {
    Facts facts;
    facts.particles = solver_.particles().count;
    facts.nodes = solver_.grid().extent().nodes;
    facts.dt = solver_.dt();
    facts.total_steps = static_cast<std::int64_t>(total_steps(settings_));
    facts.memory_bytes = solver_.memory_bytes();
    facts.isa = kernels::name(isa_);
    facts.threads = workers_.threads();
    return facts;
  }

 private:
  Case settings_;
  kernels::Isa isa_;
  Workers workers_;
  Solver<2> solver_;
};

Simulation::Simulation(Case settings)
    : implementation_(std::make_unique<Implementation>(std::move(settings))) {}
Simulation::~Simulation() = default;
Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;

void Simulation::step() {
  run_until(steps_done() + 1);
}
void Simulation::run_until(std::int64_t step) {
  implementation_->run_until(step);
}
void Simulation::save(const std::filesystem::path& path, std::string_view note) const {
  implementation_->save(path, note);
}
std::string Simulation::restore(const std::filesystem::path& path) {
  return implementation_->restore(path);
}
void Simulation::verify() const {
  implementation_->verify();
}
std::int64_t Simulation::steps_done() const {
  return implementation_->solver().steps_done();
}
double Simulation::time() const {
  return implementation_->solver().time();
}
double Simulation::critical_step_ratio() const {
  return implementation_->solver().critical_step_ratio();
}
HistoryRow Simulation::history() const {
  return implementation_->history();
}
std::optional<FirstFailure> Simulation::first_failure() const {
  return implementation_->solver().first_failure();
}
RemovedParticles Simulation::removed() const {
  return implementation_->solver().removed();
}
double Simulation::peak_axial_stress() const {
  return implementation_->solver().peak_axial_stress();
}
Facts Simulation::facts() const {
  return implementation_->facts();
}

std::vector<StageTime> Simulation::stage_times() const {
  std::vector<StageTime> times;
  for (std::size_t stage = 0; stage < kStageNames.size(); ++stage) {
    times.push_back({kStageNames[stage], implementation_->solver().stage_seconds()[stage]});
  }
  return times;
}

const Case& Simulation::settings() const {
  return implementation_->settings();
}

ParticleTable Simulation::particles() const {
  const Particles<2>& p = implementation_->solver().particles();
  ParticleTable table;
  for (const std::size_t i : lanes_by_id(p)) {
    const std::array<double, 6> stress = {
        p.stress[0][i], p.stress[1][i], p.stress[2][i], p.stress[3][i], 0.0, 0.0};
    table.id.push_back(p.id[i]);
    table.position.push_back({p.position[0][i], p.position[1][i], 0.0});
    table.velocity.push_back({p.velocity[0][i], p.velocity[1][i], 0.0});
    table.stress.push_back(stress);
    table.max_principal_stress.push_back(max_principal(stress));
    table.failed.push_back(failure_mode(p.failure_mode[i]));
    table.damage.push_back(p.failure_mode[i] >= kernels::kFailedInTension ? 1.0
                           : p.damage.empty()                             ? 0.0
                                                                          : p.damage[i]);
    table.failure_step.push_back(p.failure_step[i]);
  }
  return table;
}

std::uint64_t Simulation::state_hash() const {
  return rgimp::state_hash(implementation_->solver().particles());
}

}  // namespace rgimp
