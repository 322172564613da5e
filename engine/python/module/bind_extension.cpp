#include <pybind11/eigen.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "case_values.hpp"
#include "rgimp/extension.hpp"
#include "simulation_handle.hpp"

namespace rgimp::python {
namespace {

/// A Python function that a simulation keeps and calls on any thread, one call at a time.
class OwnFunction {
 public:
  OwnFunction(py::function function, SimulationHandle& handle)
      : function_(new py::function(std::move(function)), &destroy), handle_(handle) {}

  /// convert(what the function returns for these arguments), which are made with the lock, too.
  template <typename Convert, typename... MakeArgument>
  auto operator()(Convert convert, MakeArgument... make_argument) const {
    const py::gil_scoped_acquire acquire;
    const SimulationHandle::NoReading no_reading(handle_);
    return convert((*function_)(make_argument()...));
  }

 private:
  static void destroy(py::function* function) {
    const py::gil_scoped_acquire acquire;
    delete function;
  }

  std::shared_ptr<py::function> function_;  // copies of it need no lock
  SimulationHandle& handle_;                // keeps the simulation, and so outlives this
};

/// Throws Python's TypeError for another type, which `expected` names.
template <typename Value>
Value value_of(const py::object& returned, const char* expected) {
  try {
    return returned.cast<Value>();
  } catch (const py::builtin_exception&) {  // not only cast_error: None is none of a reference
    throw py::type_error("expected " + std::string(expected) + ", not " +
                         std::string(py::repr(returned)));
  }
}

void set_initial_state(SimulationHandle& handle, const py::function& field) {
  const OwnFunction own(field, handle);
  handle.change([&](Simulation& simulation) {
    simulation.set_initial_state([&](const Vector& position) {
      return own(
          [](const py::object& state) { return value_of<InitialState>(state, "an InitialState"); },
          [&] { return array_of(position); });
    });
  });
}

void set_acceleration(SimulationHandle& handle, const std::optional<py::function>& field) {
  AccelerationField made;
  if (field) {
    made = [own = OwnFunction(*field, handle)](const Vector& position, double time) {
      return own(
          [](const py::object& acceleration) {
            return vector_of(value_of<std::vector<double>>(acceleration, "two or three numbers"));
          },
          [&] { return array_of(position); }, [&] { return time; });
    };
  }
  handle.change([&](Simulation& simulation) { simulation.set_acceleration(std::move(made)); });
}

void set_criterion(SimulationHandle& handle, const std::optional<py::function>& criterion) {
  FailureCriterion made;
  if (criterion) {
    made = [own = OwnFunction(*criterion, handle)](const IntactParticle& particle) {
      return own(
          [](const py::object& mode) { return value_of<FailureMode>(mode, "a FailureMode"); },
          [&] { return particle; });
    };
  }
  handle.change([&](Simulation& simulation) { simulation.set_criterion(std::move(made)); });
}

void bind_arguments(py::module_& module) {
  py::class_<InitialState> state(module, "InitialState",
                                 "Motion and stress of a particle before the first step.");
  add_constructor(state);
  add_vector(state, "velocity", &InitialState::velocity, "m/s; in 2D z is 0");
  state.def_property(
      "stress", [](const InitialState& owner) { return Eigen::Matrix3d(owner.stress); },
      [](InitialState& owner, const Eigen::Matrix3d& value) { owner.stress = value; },
      "Pa, (3, 3), symmetric, tension > 0; in 2D xz, yz are 0");
  py::class_<IntactParticle>(module, "IntactParticle",
                             "A particle that has not failed, as a criterion sees it.")
      .def_readonly("id", &IntactParticle::id, "of step 0")
      .def_property_readonly(
          "position", [](const IntactParticle& owner) { return array_of(owner.position); }, "m")
      .def_property_readonly(
          "stress", [](const IntactParticle& owner) { return Eigen::Matrix3d(owner.stress); },
          "Pa, (3, 3), tension > 0");
}

}  // namespace

void bind_extension(py::module_& module, py::class_<SimulationHandle>& type) {
  bind_arguments(module);
  type.def("set_initial_state", &set_initial_state, py::arg("field"),
           "Sets velocity and stress of every particle to those of the InitialState that\n"
           "field(position) returns. Before the first step only.")
      .def("set_acceleration", &set_acceleration, py::arg("field"),
           "From now on accelerates the nodes by field(position, time), m/s2, beside the case's\n"
           "body_acceleration; None ends it. What it raises leaves a step half done.")
      .def(
          "set_criterion", &set_criterion, py::arg("criterion"),
          "From now on intact particles fail by criterion(IntactParticle), a FailureMode, beside\n"
          "the criterion of their material; None ends it. What it raises leaves a step half done.");
}

}  // namespace rgimp::python
