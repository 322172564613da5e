#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <atomic>
#include <chrono>
#include <future>

#include "rgimp/crack_clusters.hpp"
#include "rgimp/cracks.hpp"
#include "rgimp/results.hpp"
#include "rgimp/run.hpp"
#include "rgimp/sweep.hpp"
#include "simulation_handle.hpp"

namespace rgimp::python {
namespace {

/// What Python raised meanwhile, in a callback or by Ctrl-C. It asks the work to stop, in order,
/// with checkpoints, and is raised once it has.
class Interruption {
 public:
  /// Calls act(), which may raise, with the interpreter's lock; of several errors the first is
  /// kept.
  template <typename Act>
  void attempt(Act act) {
    const py::gil_scoped_acquire acquire;
    try {
      act();
    } catch (const py::error_already_set&) {
      if (!error_) {
        error_ = std::current_exception();
      }
      stop_ = true;
    }
  }

  /// Ctrl-C, which Python shows to its main thread alone.
  void look_for_signal() {
    attempt([] {
      if (PyErr_CheckSignals() != 0) {
        throw py::error_already_set();
      }
    });
  }

  /// A Python function as C++ calls it, from any thread; empty for None.
  template <typename Argument>
  std::function<void(const Argument&)> callback(const py::object& function) {
    if (function.is_none()) {
      return {};
    }
    return [this, called = py::handle(function)](const Argument& argument) {
      attempt([&] { called(argument); });
    };
  }

  bool stop() const { return stop_; }

  void raise() const {
    if (error_) {
      std::rethrow_exception(error_);
    }
  }

 private:
  std::atomic<bool> stop_ = false;
  std::exception_ptr error_;
};

RunEnd run(SimulationHandle& handle, const std::filesystem::path& directory,
           ExistingOutput existing, const py::object& on_progress, const py::object& on_notice) {
  Interruption interruption;
  RunOptions options;
  options.directory = directory;
  options.existing = existing;
  options.on_progress = interruption.callback<Progress>(on_progress);
  options.on_notice = interruption.callback<std::string>(on_notice);
  options.stop_requested = [&interruption] {
    interruption.look_for_signal();
    return interruption.stop();
  };
  const RunEnd end =
      handle.change([&](Simulation& simulation) { return run_case(simulation, options); });
  interruption.raise();
  return end;
}

/// The cases run on other threads; this one looks for Ctrl-C.
std::vector<SweepOutcome> sweep_run(const Sweep& sweep, const std::filesystem::path& directory,
                                    ExistingOutput existing, int jobs,
                                    const py::object& on_progress, const py::object& on_notice) {
  Interruption interruption;
  SweepOptions options;
  options.directory = directory;
  options.existing = existing;
  options.jobs = jobs;
  options.on_progress = interruption.callback<SweepProgress>(on_progress);
  options.on_notice = interruption.callback<std::string>(on_notice);
  options.stop_requested = [&interruption] { return interruption.stop(); };

  std::vector<SweepOutcome> outcomes;
  {
    const py::gil_scoped_release release;
    auto work = std::async(std::launch::async, [&] { return run_sweep(sweep, options); });
    while (work.wait_for(std::chrono::milliseconds(100)) == std::future_status::timeout) {
      interruption.look_for_signal();
    }
    outcomes = work.get();
  }
  interruption.raise();
  return outcomes;
}

void bind_runs(py::module_& module) {
  py::enum_<ExistingOutput>(module, "ExistingOutput")
      .value("refuse", ExistingOutput::refuse)
      .value("replace", ExistingOutput::replace)
      .value("resume", ExistingOutput::resume);
  py::enum_<RunEnd>(module, "RunEnd")
      .value("finished", RunEnd::finished)
      .value("stopped", RunEnd::stopped)
      .value("was_finished", RunEnd::was_finished);
  py::class_<Progress>(module, "Progress", "How far a run is.")
      .def_readonly("step", &Progress::step)
      .def_readonly("first_step", &Progress::first_step)
      .def_readonly("total_steps", &Progress::total_steps)
      .def_readonly("particles", &Progress::particles)
      .def_readonly("seconds", &Progress::seconds, "s, in the step loop")
      .def_readonly("failed", &Progress::failed);
  module.def(
      "run_case", &run, py::arg("simulation"), py::arg("directory"),
      py::arg("existing") = ExistingOutput::refuse, py::arg("on_progress") = py::none(),
      py::arg("on_notice") = py::none(),
      "Runs a case to its end and writes its output directory, as `rgimp run` does. Ctrl-C\n"
      "ends it with a checkpoint and KeyboardInterrupt; existing=ExistingOutput.resume goes\n"
      "on. on_progress(Progress) and on_notice(str) are called meanwhile.");
}

void bind_sweep_results(py::module_& module) {
  py::enum_<SweepStatus>(module, "SweepStatus")
      .value("pending", SweepStatus::pending)
      .value("finished", SweepStatus::finished)
      .value("stopped", SweepStatus::stopped)
      .value("physics_stopped", SweepStatus::physics_stopped)
      .value("failed", SweepStatus::failed);
  py::class_<SweepFigures>(module, "SweepFigures")
      .def_readonly("peak_axial_stress", &SweepFigures::peak_axial_stress, "Pa, compression > 0")
      .def_readonly("closure_at_peak", &SweepFigures::closure_at_peak, "m")
      .def_readonly("first_failure", &SweepFigures::first_failure, "FirstFailure, or None")
      .def_readonly("failed_tension", &SweepFigures::failed_tension)
      .def_readonly("failed_shear", &SweepFigures::failed_shear)
      .def_readonly("energy_error", &SweepFigures::energy_error, "1")
      .def_readonly("wall_seconds", &SweepFigures::wall_seconds, "s");
  py::class_<SweepOutcome>(module, "SweepOutcome")
      .def_readonly("status", &SweepOutcome::status)
      .def_readonly("message", &SweepOutcome::message)
      .def_readonly("figures", &SweepOutcome::figures, "SweepFigures, or None");
  py::class_<SweepProgress>(module, "SweepProgress", "In cases.")
      .def_readonly("cases", &SweepProgress::cases)
      .def_readonly("ended", &SweepProgress::ended)
      .def_readonly("running", &SweepProgress::running)
      .def_readonly("done", &SweepProgress::done)
      .def_readonly("seconds", &SweepProgress::seconds, "s");
}

void bind_sweep(py::module_& module) {
  py::class_<SweepRange>(module, "SweepRange")
      .def_readonly("key", &SweepRange::key)
      .def_readonly("values", &SweepRange::values, "TOML texts");
  py::class_<SweepCase>(module, "SweepCase", "One combination.")
      .def_readonly("name", &SweepCase::name, "also of its directory")
      .def_readonly("values", &SweepCase::values, "TOML texts, one for each range")
      .def_property_readonly("settings",
                             [](const SweepCase& one) { return to_python(one.settings); });
  py::class_<Sweep>(module, "Sweep", "The product of some ranges.")
      .def_readonly("ranges", &Sweep::ranges)
      .def_readonly("cases", &Sweep::cases);
  module.def(
      "read_sweep",
      [](const std::filesystem::path& path, const std::vector<std::string>& overrides) {
        return read_sweep(path, overrides);
      },
      py::arg("path"), py::arg("overrides"),
      "Ranges are \"flaw[0].angle=0:90:15\" or \"time.integrator=musl|usl\".");
  module.def("run_sweep", &sweep_run, py::arg("sweep"), py::arg("directory"),
             py::arg("existing") = ExistingOutput::refuse, py::arg("jobs") = 1,
             py::arg("on_progress") = py::none(), py::arg("on_notice") = py::none(),
             "Runs every case, `jobs` at once, each into a directory of its own, and writes\n"
             "sweep.csv. Returns a SweepOutcome for each case. Ctrl-C ends all with checkpoints.");
}

py::object from_json(const std::string& text) {
  return py::module_::import("json").attr("loads")(text);
}

py::object cracks_of(const std::filesystem::path& directory, std::optional<std::int64_t> until) {
  const Results results = read_results(directory, until);
  return from_json(results.settings.dimension == 3
                       ? json_text(trace_clusters(results.settings, results.particles))
                       : json_text(trace_cracks(results.settings, results.particles)));
}

void bind_outputs(py::module_& module) {
  module.def(
      "read_results",
      [](const std::filesystem::path& directory, std::optional<std::int64_t> until) {
        Results results = read_results(directory, until);
        return py::make_tuple(to_python(results.settings), std::move(results.particles));
      },
      py::arg("directory"), py::arg("until") = py::none(),
      "The case and the particles (a ParticleTable) of an output directory's last snapshot.");
  module.def("trace_cracks", &cracks_of, py::arg("directory"), py::arg("until") = py::none(),
             "What `rgimp cracks DIRECTORY --json -` prints, as a dict.");
}

}  // namespace

void bind_run(py::module_& module) {
  bind_runs(module);
  bind_sweep_results(module);
  bind_sweep(module);
  bind_outputs(module);
}

}  // namespace rgimp::python
