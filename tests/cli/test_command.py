"""The `rgimp` command as its users meet it: exit codes, messages, and the files of a run."""

import csv
import json
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import h5py
import numpy

try:
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkIOHDF import vtkHDFReader
except ImportError:
    vtkHDFReader = None

COMMAND = Path(sys.argv.pop(1)).resolve()  # the command under test
DONE, WRONG_REQUEST, PHYSICS_STOPPED, FILE_TROUBLE = 0, 2, 3, 4

HISTORY_HEADER = (
    "step,time_s,closure_m,axial_stress_Pa,reaction_N,kinetic_energy_J,strain_energy_J,"
    "external_work_J,damping_work_J,viscous_work_J,released_energy_J,failed_tension,failed_shear")
SUMMARY_KEYS = [
    "particles", "steps", "dt_s", "wall_s", "particle_steps_per_second", "isa", "threads",
    "version", "first_failure", "failed_tension", "failed_shear", "peak_axial_stress_Pa",
    "energy_error", "state_hash"]

# A small block pulled so fast that the first wave breaks it.
CASE = """
title = "pulled block"
dimension = 2
[grid]
cell_size = 0.5e-3
[[body]]
shape = "box"
center = [0.0, 0.0]
size = [5e-3, 10e-3]
material = "rock"
[material.rock]
density = 2600.0
youngs_modulus = 17e9
poisson_ratio = 0.14
[material.rock.failure]
criterion = "mohr-coulomb"
cohesion = 5.95e6
friction_angle = 40.0
tensile_strength = 2e6
[[platen]]
side = "top"
speed = -1.0
[[platen]]
side = "bottom"
speed = 0.0
[time]
steps = 250
[output]
history_every = 100
snapshot_every = 200
snapshot_steps = [30]
"""
SLOT = """
[[flaw]]
shape = "slot"
center = [{x}, 0.0]
length = {length}
width = {width}
"""
PARTICLES = 20 * 40
STEPS = 250


class CommandTest(unittest.TestCase):
    def setUp(self):
        place = tempfile.TemporaryDirectory(prefix="rgimp_command_")
        self.addCleanup(place.cleanup)
        self.place = Path(place.name)
        self.case = self.place / "block.toml"
        self.case.write_text(CASE, encoding="utf-8")

    def rgimp(self, *arguments, code=DONE, **environment):
        """Runs the command in the test's directory and checks its exit code."""
        result = subprocess.run(
            [COMMAND, *map(str, arguments)], cwd=self.place, capture_output=True, text=True,
            timeout=120, check=False, env=os.environ | environment)
        self.assertEqual(result.returncode, code, result.stdout + result.stderr)
        return result

    def fail_with(self, code, *arguments, says=(), **environment):
        """Runs the command into an error: one message on stderr that contains `says`."""
        result = self.rgimp(*arguments, code=code, **environment)
        self.assertRegex(result.stderr, r"(?m)^rgimp: error: .")
        for text in says:
            self.assertIn(text, result.stderr)
        return result

    def summary(self, directory="block"):
        return json.loads((self.place / directory / "summary.json").read_text(encoding="utf-8"))

    def history(self, directory="block"):
        with open(self.place / directory / "history.csv", encoding="utf-8", newline="") as file:
            return list(csv.DictReader(file))

    def snapshots(self, directory="block"):
        return sorted(path.name for path in (self.place / directory / "snapshots").glob("*.vtkhdf"))


class HelpTest(CommandTest):
    def test_help_names_the_subcommands_and_shows_examples(self):
        text = self.rgimp("--help").stdout
        for word in ("run", "check", "info", "Examples:", "Exit codes:"):
            self.assertIn(word, text)

    def test_help_of_run_shows_its_options(self):
        text = self.rgimp("run", "--help").stdout
        for option in ("--output", "--threads", "--steps", "--set", "--force", "--quiet",
                       "Examples:"):
            self.assertIn(option, text)

    def test_bare_command_prints_help_and_fails(self):
        self.assertIn("Usage: rgimp", self.rgimp(code=WRONG_REQUEST).stderr)

    def test_version_and_info_agree(self):
        version = self.rgimp("--version").stdout.split()[1]
        info = self.rgimp("info").stdout
        self.assertIn(version, info)
        self.assertIn("reference", info)


class WrongRequestTest(CommandTest):
    def test_wrong_command_lines(self):
        for arguments, says in (
                (("walk",), "walk"),
                (("run",), "CASE"),
                (("run", self.case, "--fast"), "--fast"),
                (("run", self.case, "--steps", "0"), "--steps"),
                (("run", self.case, "--steps", "1.5"), "--steps"),
                (("run", self.case, "--threads", "-1"), "--threads"),
                (("run", self.case, "other.toml"), "other.toml"),
                (("check", self.case, "--force"), "--force")):
            with self.subTest(arguments=arguments):
                self.fail_with(WRONG_REQUEST, *arguments, says=[says])
        self.assertEqual(os.listdir(self.place), ["block.toml"])

    def test_wrong_key_is_named_with_its_line(self):
        self.case.write_text(CASE.replace("cell_size", "cel_size"), encoding="utf-8")
        self.fail_with(WRONG_REQUEST, "run", self.case, "--quiet",
                       says=["block.toml:5", "cel_size", "cell_size"])
        self.fail_with(WRONG_REQUEST, "check", self.case, says=["cel_size"])
        self.assertEqual(os.listdir(self.place), ["block.toml"])

    def test_wrong_cases_are_refused_and_leave_nothing_behind(self):
        second_body = CASE[CASE.index("[[body]]"):CASE.index("[material.rock]")]
        for name, text, says in (
                ("wrong type", CASE.replace("0.5e-3", "true"), "grid.cell_size"),
                ("missing key", CASE.replace("density = 2600.0", ""), "density: missing"),
                ("unknown key", CASE.replace("ratio", "ration"), "poisson_ratio"),
                ("negative size", CASE.replace("5e-3, 10e-3", "-5e-3, 10e-3"), "body[0].size"),
                ("no such material", CASE.replace('"rock"', '"rook"'), '"rock"'),
                ("flaw outside", CASE + SLOT.format(x=0.1, length=3e-3, width=1e-3), "flaw[0]"),
                ("narrow slot", CASE + SLOT.format(x=0.0, length=3e-3, width=0.6e-3), "flaw[0]"),
                ("overlap", CASE + second_body, "body[1]"),
                ("empty", CASE + SLOT.format(x=0.0, length=1.0, width=1.0), "no particle"),
                ("no TOML", "title = ", "block.toml:1")):
            with self.subTest(name=name):
                self.case.write_text(text, encoding="utf-8")
                self.fail_with(WRONG_REQUEST, "run", self.case, says=["block.toml", says])
                self.assertEqual(os.listdir(self.place), ["block.toml"])

    def test_wrong_override(self):
        self.fail_with(WRONG_REQUEST, "run", self.case, "--set", "time.pace=3", says=["pace"])
        self.fail_with(WRONG_REQUEST, "run", self.case, "--set", "nonsense", says=["nonsense"])

    def test_unknown_instruction_set(self):
        for command in (("run", self.case), ("check", self.case), ("info",)):
            with self.subTest(command=command):
                self.fail_with(WRONG_REQUEST, *command, says=["RGIMP_ISA", "mmx"], RGIMP_ISA="mmx")
        self.assertEqual(os.listdir(self.place), ["block.toml"])

    def test_existing_output_needs_force(self):
        output = self.place / "block"
        output.mkdir()
        (output / "notes.txt").write_text("mine", encoding="utf-8")
        self.fail_with(WRONG_REQUEST, "run", self.case, says=["'block'", "--force"])
        self.assertEqual(os.listdir(output), ["notes.txt"])
        (output / "snapshots").mkdir()
        stale = output / "snapshots" / "step_000099999.vtkhdf"
        stale.write_bytes(b"old")
        self.rgimp("run", self.case, "--force", "--steps", 20)
        self.assertTrue((output / "notes.txt").exists())
        self.assertFalse(stale.exists())
        self.assertEqual(self.summary()["steps"], 20)

    def test_the_case_file_itself_is_never_overwritten(self):
        case = self.place / "case.toml"
        case.write_text(CASE, encoding="utf-8")
        self.fail_with(WRONG_REQUEST, "run", case, "-o", ".", "--force", says=["case.toml"])
        self.assertEqual(case.read_text(encoding="utf-8"), CASE)


class FileTroubleTest(CommandTest):
    def test_unreadable_case(self):
        self.fail_with(FILE_TROUBLE, "run", "missing.toml", says=["missing.toml"])
        self.fail_with(FILE_TROUBLE, "check", "missing.toml", says=["missing.toml"])

    def test_unwritable_output(self):
        for place in ("block.toml", "block.toml/below"):  # even root cannot write there
            with self.subTest(place=place):
                self.fail_with(FILE_TROUBLE, "run", self.case, "-o", place, says=[place])
        self.assertEqual(self.case.read_text(encoding="utf-8"), CASE)


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
        series = json.loads((self.place / "block" / "snapshots" / "snapshots.vtkhdf.series")
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

    @unittest.skipIf(vtkHDFReader is None, "VTK's Python modules are not installed")
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

    def test_check_writes_nothing(self):
        text = self.rgimp("check", self.case).stdout
        for word in (f"{PARTICLES} ", "nodes", "dt/dt_cr", "memory", "estimated time"):
            self.assertIn(word.strip(), text)
        self.assertEqual(os.listdir(self.place), ["block.toml"])

    def test_physics_error_saves_the_last_state(self):
        result = self.fail_with(PHYSICS_STOPPED, "run", self.case, "--quiet",
                                "--set", "platen[0].speed=-1e6", says=["'block'"])
        self.assertEqual(result.stdout, "")
        last = self.summary()["steps"]
        self.assertLess(last, STEPS)
        self.assertEqual(self.history()[-1]["step"], str(last))
        self.assertEqual(self.snapshots()[-1], f"step_{last:09d}.vtkhdf")


if __name__ == "__main__":
    unittest.main()
