#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <vector>

#include "bind.hpp"
#include "case_values.hpp"
#include "rgimp/case_file.hpp"

namespace rgimp::python {
namespace {

/// A property of Case that PythonCase keeps in `rest`; what is a struct comes by reference.
template <typename Value>
void add_setting(py::class_<PythonCase>& type, const char* name, Value Case::*member,
                 const char* unit) {
  type.def_property(
      name, [member](PythonCase& owner) -> Value& { return owner.rest.*member; },
      [member](PythonCase& owner, const Value& value) { owner.rest.*member = value; }, unit);
}

void bind_whole(py::module_& m) {
  py::class_<PythonCase> type(m, "Case", "Everything a simulation is made of, in SI units.");
  add_constructor(type);
  add_setting(type, "title", &Case::title, "text");
  add_setting(type, "dimension", &Case::dimension, "2 or 3");
  add_setting(type, "grid", &Case::grid, "GridSettings");
  add_setting(type, "time", &Case::time, "TimeSettings");
  add_setting(type, "local_damping", &Case::local_damping, "1, 0 <= beta < 1; our addition");
  add_setting(type, "quadratic_viscosity", &Case::quadratic_viscosity, "1, c0");
  add_setting(type, "linear_viscosity", &Case::linear_viscosity, "1, c1");
  add_setting(type, "output", &Case::output, "OutputSettings");
  add_setting(type, "numerics", &Case::numerics, "Numerics");
  add_setting(type, "tuning", &Case::tuning, "Tuning");
  type.def_property(
      "body_acceleration",
      [](const PythonCase& owner) { return array_of(owner.rest.body_acceleration); },
      [](PythonCase& owner, const std::vector<double>& value) {
        owner.rest.body_acceleration = vector_of(value);
      },
      "m/s2");
  type.def_readwrite("bodies", &PythonCase::bodies, "list of Body")
      .def_readwrite("flaws", &PythonCase::flaws, "list of Flaw")
      .def_readwrite("platens", &PythonCase::platens, "list of Platen")
      .def_readwrite("materials", &PythonCase::materials, "dict of str to Material")
      .def("__deepcopy__", [](const PythonCase& owner, const py::dict& /*memo*/) {
        return to_python(to_case(owner));
      });
}

template <typename T>
std::vector<T> vector_of_objects(const py::list& list) {
  std::vector<T> objects;
  for (const py::handle element : list) {
    try {
      objects.push_back(element.cast<T>());
    } catch (const py::cast_error&) {
      throw py::type_error("expected a " +
                           std::string(py::str(py::type::of<T>().attr("__name__"))) + ", not " +
                           std::string(py::repr(element)));
    }
  }
  return objects;
}

template <typename T>
py::list list_of(const std::vector<T>& objects) {
  py::list list;
  for (const T& object : objects) {
    list.append(py::cast(object));
  }
  return list;
}

}  // namespace

Case to_case(const PythonCase& settings) {
  Case made = settings.rest;
  made.bodies = vector_of_objects<Body>(settings.bodies);
  made.flaws = vector_of_objects<Flaw>(settings.flaws);
  made.platens = vector_of_objects<Platen>(settings.platens);
  py::list names;
  py::list materials;
  for (const auto& [name, material] : settings.materials) {
    names.append(name);
    materials.append(material);
  }
  const std::vector<Material> converted = vector_of_objects<Material>(materials);
  for (std::size_t i = 0; i < converted.size(); ++i) {
    if (!py::isinstance<py::str>(names[i])) {
      throw py::type_error("the name of a material is a str, not " +
                           std::string(py::repr(names[i])));
    }
    made.materials[names[i].cast<std::string>()] = converted[i];
  }
  return made;
}

PythonCase to_python(const Case& settings) {
  PythonCase made{settings, list_of(settings.bodies), list_of(settings.flaws),
                  list_of(settings.platens), py::dict()};
  for (const auto& [name, material] : settings.materials) {
    made.materials[py::str(name)] = py::cast(material);
  }
  made.rest.bodies.clear();
  made.rest.flaws.clear();
  made.rest.platens.clear();
  made.rest.materials.clear();
  return made;
}

void bind_case(py::module_& module) {
  bind_case_parts(module);
  bind_whole(module);
  module.def(
      "read_case",
      [](const std::filesystem::path& path, const std::vector<std::string>& overrides) {
        return to_python(read_case(path, overrides));
      },
      py::arg("path"), py::arg("overrides") = std::vector<std::string>{},
      "Reads a case file; overrides are \"dotted.key=value\", as of `rgimp run --set`.");
  module.def(
      "check_case", [](const PythonCase& settings) { return check_case(to_case(settings)); },
      py::arg("case"), "Raises CaseError for a case that cannot be run; returns warnings.");
  module.def(
      "write_case", [](const PythonCase& settings) { return write_case(to_case(settings)); },
      py::arg("case"), "The case as the text of a case file.");
}

}  // namespace rgimp::python
