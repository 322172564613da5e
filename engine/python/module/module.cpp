#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <utility>

#include "bind.hpp"
#include "rgimp/error.hpp"
#include "rgimp/machine.hpp"
#include "rgimp/version.hpp"

namespace rgimp::python {
namespace {

void bind_report(py::module_& module) {
  py::class_<PhysicsReport>(module, "PhysicsReport", "Where the physics stopped.")
      .def_readonly("step", &PhysicsReport::step)
      .def_readonly("particle", &PhysicsReport::particle, "id, or None")
      .def_readonly("position", &PhysicsReport::position, "m")
      .def_readonly("velocity", &PhysicsReport::velocity, "m/s")
      .def_readonly("critical_step_ratio", &PhysicsReport::critical_step_ratio, "dt/dt_cr");
}

/// Of PhysicsError; the others carry a message only, for which pybind11 has a function.
py::object& physics_error() {
  static py::object* type = nullptr;  // never destroyed: the interpreter may be gone by then
  if (type == nullptr) {
    type = new py::object();
  }
  return *type;
}

void translate_physics_error(std::exception_ptr error) {
  try {
    std::rethrow_exception(std::move(error));
  } catch (const PhysicsError& stopped) {
    py::object made = physics_error()(stopped.what());
    made.attr("report") = stopped.report();
    PyErr_SetObject(physics_error().ptr(), made.ptr());
  }
}

void bind_errors(py::module_& module) {
  // Translators are asked the last registered first: derived types after Error.
  const auto& error = py::register_exception<Error>(module, "Error", PyExc_RuntimeError);
  py::register_exception<CaseError>(module, "CaseError", error);
  py::register_exception<FileError>(module, "FileError", error);
  physics_error() = py::exception<PhysicsError>(module, "PhysicsError", error);
  py::register_exception_translator(translate_physics_error);
}

void bind_machine(py::module_& module) {
  py::class_<Machine>(module, "Machine", "What simulations use on this machine.")
      .def_readonly("isa", &Machine::isa)
      .def_readonly("isas", &Machine::isas)
      .def_readonly("threads", &Machine::threads);
  module.def("describe_machine", &describe_machine);
}

}  // namespace
}  // namespace rgimp::python

PYBIND11_MODULE(_rgimp, module) {
  using namespace rgimp::python;
  module.attr("__version__") = std::string(rgimp::version());
  bind_report(module);
  bind_errors(module);
  bind_machine(module);
  bind_case(module);
  bind_results(module);
  bind_grid(module);
  bind_simulation(module);
  bind_run(module);
}
