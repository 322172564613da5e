#include "rgimp/simulation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <utility>
#include <variant>

#include "case_of_state.hpp"
#include "case_size.hpp"
#include "checkpoint_file.hpp"
#include "input_file.hpp"
#include "particle_table.hpp"
#include "rgimp/case_file.hpp"
#include "rgimp/error.hpp"
#include "snapshot.hpp"
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
  return settings;
}

/// Which of the two is decided once; steps are compiled for each.
using AnySolver = std::variant<Solver<2>, Solver<3>>;

AnySolver make_solver(const Case& settings, kernels::Isa isa, Workers& workers) {
  if (settings.dimension == 3) {
    return AnySolver(std::in_place_type<Solver<3>>, settings, isa, workers);
  }
  return AnySolver(std::in_place_type<Solver<2>>, settings, isa, workers);
}

}  // namespace

class Simulation::Implementation {
 public:
  explicit Implementation(Case settings)
      : settings_(checked(std::move(settings))),
        isa_(choose_isa()),
        workers_(settings_.tuning.threads),
        solver_(make_solver(settings_, isa_, workers_)) {}

  /// visit(the solver), of either dimension.
  template <typename Visit>
  decltype(auto) with_solver(Visit visit) {
    return std::visit(visit, solver_);
  }

  void advance(std::int64_t step) {
    if (is_half_done_) {
      throw Error("a step was left half done by an exception of one of the program's functions");
    }
    is_half_done_ = true;
    try {
      with_solver([&](auto& solver) {
        workers_.region([&] {
          while (solver.steps_done() < step) {
            solver.step();
          }
        });
      });
    } catch (const PhysicsError&) {  // comes between two steps
      is_half_done_ = false;
      throw;
    }
    is_half_done_ = false;
  }

  void add_observer(std::int64_t steps, Observer observer) {
    observers_.push_back({steps, std::move(observer)});
  }

  /// The first step from here on, `last` at most, that an observer wants to see.
  std::int64_t next_observed(std::int64_t done, std::int64_t last) const {
    std::int64_t next = last;
    for (const Observation& observation : observers_) {
      next = std::min(next, done + observation.every - done % observation.every);
    }
    return next;
  }

  void notify(const Simulation& simulation, std::int64_t done) const {
    for (const Observation& observation : observers_) {
      if (done % observation.every == 0) {
        observation.observer(simulation);
      }
    }
  }

  HistoryRow history() {
    HistoryRow row;
    workers_.region([&] { row = with_solver([](auto& solver) { return solver.history(); }); });
    return row;
  }

  void verify() {
    workers_.region([&] { with_solver([](auto& solver) { solver.verify(); }); });
  }

  void save(const std::filesystem::path& path, std::string_view note) {
    if (is_half_done_) {
      throw Error("no checkpoint of a step that an exception left half done");
    }
    verify();  // a checkpoint is the last good state
    with_solver([&](auto& solver) {
      CheckpointWriter checkpoint(path, solver.steps_done());
      solver.save(checkpoint);
      checkpoint.finish({case_of_state(settings_), std::string(note), solver.own_functions()});
    });
  }

  std::string restore(const std::filesystem::path& path) {
    // A file far larger than any state of this case must not be read to find out: its index may be
    // as large.
    constexpr std::uintmax_t kLabel = 16U << 20;
    std::error_code ignored;  // reading says more
    const std::uintmax_t size = std::filesystem::file_size(path, ignored);
    const std::size_t state = with_solver([](auto& solver) { return solver.memory_bytes(); });
    if (!ignored && size > 2 * state + kLabel) {
      throw FileError(
          fmt::format("checkpoint '{}': {} bytes are too many for this case", path.string(), size));
    }
    const CheckpointReader checkpoint(path.string(),
                                      std::make_unique<std::ifstream>(open_file(path)));
    require_same_case(settings_, checkpoint.label().case_text, path.string());
    with_solver([&](auto& solver) {
      require_own_functions(solver.own_functions(), checkpoint.label().own_functions,
                            path.string());
      solver.restore(checkpoint);
    });
    is_half_done_ = false;
    return checkpoint.label().note;
  }

  const Case& settings() const { return settings_; }

  Facts facts() {
    Facts facts;
    with_solver([&](auto& solver) {
      facts.particles = solver.particles().count;
      facts.nodes = solver.grid().extent().nodes;
      facts.dt = solver.dt();
      facts.memory_bytes = solver.memory_bytes();
      facts.peak_memory_bytes = static_cast<std::size_t>(peak_bytes(
          static_cast<double>(facts.memory_bytes), static_cast<double>(facts.particles)));
    });
    facts.total_steps = static_cast<std::int64_t>(total_steps(settings_));
    facts.isa = kernels::name(isa_);
    facts.threads = workers_.threads();
    return facts;
  }

 private:
  struct Observation {
    std::int64_t every;  // steps
    Observer observer;
  };

  Case settings_;
  kernels::Isa isa_;
  Workers workers_;
  AnySolver solver_;
  std::vector<Observation> observers_;
  bool is_half_done_ = false;  // a step, which something else than a guard ended
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
  // Observers are called between regions of the workers, as they may ask for a history row, which
  // opens one.
  for (std::int64_t done = steps_done(); done < step; done = steps_done()) {
    implementation_->advance(implementation_->next_observed(done, step));
    implementation_->notify(*this, steps_done());
  }
}
void Simulation::every(std::int64_t steps, Observer observer) {
  if (steps < 1 || !observer) {
    throw CaseError(
        fmt::format("every: {}, expected a number of steps from 1 up and a function", steps));
  }
  implementation_->add_observer(steps, std::move(observer));
}
void Simulation::set_initial_state(const InitialField& field) {
  implementation_->with_solver([&](auto& solver) { solver.set_initial_state(field); });
}
void Simulation::set_acceleration(AccelerationField field) {
  implementation_->with_solver([&](auto& solver) { solver.set_acceleration(std::move(field)); });
}
void Simulation::set_criterion(FailureCriterion criterion) {
  implementation_->with_solver([&](auto& solver) { solver.set_criterion(std::move(criterion)); });
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
  return implementation_->with_solver([](auto& solver) { return solver.steps_done(); });
}
double Simulation::time() const {
  return implementation_->with_solver([](auto& solver) { return solver.time(); });
}
double Simulation::critical_step_ratio() const {
  return implementation_->with_solver([](auto& solver) { return solver.critical_step_ratio(); });
}
HistoryRow Simulation::history() const {
  return implementation_->history();
}
std::optional<FirstFailure> Simulation::first_failure() const {
  return implementation_->with_solver([](auto& solver) { return solver.first_failure(); });
}
RemovedParticles Simulation::removed() const {
  return implementation_->with_solver([](auto& solver) { return solver.removed(); });
}
double Simulation::peak_axial_stress() const {
  return implementation_->with_solver([](auto& solver) { return solver.peak_axial_stress(); });
}
Facts Simulation::facts() const {
  return implementation_->facts();
}

std::vector<StageTime> Simulation::stage_times() const {
  const auto seconds =
      implementation_->with_solver([](auto& solver) { return solver.stage_seconds(); });
  std::vector<StageTime> times;
  for (std::size_t stage = 0; stage < kStageNames.size(); ++stage) {
    times.push_back({kStageNames[stage], seconds[stage]});
  }
  return times;
}

const Case& Simulation::settings() const {
  return implementation_->settings();
}

ParticleTable Simulation::particles() const {
  return implementation_->with_solver([](auto& solver) { return table_of(solver.particles()); });
}

ParticleColumns Simulation::columns() const {
  return implementation_->with_solver([](auto& solver) { return columns_of(solver.particles()); });
}

void Simulation::write_snapshot(const std::filesystem::path& path) const {
  rgimp::write_snapshot(path, particles(), {steps_done(), time()});
}

std::uint64_t Simulation::state_hash() const {
  return implementation_->with_solver(
      [](auto& solver) { return rgimp::state_hash(solver.particles()); });
}

}  // namespace rgimp
