#pragma once

#include <pybind11/pybind11.h>

#include <memory>
#include <thread>
#include <utility>

#include "bind.hpp"
#include "rgimp/simulation.hpp"

namespace rgimp::python {

/// Held by the arrays that show a simulation's columns, directly or through slices of them.
struct Lending {};

/// A simulation in Python: one thread at a time, and no stepping under arrays that show its
/// particles where they are. All members are called with the interpreter's lock.
class SimulationHandle {
 public:
  explicit SimulationHandle(Case settings) : simulation_(std::move(settings)) {}

  /// While it lives, the simulation cannot be looked at: a step is half done.
  class NoReading {
   public:
    explicit NoReading(SimulationHandle& handle) : handle_(handle) { ++handle_.no_reading_; }
    ~NoReading() { --handle_.no_reading_; }
    NoReading(const NoReading&) = delete;
    NoReading& operator=(const NoReading&) = delete;

   private:
    SimulationHandle& handle_;
  };

  /// To read. While steps are taken, only their own thread may: an observer.
  const Simulation& read() const {
    if (no_reading_ > 0) {
      throw std::runtime_error("the simulation is within a step: own functions cannot look at it");
    }
    if (changing_ && thread_ != std::this_thread::get_id()) {
      throw std::runtime_error("the simulation is stepping on another thread");
    }
    return simulation_;
  }

  /// Calls change(the simulation) without the interpreter's lock. Throws Python's RuntimeError
  /// where it is changing already, BufferError while arrays of columns() are alive: they would
  /// show memory that is gone.
  template <typename Change>
  auto change(Change change) {
    require_at_rest();
    require_nothing_lent();
    const Guard guard(*this);
    const py::gil_scoped_release release;
    return change(simulation_);
  }

  /// Simulation::every.
  void every(std::int64_t steps, Simulation::Observer observer) {
    require_at_rest();
    simulation_.every(steps, std::move(observer));
  }

  /// Throws Python's BufferError while arrays of columns() are alive.
  void require_nothing_lent() const {
    if (!lending_.expired()) {
      throw py::buffer_error("arrays of columns() are still in use; delete or copy them first");
    }
  }

  /// One for all that is lent at a time.
  std::shared_ptr<Lending> lend() {
    std::shared_ptr<Lending> lending = lending_.lock();
    if (!lending) {
      lending = std::make_shared<Lending>();
      lending_ = lending;
    }
    return lending;
  }

 private:
  void require_at_rest() const {
    if (changing_) {
      throw std::runtime_error("the simulation is stepping: observers may only read it");
    }
  }

  /// Marks the simulation as changing; outlives the release of the lock.
  class Guard {
   public:
    explicit Guard(SimulationHandle& handle) : handle_(handle) {
      handle_.thread_ = std::this_thread::get_id();
      handle_.changing_ = true;
    }
    ~Guard() { handle_.changing_ = false; }
    Guard(const Guard&) = delete;
    Guard& operator=(const Guard&) = delete;

   private:
    SimulationHandle& handle_;
  };

  Simulation simulation_;
  std::weak_ptr<Lending> lending_;
  bool changing_ = false;
  int no_reading_ = 0;
  std::thread::id thread_;
};

/// The columns and the loan that keeps their simulation from stepping.
struct LentColumns {
  py::object simulation;  ///< kept alive
  std::shared_ptr<Lending> lending;
  ParticleColumns columns;
};

void bind_columns(py::module_& module);
void bind_extension(py::module_& module, py::class_<SimulationHandle>& type);

}  // namespace rgimp::python
