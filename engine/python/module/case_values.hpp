#pragma once

#include <pybind11/numpy.h>

#include <vector>

#include "bind.hpp"

namespace rgimp::python {

/// Throws Python's ValueError unless there are two components, of a vector in the plane, or three.
Vector vector_of(const std::vector<double>& components);

/// A copy that cannot be written to: `body.center[0] = 1` says so, where a copy would swallow it.
py::array_t<double> array_of(const Vector& vector);

/// A property that is read by array_of() and set by vector_of(). Its users include pybind11/stl.h.
template <typename T, typename... Options>
void add_vector(py::class_<T, Options...>& type, const char* name, Vector T::*member,
                const char* unit) {
  type.def_property(
      name, [member](const T& owner) { return array_of(owner.*member); },
      [member](T& owner, const std::vector<double>& value) { owner.*member = vector_of(value); },
      unit);
}

/// The values that a case is made of, and the names of their choices.
void bind_case_parts(py::module_& module);

}  // namespace rgimp::python
