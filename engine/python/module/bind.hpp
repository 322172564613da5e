#pragma once

#include <pybind11/pybind11.h>

#include <string>

#include "rgimp/case.hpp"

/// The parts of the Python module, each a file of its own. Names are those of C++.
namespace rgimp::python {

namespace py = pybind11;

void bind_case(py::module_& module);
void bind_grid(py::module_& module);
void bind_results(py::module_& module);
void bind_run(py::module_& module);
void bind_simulation(py::module_& module);

/// A constructor that takes the properties by name: `Body(shape=BodyShape.disk, center=[0, 0])`. An
/// unknown name is Python's AttributeError.
template <typename T, typename... Options>
void add_constructor(py::class_<T, Options...>& type) {
  type.def(py::init([](const py::kwargs& properties) {
    py::object made = py::cast(T());
    for (const auto& [name, value] : properties) {
      py::setattr(made, name, value);
    }
    return made.template cast<T>();
  }));
}

/// A case in Python. C++ keeps bodies in a vector, whose elements move when it grows; a Python
/// object that refers to one would then refer to nothing. So lists of objects are Python's own, and
/// become vectors when the case is used.
struct PythonCase {
  Case rest;           ///< all but the following
  py::list bodies;     ///< of Body
  py::list flaws;      ///< of Flaw
  py::list platens;    ///< of Platen
  py::dict materials;  ///< str to Material
};

/// Throws Python's TypeError for what is no Body in `bodies`, and so on.
Case to_case(const PythonCase& settings);
PythonCase to_python(const Case& settings);

}  // namespace rgimp::python
