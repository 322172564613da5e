#pragma once

#include <pybind11/numpy.h>

#include <vector>

#include "bind.hpp"

namespace rgimp::python {

/// Throws Python's ValueError unless there are two components, of a vector in the plane, or three.
Vector vector_of(const std::vector<double>& components);

/// A copy that cannot be written to: `body.center[0] = 1` says so, where a copy would swallow it.
py::array_t<double> array_of(const Vector& vector);

/// The values that a case is made of, and the names of their choices.
void bind_case_parts(py::module_& module);

}  // namespace rgimp::python
