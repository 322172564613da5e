#include <pybind11/eigen.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <array>
#include <vector>

#include "bind.hpp"
#include "rgimp/grid_fields.hpp"

namespace rgimp::python {
namespace {

/// An array (z, y, x) over a field, which it keeps alive.
py::array field_array(const py::object& fields, const std::vector<double>& values) {
  const auto& nodes = fields.cast<const GridFields&>().nodes;
  return py::array_t<double>({nodes[2], nodes[1], nodes[0]}, values.data(), fields);
}

template <std::size_t Count>
py::array field_array(const py::object& fields,
                      const std::vector<std::array<double, Count>>& values) {
  const auto& nodes = fields.cast<const GridFields&>().nodes;
  return py::array_t<double>({nodes[2], nodes[1], nodes[0], std::int64_t{Count}},
                             values.data()->data(), fields);
}

template <typename Values>
auto shown(Values GridFields::*member) {
  return [member](const py::object& self) {
    return field_array(self, self.cast<const GridFields&>().*member);
  };
}

}  // namespace

void bind_grid(py::module_& module) {
  py::class_<GridFields>(module, "GridFields",
                         "What the particles are on the nodes of the grid; zeros where none reach.")
      .def_readonly("step", &GridFields::step)
      .def_readonly("time", &GridFields::time, "s")
      .def_readonly("origin", &GridFields::origin, "m, of the first node")
      .def_readonly("spacing", &GridFields::spacing, "m, edges of a cell")
      .def_readonly("nodes", &GridFields::nodes, "along x, y, z")
      .def_readonly("particles_outside", &GridFields::particles_outside, "in no field")
      .def_property_readonly("mass", shown(&GridFields::mass), "(z, y, x), kg (2D: per metre)")
      .def_property_readonly("velocity", shown(&GridFields::velocity), "(z, y, x, 3), m/s")
      .def_property_readonly("stress", shown(&GridFields::stress),
                             "(z, y, x, 6), Pa; xx, yy, zz, xy, yz, xz; tension > 0")
      .def_property_readonly("damage", shown(&GridFields::damage), "(z, y, x), 0 to 1");
  module.def(
      "grid_fields",
      [](const PythonCase& settings, const ParticleTable& particles, std::int64_t step) {
        return grid_fields(to_case(settings), particles, step);
      },
      py::arg("case"), py::arg("particles"), py::arg("step"),
      "The fields of a case's particles (a ParticleTable) after `step` steps.");
  module.def("write_grid_fields", &write_grid_fields, py::arg("path"), py::arg("fields"),
             "Writes them as VTKHDF image data.");
  py::class_<WrittenGrids>(module, "WrittenGrids")
      .def_readonly("files", &WrittenGrids::files)
      .def_readonly("particles_outside", &WrittenGrids::particles_outside, "of the last file");
  module.def("write_grids", &write_grids, py::arg("directory"), py::arg("step") = py::none(),
             "What `rgimp grid DIRECTORY --step STEP` does.");
}

}  // namespace rgimp::python
