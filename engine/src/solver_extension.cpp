#include <utility>

#include "own_failure.hpp"
#include "own_initial_state.hpp"
#include "solver.hpp"

namespace rgimp {

template <int Dim>
void Solver<Dim>::set_initial_state(const InitialField& field) {
  ledger_.set_initial_speed(rgimp::set_initial_state(field, steps_done_, particles_));
  is_prepared_ = false;
}

template <int Dim>
void Solver<Dim>::set_acceleration(AccelerationField field) {
  loading_.set(std::move(field), static_cast<std::size_t>(grid_.rows() * grid_.row_stride()));
  is_prepared_ = false;  // what the nodes of the next step hold is without it
}

template <int Dim>
void Solver<Dim>::set_criterion(FailureCriterion criterion) {
  criterion_ = std::move(criterion);
}

template <int Dim>
std::vector<std::string> Solver<Dim>::own_functions() const {
  std::vector<std::string> names;
  if (loading_.is_set()) {
    names.emplace_back("set_acceleration");
  }
  if (criterion_) {
    names.emplace_back("set_criterion");
  }
  return names;
}

template <int Dim>
void Solver<Dim>::fail_by_own_criterion() {
  if (!criterion_) {
    return;
  }
  const OwnFailures failures =
      fail_by(criterion_, particles_, materials_, static_cast<std::int32_t>(steps_done_), workers_);
  ledger_.add_failures(failures);
  if (failures.tension + failures.shear > 0) {
    is_prepared_ = false;  // the last pass has scattered stresses that are gone
  }
}

template <int Dim>
void Solver<Dim>::note_first_failure() {
  std::optional<std::size_t> first;
  for (std::size_t i = 0; i < particles_.lanes(); ++i) {
    const bool failed = particles_.failure_mode[i] >= kernels::kFailedInTension;
    if (failed && (!first || particles_.id[i] < particles_.id[*first])) {
      first = i;
    }
  }
  FirstFailure failure;
  failure.step = steps_done_;
  failure.closure = ledger_.closure(time());
  failure.axial_stress = ledger_.axial_stress();
  for (int a = 0; a < Dim; ++a) {
    failure.position[a] = particles_.position[a][*first];
  }
  failure.mode = particles_.failure_mode[*first] == kernels::kFailedInTension ? FailureMode::tension
                                                                              : FailureMode::shear;
  first_failure_ = failure;
}

template void Solver<2>::set_initial_state(const InitialField&);
template void Solver<2>::set_acceleration(AccelerationField);
template void Solver<2>::set_criterion(FailureCriterion);
template std::vector<std::string> Solver<2>::own_functions() const;
template void Solver<2>::fail_by_own_criterion();
template void Solver<2>::note_first_failure();
template void Solver<3>::set_initial_state(const InitialField&);
template void Solver<3>::set_acceleration(AccelerationField);
template void Solver<3>::set_criterion(FailureCriterion);
template std::vector<std::string> Solver<3>::own_functions() const;
template void Solver<3>::fail_by_own_criterion();
template void Solver<3>::note_first_failure();

}  // namespace rgimp
