#include "binning.hpp"
#include "solver.hpp"

/// What a solver does against physics gone wrong, after a step and when it sorts its particles.
namespace rgimp {

template <int Dim>
GuardedStep Solver<Dim>::guarded_step() const {
  return {steps_done_, dt_, critical_step_ratio(), ledger_.max_speed()};
}

// What is not finite reaches the works of its row within a step, but for stress out of the plane,
// which pulls at no node, and damage; nor does a volume that is turned inside out.
template <int Dim>
void Solver<Dim>::guard() {
  if (steps_done_ % kFullCheckEvery == 0 || !ledger_.is_finite()) {
    verify();
  } else {
    stop_if_too_fast(particles_, guarded_step());
  }
}

template <int Dim>
void Solver<Dim>::verify() {
  stop_if_broken(particles_, guarded_step(), workers_);
  stop_if_too_fast(particles_, guarded_step());
  if (!ledger_.is_finite()) {
    stop_at_lost_energies(particles_, guarded_step());
  }
}

template <int Dim>
double Solver<Dim>::critical_step_ratio() const {
  const double least_spacing = grid_.extent(layer_).spacing.template head<Dim>().minCoeff();
  return dt_ * (sound_speed_ + ledger_.max_speed()) / least_spacing;
}

template <int Dim>
void Solver<Dim>::rebin() {
  stop_if_broken(particles_, guarded_step(), workers_);
  const auto sort = [&] {
    return bin_particles(particles_, material_of_id_, grid_, workers_, layer_);
  };
  for (auto outside = sort(); !outside.empty(); outside = sort()) {
    take_out(outside);
  }
  attach_particles();
  is_prepared_ = false;
  ++rebins_;
}

template <int Dim>
void Solver<Dim>::take_out(const std::vector<std::size_t>& lanes) {
  if (on_exit_ == OnExit::stop || lanes.size() == particles_.count) {
    stop_outside(particles_, lanes, guarded_step());
  }
  for (const std::size_t lane : lanes) {
    const StoredEnergy energy = energy_of_lane(particles_, lane, materials_);
    ledger_.remove(particles_.mass[lane], energy.kinetic + energy.strain);
    particles_.remove(lane);
  }
}

template GuardedStep Solver<2>::guarded_step() const;
template void Solver<2>::guard();
template void Solver<2>::verify();
template double Solver<2>::critical_step_ratio() const;
template void Solver<2>::rebin();
template void Solver<2>::take_out(const std::vector<std::size_t>&);
template GuardedStep Solver<3>::guarded_step() const;
template void Solver<3>::guard();
template void Solver<3>::verify();
template double Solver<3>::critical_step_ratio() const;
template void Solver<3>::rebin();
template void Solver<3>::take_out(const std::vector<std::size_t>&);

}  // namespace rgimp
