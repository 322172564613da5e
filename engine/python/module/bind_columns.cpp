#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <memory>
#include <span>

#include "simulation_handle.hpp"

namespace rgimp::python {
namespace {

/// An array over the span itself. It holds the loan and the simulation, as its slices do.
template <typename Value>
py::array array_over(const LentColumns& lent, std::span<const Value> values) {
  using Loan = std::pair<std::shared_ptr<Lending>, py::object>;
  auto loan = std::make_unique<Loan>(lent.lending, lent.simulation);
  const py::capsule owner(loan.get(), [](void* held) { delete static_cast<Loan*>(held); });
  loan.release();  // NOLINT(bugprone-unused-return-value): the capsule has it
  py::array array(py::dtype::of<Value>(), {values.size()}, {sizeof(Value)}, values.data(), owner);
  array.attr("setflags")(py::arg("write") = false);
  return array;
}

/// Of a quantity with components; in the plane without those that are empty.
template <std::size_t Count>
py::tuple arrays_over(const LentColumns& lent,
                      const std::array<std::span<const double>, Count>& components) {
  py::list arrays;
  for (const std::span<const double> component : components) {
    if (!component.empty()) {
      arrays.append(array_over(lent, component));
    }
  }
  return py::tuple(arrays);
}

template <typename Member>
auto shown(Member ParticleColumns::*member) {
  return [member](const LentColumns& lent) { return array_over(lent, lent.columns.*member); };
}

template <typename Member>
auto components_shown(Member ParticleColumns::*member) {
  return [member](const LentColumns& lent) { return arrays_over(lent, lent.columns.*member); };
}

}  // namespace

void bind_columns(py::module_& module) {
  py::class_<LentColumns> columns(
      module, "ParticleColumns",
      "The particles where the steps keep them, read-only and without a copy: a lane each, in the\n"
      "order of the grid's bins. Lanes whose id is no_id hold no particle. While an array of them\n"
      "is in use, the simulation does not step (BufferError): delete or copy it first.");
  columns.attr("no_id") = ParticleColumns::no_id;
  columns.def_property_readonly("position", components_shown(&ParticleColumns::position), "m")
      .def_property_readonly("velocity", components_shown(&ParticleColumns::velocity), "m/s")
      .def_property_readonly("stress", components_shown(&ParticleColumns::stress),
                             "Pa, tension > 0; xx, yy, zz, xy, in space yz, xz besides")
      .def_property_readonly("volume", shown(&ParticleColumns::volume), "m3 (2D: m2)")
      .def_property_readonly("mass", shown(&ParticleColumns::mass), "kg (2D: per metre)")
      .def_property_readonly("failed", shown(&ParticleColumns::failed),
                             "1 in tension, 2 in shear; below 1 where not failed")
      .def_property_readonly("damage", shown(&ParticleColumns::damage),
                             "1, share of the strength lost; empty where nothing softens")
      .def_property_readonly("failure_step", shown(&ParticleColumns::failure_step),
                             "-1 while intact")
      .def_property_readonly("id", shown(&ParticleColumns::id), "of step 0; no_id in padding")
      .def("lanes", [](const LentColumns& lent) { return lent.columns.lanes(); })
      .def("__len__", [](const LentColumns& lent) { return lent.columns.lanes(); });
}

}  // namespace rgimp::python
