#include <pybind11/eigen.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <optional>
#include <vector>

#include "bind.hpp"
#include "case_values.hpp"
#include "rgimp/case.hpp"

namespace rgimp::python {

Vector vector_of(const std::vector<double>& components) {
  if (components.size() != 2 && components.size() != 3) {
    throw py::value_error("a vector has two or three components, not " +
                          std::to_string(components.size()));
  }
  return {components[0], components[1], components.size() == 3 ? components[2] : 0.0};
}

py::array_t<double> array_of(const Vector& vector) {
  py::array_t<double> array(3, vector.data());
  array.attr("setflags")(py::arg("write") = false);
  return array;
}

namespace {

template <typename T, typename... Options>
void add_optional_vector(py::class_<T, Options...>& type, const char* name,
                         std::optional<Vector> T::*member, const char* unit) {
  type.def_property(
      name,
      [member](const T& owner) -> py::object {
        return owner.*member ? py::object(array_of(*(owner.*member))) : py::none();
      },
      [member](T& owner, const std::optional<std::vector<double>>& value) {
        owner.*member = value ? std::optional(vector_of(*value)) : std::nullopt;
      },
      unit);
}

void bind_names(py::module_& m) {
  py::enum_<OnExit>(m, "OnExit").value("stop", OnExit::stop).value("remove", OnExit::remove);
  py::enum_<BodyShape>(m, "BodyShape")
      .value("box", BodyShape::box)
      .value("disk", BodyShape::disk)
      .value("cylinder", BodyShape::cylinder)
      .value("sphere", BodyShape::sphere);
  py::enum_<FlawShape>(m, "FlawShape")
      .value("slot", FlawShape::slot)
      .value("circle", FlawShape::circle)
      .value("box", FlawShape::box)
      .value("sphere", FlawShape::sphere)
      .value("penny", FlawShape::penny);
  py::enum_<SlotEnds>(m, "SlotEnds")
      .value("square", SlotEnds::square)
      .value("round", SlotEnds::round);
  py::enum_<Criterion>(m, "Criterion")
      .value("mohr_coulomb", Criterion::mohr_coulomb)
      .value("hydrostatic_tension", Criterion::hydrostatic_tension)
      .value("principal_stress", Criterion::principal_stress)
      .value("shear_stress", Criterion::shear_stress)
      .value("principal_strain", Criterion::principal_strain)
      .value("shear_strain", Criterion::shear_strain);
  py::enum_<Treatment>(m, "Treatment")
      .value("no_tension", Treatment::no_tension)
      .value("stress_free", Treatment::stress_free)
      .value("pressure_window", Treatment::pressure_window);
  py::enum_<Side>(m, "Side")
      .value("top", Side::top)
      .value("bottom", Side::bottom)
      .value("left", Side::left)
      .value("right", Side::right)
      .value("front", Side::front)
      .value("back", Side::back);
  py::enum_<Lateral>(m, "Lateral").value("slip", Lateral::slip).value("stick", Lateral::stick);
  py::enum_<Integrator>(m, "Integrator")
      .value("musl", Integrator::musl)
      .value("usl", Integrator::usl)
      .value("usf", Integrator::usf);
}

void bind_bodies(py::module_& m) {
  py::class_<Body> body(m, "Body");
  add_constructor(body);
  body.def_readwrite("shape", &Body::shape)
      .def_readwrite("material", &Body::material, "a key of Case.materials")
      .def_readwrite("particles_per_cell", &Body::particles_per_cell, "per axis, 2 to 4");
  add_vector(body, "center", &Body::center, "m");
  add_vector(body, "size", &Body::size, "m; disk and sphere: the diameter first");
  add_vector(body, "axis", &Body::axis, "cylinder only, of any length");
  add_vector(body, "velocity", &Body::velocity, "m/s, initial");

  py::class_<Flaw> flaw(m, "Flaw", "A hole in every body.");
  add_constructor(flaw);
  flaw.def_readwrite("shape", &Flaw::shape)
      .def_readwrite("length", &Flaw::length, "m, slot: tip to tip; else the diameter")
      .def_readwrite("width", &Flaw::width, "m, slot and penny: between the faces")
      .def_readwrite("angle", &Flaw::angle, "degrees from +x, counterclockwise; slot only")
      .def_readwrite("ends", &Flaw::ends, "slot only")
      .def_readwrite("depth", &Flaw::depth, "m, of a slot in space; None: all through");
  add_vector(flaw, "center", &Flaw::center, "m");
  add_vector(flaw, "size", &Flaw::size, "m, box only: edges");
  add_optional_vector(flaw, "direction", &Flaw::direction, "of a slot in space, along its length");
  add_optional_vector(flaw, "normal", &Flaw::normal,
                      "of a slot or penny in space, across its width");

  py::class_<Platen> platen(m, "Platen");
  add_constructor(platen);
  platen.def_readwrite("side", &Platen::side)
      .def_readwrite("speed", &Platen::speed, "m/s, towards the specimen; 0 holds")
      .def_readwrite("ramp", &Platen::ramp, "s, from rest to `speed`")
      .def_readwrite("lateral", &Platen::lateral)
      .def_readwrite("half_width", &Platen::half_width, "m; None: the whole end");
}

void bind_materials(py::module_& m) {
  py::class_<Failure> failure(m, "Failure");
  add_constructor(failure);
  failure.def_readwrite("criterion", &Failure::criterion)
      .def_readwrite("cohesion", &Failure::cohesion, "Pa")
      .def_readwrite("friction_angle", &Failure::friction_angle, "degrees")
      .def_readwrite("tensile_strength", &Failure::tensile_strength, "Pa")
      .def_readwrite("shear_strength", &Failure::shear_strength, "Pa")
      .def_readwrite("tensile_strain", &Failure::tensile_strain, "1")
      .def_readwrite("shear_strain", &Failure::shear_strain, "1")
      .def_readwrite("fracture_energy", &Failure::fracture_energy, "J/m2; 0: fails at once")
      .def_readwrite("shear_fracture_energy", &Failure::shear_fracture_energy, "J/m2")
      .def_readwrite("treatment", &Failure::treatment)
      .def_readwrite("pressure_min", &Failure::pressure_min, "Pa, <= 0 (tension)")
      .def_readwrite("pressure_max", &Failure::pressure_max, "Pa, >= 0");

  py::class_<Material> material(m, "Material");
  add_constructor(material);
  material.def_readwrite("density", &Material::density, "kg/m3")
      .def_readwrite("youngs_modulus", &Material::youngs_modulus, "Pa")
      .def_readwrite("poisson_ratio", &Material::poisson_ratio, "1")
      // By reference, so that material.failure.cohesion can be set; an optional would be copied.
      .def_property(
          "failure", [](Material& owner) { return owner.failure ? &*owner.failure : nullptr; },
          [](Material& owner, const std::optional<Failure>& value) { owner.failure = value; },
          "None: never fails");
}

void bind_settings(py::module_& m) {
  py::class_<GridSettings> grid(m, "GridSettings");
  add_constructor(grid);
  grid.def_readwrite("cell_size", &GridSettings::cell_size, "m")
      .def_readwrite("on_exit", &GridSettings::on_exit);
  add_optional_vector(grid, "min", &GridSettings::min, "m, lower corner");
  add_optional_vector(grid, "max", &GridSettings::max, "m, upper corner");

  py::class_<TimeSettings> time(m, "TimeSettings", "Either steps or duration.");
  add_constructor(time);
  time.def_readwrite("steps", &TimeSettings::steps)
      .def_readwrite("duration", &TimeSettings::duration, "s")
      .def_readwrite("step_factor", &TimeSettings::step_factor, "alpha of Eq. 24")
      .def_readwrite("integrator", &TimeSettings::integrator);

  py::class_<OutputSettings> output(m, "OutputSettings");
  add_constructor(output);
  output.def_readwrite("history_every", &OutputSettings::history_every, "steps")
      .def_readwrite("snapshot_every", &OutputSettings::snapshot_every, "steps")
      .def_property(
          "snapshot_steps",
          [](const OutputSettings& owner) { return py::tuple(py::cast(owner.snapshot_steps)); },
          [](OutputSettings& owner, const std::vector<std::int64_t>& steps) {
            owner.snapshot_steps = steps;
          })
      .def_readwrite("checkpoint_every", &OutputSettings::checkpoint_every, "steps");

  py::class_<Tuning> tuning(m, "Tuning", "Of speed; never changes a bit.");
  add_constructor(tuning);
  tuning.def_readwrite("threads", &Tuning::threads, "0: all")
      .def_readwrite("bands_per_task", &Tuning::bands_per_task);

  py::class_<Numerics> numerics(m, "Numerics", "The order of sums.");
  add_constructor(numerics);
  numerics.def_readwrite("band_height", &Numerics::band_height, "rows of nodes, 2 to 64");
}

}  // namespace

void bind_case_parts(py::module_& module) {
  bind_names(module);
  bind_bodies(module);
  bind_materials(module);
  bind_settings(module);
}

}  // namespace rgimp::python
