#include <pybind11/eigen.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <array>
#include <vector>

#include "bind.hpp"
#include "rgimp/simulation.hpp"

namespace rgimp::python {
namespace {

/// An array over a vector of the table, which it keeps alive.
template <typename Value>
py::array array_over(const py::object& table, const std::vector<Value>& values) {
  return py::array(py::dtype::of<Value>(), {values.size()}, {sizeof(Value)}, values.data(), table);
}

template <std::size_t Count>
py::array array_over(const py::object& table,
                     const std::vector<std::array<double, Count>>& values) {
  return py::array(py::dtype::of<double>(), {values.size(), Count},
                   {Count * sizeof(double), sizeof(double)},
                   static_cast<const void*>(values.data()), table);
}

py::array array_over(const py::object& table, const std::vector<FailureMode>& values) {
  static_assert(sizeof(FailureMode) == sizeof(std::uint8_t));
  return py::array(py::dtype::of<std::uint8_t>(), {values.size()}, {sizeof(std::uint8_t)},
                   static_cast<const void*>(values.data()), table);
}

template <typename Values>
auto shown(Values ParticleTable::*member) {
  return [member](const py::object& self) {
    return array_over(self, self.cast<const ParticleTable&>().*member);
  };
}

void bind_table(py::module_& module) {
  py::class_<ParticleTable>(module, "ParticleTable",
                            "A copy of the particles, in order of id; arrays of equal length.")
      .def_property_readonly("id", shown(&ParticleTable::id))
      .def_property_readonly("position", shown(&ParticleTable::position), "(n, 3), m")
      .def_property_readonly("velocity", shown(&ParticleTable::velocity), "(n, 3), m/s")
      .def_property_readonly("stress", shown(&ParticleTable::stress),
                             "(n, 6), Pa; xx, yy, zz, xy, yz, xz; tension > 0")
      .def_property_readonly("max_principal_stress", shown(&ParticleTable::max_principal_stress),
                             "Pa")
      .def_property_readonly("failed", shown(&ParticleTable::failed), "values of FailureMode")
      .def_property_readonly("damage", shown(&ParticleTable::damage),
                             "1, share of the strength lost; 1 where failed")
      .def_property_readonly("failure_step", shown(&ParticleTable::failure_step), "-1 while intact")
      .def("__len__", &ParticleTable::size);
}

void bind_history(py::module_& module) {
  py::class_<HistoryRow>(module, "HistoryRow", "One row of history.csv; in 2D per metre.")
      .def_readonly("step", &HistoryRow::step)
      .def_readonly("time", &HistoryRow::time, "s")
      .def_readonly("closure", &HistoryRow::closure, "m")
      .def_readonly("axial_stress", &HistoryRow::axial_stress, "Pa, compression > 0")
      .def_readonly("reaction", &HistoryRow::reaction, "N, compression > 0")
      .def_readonly("kinetic_energy", &HistoryRow::kinetic_energy, "J")
      .def_readonly("strain_energy", &HistoryRow::strain_energy, "J")
      .def_readonly("external_work", &HistoryRow::external_work, "J")
      .def_readonly("damping_work", &HistoryRow::damping_work, "J")
      .def_readonly("viscous_work", &HistoryRow::viscous_work, "J")
      .def_readonly("released_energy", &HistoryRow::released_energy, "J")
      .def_readonly("failed_tension", &HistoryRow::failed_tension)
      .def_readonly("failed_shear", &HistoryRow::failed_shear)
      .def_readonly("removed_energy", &HistoryRow::removed_energy, "J");
}

void bind_figures(py::module_& module) {
  py::class_<FirstFailure>(module, "FirstFailure", "The first particle to fail.")
      .def_readonly("step", &FirstFailure::step)
      .def_readonly("closure", &FirstFailure::closure, "m")
      .def_readonly("axial_stress", &FirstFailure::axial_stress, "Pa, compression > 0")
      .def_readonly("position", &FirstFailure::position, "m")
      .def_readonly("mode", &FirstFailure::mode);
  py::class_<RemovedParticles>(module, "RemovedParticles", "What left the grid.")
      .def_readonly("particles", &RemovedParticles::particles)
      .def_readonly("mass", &RemovedParticles::mass, "kg (2D: per metre)")
      .def_readonly("energy", &RemovedParticles::energy, "J");
  py::class_<Facts>(module, "Facts", "Figures of a simulation.")
      .def_readonly("particles", &Facts::particles)
      .def_readonly("nodes", &Facts::nodes)
      .def_readonly("dt", &Facts::dt, "s")
      .def_readonly("total_steps", &Facts::total_steps)
      .def_readonly("memory_bytes", &Facts::memory_bytes)
      .def_readonly("peak_memory_bytes", &Facts::peak_memory_bytes)
      .def_readonly("isa", &Facts::isa)
      .def_readonly("threads", &Facts::threads);
}

}  // namespace

void bind_results(py::module_& module) {
  py::enum_<FailureMode>(module, "FailureMode")
      .value("intact", FailureMode::intact)
      .value("tension", FailureMode::tension)
      .value("shear", FailureMode::shear);
  bind_table(module);
  bind_history(module);
  bind_figures(module);
}

}  // namespace rgimp::python
