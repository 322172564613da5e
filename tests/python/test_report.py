"""The page of rgimp-report as text: what is on it, and what it does with bad directories."""

import json
import os
import re
import subprocess
import sys
import unittest
from pathlib import Path
from unittest import mock

import numpy as np

import synthetic_output as synthetic
from plot_test import PROGRAM, TENSION, PlotTest, run

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "support"))
from hostile_snapshots import HostileSnapshots  # noqa: E402

REPORT = PROGRAM.with_name("rgimp-report")
BODY = '[[body]]\nshape = "box"\ncenter = [0.0, 0.0]\nsize = [10e-3, 20e-3]\n'
FLAW = '[[flaw]]\nshape = "circle"\ncenter = [0.0, 0.0]\nlength = 4e-3\n'


class ReportTest(HostileSnapshots, PlotTest):
    def write(self, mode=0, **arguments):
        super().write(mode, **arguments)
        case = self.directory / "case.toml"
        case.write_text(case.read_text(encoding="utf-8").replace("[[body]]\n", BODY) + FLAW,
                        encoding="utf-8")

    def report(self, *arguments):
        return run(*(arguments or [self.directory]), program=REPORT)

    def page(self):
        done = self.report()
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return (self.directory / "report.html").read_text(encoding="utf-8")

    def data(self, page, name):
        return json.loads(re.search(rf"(?m)^const {name} = (.*);$", page)[1])

    def refused(self, code, message, *arguments):
        done = self.report(*arguments)
        self.assertEqual(done.returncode, code, done.stderr)
        self.assertIn("rgimp-report: error: ", done.stderr)
        self.assertIn(message, done.stderr)
        self.assertNotIn("Traceback", done.stderr)

    def test_frames_count_the_failures_of_the_last_snapshot(self):
        self.write(TENSION)
        frames = self.data(self.page(), "growth")["frames"]
        cracked = (np.abs(self.position[:, 0]) < synthetic.PITCH) & (self.position[:, 1] > 2e-3)
        self.assertEqual(frames[0]["step"], 0)
        self.assertEqual(frames[-1]["step"], 3000)
        for frame in frames:
            self.assertEqual(frame["tension"], cracked.sum() * (frame["step"] >= 2000), frame)
            self.assertEqual(frame["shear"], 0)

    def test_of_very_many_failures_a_sample_is_drawn_and_all_are_counted(self):
        self.write(TENSION)
        whole = self.data(self.page(), "growth")
        with mock.patch("rgimp_report.growth_data.MOST_PARTICLES", 10):
            page = self.page()
        growth = self.data(page, "growth")
        self.assertGreater(whole["failed"], 10)
        self.assertEqual((whole["drawn"], growth["drawn"]), (whole["failed"], 10))
        self.assertEqual(growth["frames"], whole["frames"])
        self.assertIn(f"draws 10 of {whole['failed']} failed particles", page)

    def test_curves_are_those_of_the_history(self):
        self.write(TENSION)
        curves = self.data(self.page(), "curves")
        rows = np.genfromtxt(self.directory / "history.csv", delimiter=",", names=True)
        for name, values in curves["columns"].items():
            np.testing.assert_allclose(values, rows[name], rtol=1e-5)

    def test_a_run_without_failures(self):
        self.write()
        page = self.page()
        self.assertIn("No particle failed.", page)
        self.assertEqual(self.data(page, "growth")["step"], "")

    def test_a_run_that_has_not_ended_says_so(self):
        self.write(TENSION)
        (self.directory / "summary.json").unlink()
        self.assertIn("The run has not ended", self.page())

    def test_values_that_are_not_numbers_become_gaps(self):
        self.write(TENSION)
        history = self.directory / "history.csv"
        history.write_text(history.read_text(encoding="utf-8")
                           + "3001" + ",nan" * 10 + ",1,0\n", encoding="utf-8")
        page = self.page()
        self.assertIsNone(self.data(page, "curves")["columns"]["axial_stress_Pa"][-1])

    def test_a_title_cannot_bring_code_along(self):
        self.write(title="</title><script>document.title = 'taken'</script> ${7 * 7} {{ 7 * 7 }}")
        page = self.page()
        self.assertNotIn("<script>document", page)
        self.assertIn("&lt;script&gt;document", page)
        self.assertIn("{{ 7 * 7 }}", page)

    def test_nothing_on_the_page_leads_elsewhere(self):
        self.write(TENSION)
        page = self.page()
        self.assertEqual(set(re.findall(r'(?:src|href)="(\w+):', page)), {"data"})
        self.assertEqual(set(re.findall(r"https?://[^\s\"]+", page)),
                         {"http://www.w3.org/2000/svg"})  # a name that no browser opens
        self.assertLess(len(page), 5e6)

    def test_bad_directories_give_errors_and_no_page(self):
        self.refused(2, "no such directory")
        self.write(TENSION)
        self.refused(4, "it is a directory", self.directory, "-o", self.directory)
        (self.directory / "history.csv").write_text("step\n", encoding="utf-8")
        self.refused(4, "column time_s is missing")
        self.assertFalse((self.directory / "report.html").exists())

    def test_damaged_summaries_are_named(self):
        self.write(TENSION)
        for damage in ({"step": 2000, "closure_m": "far", "mode": "tension"}, {"step": 2000}):
            synthetic.write_summary(self.directory, damage, particle_steps_per_second=[1])
            with self.subTest(damage):
                done = self.report()
                self.assertIn(done.returncode, (0, 4))
                self.assertNotIn("Traceback", done.stderr)

    def test_snapshots_that_somebody_else_prepared(self):
        self.write(TENSION)
        self.snapshot = self.directory / "snapshots" / "step_000003000.vtkhdf"
        self.for_each_hostile(lambda: self.refused(4, self.snapshot.name))

    def test_damaged_cases_are_named(self):
        for damage in ("body = 3\n", "[[body]]\nshape = 3\n", "[material]\nrock = 3\n", "time = 4\n",
                       "[[body]]\nshape = \"box\"\ncenter = [nan, 0.0]\nsize = [1.0, 1.0]\n"):
            with self.subTest(damage):
                self.write(TENSION)
                grid = "[grid]\ncell_size = 0.5e-3\n"
                body = "" if "body" in damage else BODY
                (self.directory / "case.toml").write_text(
                    damage + grid + body if damage[0] != "[" else grid + body + damage,
                    encoding="utf-8")
                self.refused(4, "case.toml is damaged")

    def test_a_page_that_cannot_be_finished_leaves_the_old_one(self):
        self.write(TENSION)
        before = self.page()
        done = subprocess.run(["bash", "-c", f"ulimit -f 8; exec {REPORT} {self.directory}"],
                              capture_output=True, text=True, timeout=100,
                              env=os.environ | {"PYTHONDONTWRITEBYTECODE": "1"})
        self.assertNotEqual(done.returncode, 0)
        self.assertEqual((self.directory / "report.html").read_text(encoding="utf-8"), before)


if __name__ == "__main__":
    unittest.main()
