"""Runs and checks: the files of a run, and that they agree with each other."""

import json
import os
import unittest

import h5py
import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOHDF import vtkHDFReader

from command_test import CASE, PHYSICS_STOPPED, STEPS, WRONG_REQUEST, CommandTest

HISTORY_HEADER = (
    "step,time_s,closure_m,axial_stress_Pa,reaction_N,kinetic_energy_J,strain_energy_J,"
    "external_work_J,damping_work_J,viscous_work_J,released_energy_J,failed_tension,failed_shear")
SUMMARY_KEYS = [
    "particles", "steps", "dt_s", "wall_s", "particle_steps_per_second", "isa", "threads",
    "version", "first_failure", "failed_tension", "failed_shear", "peak_axial_stress_Pa",
    "energy_error", "removed", "state_hash"]
PARTICLES = 20 * 40


class RunTest(CommandTest):
    def test_files_of_a_run(self):
        result = self.rgimp("run", self.case)
        self.assertIn("rgimp-plot block", result.stdout)
        self.assertEqual(result.stderr, "")
        self.assertEqual(sorted(os.listdir(self.place / "block")),
                         ["case.toml", "history.csv", "snapshots", "summary.json"])
        header = (self.place / "block" / "history.csv").read_text(encoding="utf-8").split("\n")[0]
        self.assertEqual(header, HISTORY_HEADER)
        self.assertEqual([row["step"] for row in self.history()], ["0", "100", "200", "250"])
        self.assertEqual(self.snapshots(),
                         [f"step_{step:09d}.vtkhdf" for step in (0, 30, 200, 250)])
        series = json.loads((self.place / "block" / "snapshots" / "snapshots.hdf.series")
                            .read_text(encoding="utf-8"))
        self.assertEqual([file["name"] for file in series["files"]], self.snapshots())
        self.assertEqual(series["files"][-1]["time"], float(self.history()[-1]["time_s"]))

    def test_summary_agrees_with_history_and_console(self):
        console = self.rgimp("run", self.case).stdout
        summary, last = self.summary(), self.history()[-1]
        self.assertEqual(list(summary), SUMMARY_KEYS)
        self.assertEqual(summary["particles"], PARTICLES)
        self.assertEqual(summary["steps"], STEPS)
        self.assertAlmostEqual(summary["dt_s"] * STEPS, float(last["time_s"]), delta=1e-12)
        self.assertEqual(str(summary["failed_tension"]), last["failed_tension"])
        self.assertGreater(summary["failed_tension"], 0)
        self.assertEqual(summary["first_failure"]["mode"], "tension")
        self.assertGreater(summary["particle_steps_per_second"], 0)
        self.assertRegex(summary["state_hash"], "^[0-9a-f]{16}$")
        self.assertIn(f"{summary['failed_tension']} in tension", console)

    def test_snapshot_read_by_h5py(self):
        self.rgimp("run", self.case, "--quiet")
        summary = self.summary()
        with h5py.File(self.place / "block" / "snapshots" / "step_000000250.vtkhdf") as file:
            data = file["VTKHDF/PointData"]
            failed = data["failed"][:]
            self.assertEqual(len(failed), summary["particles"])
            self.assertEqual(numpy.count_nonzero(failed == 1), summary["failed_tension"])
            self.assertEqual(numpy.count_nonzero(failed == 2), summary["failed_shear"])
            steps = data["failure_step"][:]
            self.assertTrue(numpy.array_equal(steps >= 0, failed > 0))
            self.assertEqual(steps[failed > 0].min(), summary["first_failure"]["step"])
            self.assertTrue(numpy.array_equal(data["id"][:], numpy.arange(PARTICLES)))
            self.assertEqual(file["VTKHDF/FieldData/step"][0], STEPS)

    def test_snapshot_read_by_vtk(self):
        self.rgimp("run", self.case, "--quiet")
        summary = self.summary()
        reader = vtkHDFReader()
        reader.SetFileName(str(self.place / "block" / "snapshots" / "step_000000250.vtkhdf"))
        reader.Update()
        grid = reader.GetOutputDataObject(0)
        self.assertEqual(grid.GetClassName(), "vtkUnstructuredGrid")
        self.assertEqual(grid.GetNumberOfPoints(), summary["particles"])
        self.assertEqual(grid.GetNumberOfCells(), summary["particles"])
        data = grid.GetPointData()
        failed = vtk_to_numpy(data.GetArray("failed"))
        self.assertEqual(numpy.count_nonzero(failed == 1), summary["failed_tension"])
        self.assertEqual(numpy.count_nonzero(failed == 2), summary["failed_shear"])
        self.assertEqual(data.GetArray("stress").GetNumberOfComponents(), 6)
        self.assertEqual(data.GetArray("velocity").GetNumberOfComponents(), 3)

    def test_resolved_case_runs_to_the_same_bits(self):
        self.rgimp("run", self.case, "--quiet", "--set", "damping.local=0.7", "--steps", 100)
        self.rgimp("run", "block/case.toml", "-o", "again", "--quiet", "--threads", 1)
        first, again = self.summary(), self.summary("again")
        self.assertEqual(again["steps"], 100)
        self.assertEqual(again["state_hash"], first["state_hash"])

    def test_quiet_prints_nothing(self):
        result = self.rgimp("run", self.case, "--quiet", "-o", "deep/in/place")
        self.assertEqual(result.stdout + result.stderr, "")
        self.assertEqual(self.summary("deep/in/place")["steps"], STEPS)

    def test_steps_replace_a_duration_and_drop_later_snapshots(self):
        self.case.write_text(CASE.replace("steps = 250", "duration = 1.0"), encoding="utf-8")
        self.rgimp("run", self.case, "--steps", 7, "--quiet")
        self.assertEqual(self.summary()["steps"], 7)

    def test_a_case_cut_short_warns_of_the_snapshots_it_loses(self):
        result = self.rgimp("run", self.case, "--quiet", "--set", "time.steps=20")
        self.assertRegex(result.stderr,
                         r"^rgimp: warning: .*output.snapshot_steps: no snapshot of 30; .* 20\n$")
        self.assertEqual(self.snapshots(), ["step_000000000.vtkhdf", "step_000000020.vtkhdf"])
        self.assertEqual(self.rgimp("run", self.case, "--quiet", "--force", "--steps", 20).stderr,
                         "")

    def test_energy_that_a_body_starts_with_is_no_error(self):
        self.rgimp("run", self.case, "--quiet", "--steps", 100, "--set", "platen=[]",
                   "--set", "body[0].velocity=[0.0, 5.0]")
        self.assertGreater(float(self.history()[-1]["kinetic_energy_J"]), 0.0)
        self.assertLess(abs(self.summary()["energy_error"]), 1e-9)

    def test_check_writes_nothing(self):
        text = self.rgimp("check", self.case).stdout
        for word in (f"{PARTICLES} ", "nodes", "dt/dt_cr", "memory", "estimated time"):
            self.assertIn(word.strip(), text)
        self.assertEqual(os.listdir(self.place), ["block.toml"])

    def test_check_of_a_case_too_fast_to_step_says_what_it_is_first(self):
        result = self.fail_with(PHYSICS_STOPPED, "check", self.case,
                                "--set", "body[0].velocity=[6000.0, 0.0]",
                                "--set", "platen[0].speed=-1e6")
        for word in (f"particles       {PARTICLES}", "nodes", "0.3292 of the critical step",
                     "memory"):
            self.assertIn(word, result.stdout)
        self.assertNotIn("estimated time", result.stdout)

    def test_physics_error_saves_the_last_state(self):
        result = self.fail_with(PHYSICS_STOPPED, "run", self.case, "--quiet",
                                "--set", "platen[0].speed=-1e6", says=["'block'"])
        self.assertEqual(result.stdout, "")
        last = self.summary()["steps"]
        self.assertLess(last, STEPS)
        self.assertEqual(self.history()[-1]["step"], str(last))
        self.assertEqual(self.snapshots()[-1], f"step_{last:09d}.vtkhdf")

    def test_physics_error_says_where_and_what_to_do(self):
        result = self.fail_with(PHYSICS_STOPPED, "run", self.case, "--quiet", "--set", "platen=[]",
                                "--set", "body[0].velocity=[1000.0, 0.0]", "--steps", 1000)
        self.assertRegex(result.stderr,
                         r"^rgimp: error: step \d+: particle \d+ left the grid: "
                         r"position \(0\.\d+, -?\d.*\) m, velocity \(1000, .*\) m/s, "
                         r"dt/dt_cr 0\.\d+; enlarge the grid .*\n$")

    def test_particles_that_leave_are_removed_where_the_case_says_so(self):
        fragment = ('\n[[body]]\nshape = "box"\ncenter = [7e-3, 0.0]\nsize = [1e-3, 1e-3]\n'
                    'material = "rock"\nvelocity = [1000.0, 0.0]\n[material.rock]')
        self.case.write_text(CASE.replace("\n[material.rock]", fragment).replace(
            "speed = -1.0", "speed = 0.0"), encoding="utf-8")
        arguments = ["run", self.case, "--force", "--steps", 400]
        self.fail_with(PHYSICS_STOPPED, *arguments,
                       says=["left the grid", 'grid.on_exit = "remove"'])
        self.fail_with(WRONG_REQUEST, *arguments, "--set", "grid.on_exit=vanish",
                       says=["grid.on_exit", '"vanish"', "stop, remove"])
        result = self.rgimp(*arguments, "--set", "grid.on_exit=remove")
        self.assertRegex(result.stderr, r"^rgimp: warning: .*grid.on_exit.*16 that left the grid, "
                                        r"0.0026 kg, 13\d\d J\n$")
        self.assertRegex(result.stdout, r"(?m)^removed  .*16 that left the grid, 0.0026 kg")
        summary = self.summary()
        self.assertEqual(summary["removed"]["particles"], 16)
        self.assertAlmostEqual(summary["removed"]["mass_kg"], 2600 * 1e-6, delta=1e-12)
        self.assertEqual(summary["particles"], PARTICLES)
        self.assertLess(abs(summary["energy_error"]), 1e-3)
        with h5py.File(self.place / "block/snapshots" / self.snapshots()[-1]) as file:
            self.assertEqual(list(file["VTKHDF/PointData/id"]), list(range(PARTICLES)))
        self.assertIn("0 failed", self.rgimp("cracks", "block").stdout)


if __name__ == "__main__":
    unittest.main()
