#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <chrono>
#include <limits>

#include "rgimp/simulation.hpp"
#include "simulation_handle.hpp"

namespace rgimp::python {
namespace {

/// Throws KeyboardInterrupt where Ctrl-C was pressed. Called without the interpreter's lock.
void check_for_interrupt() {
  const py::gil_scoped_acquire acquire;
  if (PyErr_CheckSignals() != 0) {
    throw py::error_already_set();
  }
}

/// Steps until `step` steps are done or Ctrl-C is pressed, which is looked for ten times a second.
void run_until(SimulationHandle& handle, std::int64_t step) {
  handle.change([step](Simulation& simulation) {
    using Clock = std::chrono::steady_clock;
    auto looked = Clock::now();
    while (simulation.steps_done() < step) {
      simulation.step();
      if (Clock::now() - looked > std::chrono::milliseconds(100)) {
        check_for_interrupt();
        looked = Clock::now();
      }
    }
  });
}

/// `observer` is a Python function of the simulation; what it raises comes out of the steps.
void add_observer(const py::object& self, std::int64_t steps, const py::function& observer) {
  // The simulation must not keep itself alive through its observers.
  const py::handle simulation = self;
  auto& handle = self.cast<SimulationHandle&>();
  handle.every(steps, [simulation, observer, &handle](const Simulation&) {
    const py::gil_scoped_acquire acquire;
    observer(simulation);
    handle.require_nothing_lent();
  });
}

/// The value of a function of the simulation that only reads.
template <typename Value>
auto reading(Value (Simulation::*function)() const) {
  return [function](const SimulationHandle& handle) { return (handle.read().*function)(); };
}

void bind_steps(py::class_<SimulationHandle>& type) {
  type.def(py::init([](const PythonCase& settings) {
             Case made = to_case(settings);
             const py::gil_scoped_release release;
             return std::make_unique<SimulationHandle>(std::move(made));
           }),
           py::arg("case"), "Raises CaseError for what check_case refuses.")
      .def(
          "step",
          [](SimulationHandle& handle) {
            handle.change([](Simulation& simulation) { simulation.step(); });
          },
          "One step. Raises PhysicsError.")
      .def("run_until", &run_until, py::arg("step"),
           "Steps until `step` steps are done. Raises PhysicsError, and KeyboardInterrupt between\n"
           "two steps.")
      .def("every", &add_observer, py::arg("steps"), py::arg("observer"),
           "From now on calls observer(simulation) after every step whose number is a multiple of\n"
           "`steps`. It reads; what it raises comes out of step() or run_until().");
}

void bind_files(py::class_<SimulationHandle>& type) {
  type.def(
          "save",
          [](const SimulationHandle& handle, const std::filesystem::path& path,
             const std::string& note) { handle.read().save(path, note); },
          py::arg("path"), py::arg("note") = "", "Writes a checkpoint. Raises FileError.")
      .def(
          "restore",
          [](SimulationHandle& handle, const std::filesystem::path& path) {
            return handle.change([&](Simulation& simulation) { return simulation.restore(path); });
          },
          py::arg("path"), "Takes the state of a checkpoint and returns its note.")
      .def(
          "write_snapshot",
          [](const SimulationHandle& handle, const std::filesystem::path& path) {
            handle.read().write_snapshot(path);
          },
          py::arg("path"), "Writes the particles for ParaView and h5py. Raises FileError.");
}

void bind_readings(py::class_<SimulationHandle>& type) {
  type.def("verify", reading(&Simulation::verify), "Raises PhysicsError for a state gone wrong.")
      .def("steps_done", reading(&Simulation::steps_done))
      .def("time", reading(&Simulation::time), "s")
      .def("critical_step_ratio", reading(&Simulation::critical_step_ratio), "dt/dt_cr")
      .def("history", reading(&Simulation::history), "A row of history.csv, now.")
      .def("particles", reading(&Simulation::particles), "A copy, in order of id.")
      .def(
          "columns",
          [](const py::object& self) {
            auto& handle = self.cast<SimulationHandle&>();
            return LentColumns{self, handle.lend(), handle.read().columns()};
          },
          "The particles without a copy, see ParticleColumns.")
      .def("first_failure", reading(&Simulation::first_failure), "or None")
      .def("removed", reading(&Simulation::removed))
      .def("peak_axial_stress", reading(&Simulation::peak_axial_stress), "Pa, over all steps")
      .def("state_hash", reading(&Simulation::state_hash), "Equal for equal bits.")
      .def("facts", reading(&Simulation::facts))
      .def(
          "stage_times",
          [](const SimulationHandle& handle) {
            py::dict seconds;
            for (const StageTime& stage : handle.read().stage_times()) {
              seconds[py::str(std::string(stage.name))] = stage.seconds;
            }
            return seconds;
          },
          "Seconds spent in every stage of the steps.")
      .def(
          "settings",
          [](const SimulationHandle& handle) { return to_python(handle.read().settings()); },
          "A copy of the case.");
}

}  // namespace

void bind_simulation(py::module_& module) {
  bind_columns(module);
  py::class_<SimulationHandle> type(module, "Simulation",
                                    "A running simulation. Steps let other Python threads go on.");
  bind_steps(type);
  bind_files(type);
  bind_readings(type);
  bind_extension(module, type);
}

}  // namespace rgimp::python
