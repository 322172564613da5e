"""rgimp sweep: a case for every combination of values, several at once."""

import csv
import fcntl
import json
import os
import signal
import subprocess
import time
import unittest

from command_test import COMMAND, FILE_TROUBLE, PHYSICS_STOPPED, WRONG_REQUEST, CommandTest
from resume_test import hear_signals

HEADER = ["case", "platen[0].speed", "time.integrator", "peak_axial_stress_MPa",
          "closure_at_peak_mm", "first_failure_step", "first_failure_closure_mm",
          "first_failure_axial_stress_MPa", "first_failure_mode", "failed_tension",
          "failed_shear", "energy_error", "wall_s", "status", "message"]
SPEEDS = ("--set", "platen[0].speed=-1:1:1")
INTEGRATORS = ("--set", "time.integrator=musl|usl")


class SweepTest(CommandTest):
    def sweep(self, *arguments, code=0):
        return self.rgimp("sweep", self.case, "-o", "out", *arguments, code=code)

    def table(self):
        with open(self.place / "out" / "sweep.csv", encoding="utf-8", newline="") as file:
            return list(csv.DictReader(file))

    def column(self, name):
        return [row[name] for row in self.table()]

    def hashes(self):
        return [self.summary(f"out/{row['case']}")["state_hash"] for row in self.table()]


class TableTest(SweepTest):
    def test_every_combination_has_a_row_and_a_directory(self):
        text = self.sweep(*SPEEDS, *INTEGRATORS).stdout
        rows = self.table()
        self.assertEqual(list(rows[0]), HEADER)
        self.assertEqual([(row["case"], row["platen[0].speed"], row["time.integrator"])
                          for row in rows],
                         [("001", "-1", "musl"), ("002", "-1", "usl"), ("003", "0", "musl"),
                          ("004", "0", "usl"), ("005", "1", "musl"), ("006", "1", "usl")])
        self.assertEqual(set(self.column("status")), {"finished"})
        self.assertEqual(sorted(os.listdir(self.place / "out")),
                         ["001", "002", "003", "004", "005", "006", "sweep.csv"])
        for name in (*HEADER[:3], "peak (MPa)", "finished", "out/sweep.csv"):
            self.assertIn(name, text)
        case = (self.place / "out/006/case.toml").read_text(encoding="utf-8")
        self.assertRegex(case, r'speed = 1\.0(.|\n)*integrator = "usl"')

    def test_figures_are_those_of_the_runs(self):
        self.sweep(*SPEEDS)
        for row in self.table():
            summary, history = self.summary(f"out/{row['case']}"), self.history(f"out/{row['case']}")
            first = summary["first_failure"] or {}
            self.assertEqual(row["first_failure_mode"], first.get("mode", "none"))
            self.assertEqual(row["first_failure_step"], str(first.get("step", "")))
            self.assertEqual(row["failed_tension"], str(summary["failed_tension"]))
            self.assertAlmostEqual(float(row["peak_axial_stress_MPa"]) * 1e6,
                                   summary["peak_axial_stress_Pa"],
                                   delta=1e-5 * summary["peak_axial_stress_Pa"])
            highest = max(history, key=lambda row: float(row["axial_stress_Pa"]))
            self.assertAlmostEqual(float(row["closure_at_peak_mm"]) * 1e-3,
                                   float(highest["closure_m"]), delta=1e-11)
        self.assertIn("tension", self.column("first_failure_mode"))
        self.assertGreater(float(self.column("peak_axial_stress_MPa")[2]), 10.0)

    def test_results_are_those_of_single_runs_whatever_the_jobs(self):
        self.rgimp("run", self.case, "--quiet", "--set", "platen[0].speed=-0.5")
        found = set()
        for jobs, threads in ((1, 1), (3, 1), (2, 2)):
            self.sweep("--set", "platen[0].speed=-1|-0.5|1", "--jobs", jobs, "--threads", threads,
                       "--force")
            self.assertEqual(self.hashes()[1], self.summary()["state_hash"])
            self.assertEqual(self.summary("out/001")["threads"], threads)
            found.add(tuple(self.hashes()))
        self.assertEqual(len(found), 1)
        self.assertEqual(len(set(*found)), 3)

    def test_a_fixed_value_holds_for_all_cases(self):
        self.sweep(*SPEEDS, "--set", "time.steps=30", "--set", "tuning.threads=2")
        for name in ("001", "002", "003"):
            self.assertEqual(self.summary(f"out/{name}")["steps"], 30)
            self.assertEqual(self.summary(f"out/{name}")["threads"], 2)

    def test_ranges(self):
        for text, values in (
                ("platen[0].speed=0:1:0.3", ["0", "0.3", "0.6", "0.9"]),
                ("platen[0].speed=0.1:0.3:0.1", ["0.1", "0.2", "0.3"]),
                ("platen[0].speed=1:-1:-1", ["1", "0", "-1"]),
                ("platen[0].ramp=1e-6:1e-6:1", ["1e-06"]),
                ('title="a|b:c"|"d"', ['"a|b:c"', '"d"'])):
            with self.subTest(text=text):
                self.sweep("--set", text, *INTEGRATORS, "--steps", 2, "--force")
                key = text.split("=")[0]
                found = [row.get(key) for row in self.table()[::2]]
                self.assertEqual(found, values if len(values) > 1 else [None])

    def test_json(self):
        result = self.sweep(*SPEEDS, "--json")
        self.assertEqual(result.stderr, "")
        sweep = json.loads(result.stdout)
        self.assertEqual(sweep["directory"], "out")
        self.assertEqual([one["set"] for one in sweep["cases"]],
                         [{"platen[0].speed": speed} for speed in (-1, 0, 1)])
        for one in sweep["cases"]:
            summary = self.summary(f"out/{one['case']}")
            self.assertEqual(one["status"], "finished")
            for key in ("first_failure", "failed_tension", "failed_shear", "peak_axial_stress_Pa",
                        "energy_error", "wall_s"):
                self.assertEqual(one[key], summary[key])


class RefusalTest(SweepTest):
    def test_wrong_ranges(self):
        for text, says in (
                ("time.steps=100", "nothing to sweep over"), ("time.steps", "KEY=START:STOP:STEP"),
                ("time.steps=1:2", "START:STOP:STEP"), ("time.steps=1:2:3:4", "START:STOP:STEP"),
                ("time.steps=1:x:3", "START:STOP:STEP"), ("time.steps=1:nan:3", "START:STOP:STEP"),
                ("time.steps=1:9:0", "do not lead"), ("time.steps=9:1:1", "do not lead"),
                ("time.steps=1:1e9:1", "at most 10000"), ("time.steps=1||2", "not a TOML value"),
                ("time.pace=1|2", "pace"), ("=1|2", "dotted key")):
            with self.subTest(text=text):
                self.fail_with(WRONG_REQUEST, "sweep", self.case, "--set", text, "-o", "out",
                               says=[says])
        self.fail_with(WRONG_REQUEST, "sweep", self.case, *SPEEDS, *SPEEDS, "-o", "out",
                       says=["varied already"])
        self.fail_with(WRONG_REQUEST, "sweep", self.case, "--set", "time.steps=1:5000:1", "--set",
                       "output.history_every=1:5000:1", "-o", "out", says=["10000 cases"])
        self.fail_with(WRONG_REQUEST, "sweep", self.case, *SPEEDS, says=["--output"])
        self.assertEqual(os.listdir(self.place), ["block.toml"])

    def test_all_cases_are_checked_before_the_first_one_runs(self):
        self.fail_with(WRONG_REQUEST, "sweep", self.case, "-o", "out", *INTEGRATORS,
                       "--set", "grid.cell_size=0.5e-3|0.3e-3",
                       says=["case 002 (time.integrator=musl, grid.cell_size=0.3e-3)", "platen[0]"])
        self.assertEqual(os.listdir(self.place), ["block.toml"])

    def test_a_used_directory(self):
        self.sweep("--set", "platen[0].speed=-1:2:1")
        (self.place / "out" / "notes.txt").write_text("mine", encoding="utf-8")
        (self.place / "out/003/notes.txt").write_text("mine", encoding="utf-8")
        self.rgimp("grid", "out/004")
        (self.place / "out/004/pictures").mkdir()
        self.fail_with(WRONG_REQUEST, "sweep", self.case, *INTEGRATORS, "-o", "out",
                       says=["'out' is not empty", "--force", "--resume"])
        self.fail_with(WRONG_REQUEST, "sweep", self.case, *INTEGRATORS, "-o", "out", "--resume",
                       says=["out/002/case.toml", "'speed = 0.0'"])
        self.sweep("--set", "time.integrator=usf", "--set", "platen[0].speed=-2|-3", "--force")
        self.assertEqual(sorted(os.listdir(self.place / "out")),
                         ["001", "002", "003", "notes.txt", "sweep.csv"])
        self.assertEqual(os.listdir(self.place / "out/003"), ["notes.txt"])
        self.assertEqual(self.column("platen[0].speed"), ["-2", "-3"])

    def test_where_another_sweep_is_at_work(self):
        (self.place / "out").mkdir()
        place = os.open(self.place / "out", os.O_RDONLY)
        self.addCleanup(os.close, place)
        fcntl.flock(place, fcntl.LOCK_EX)
        self.fail_with(WRONG_REQUEST, "sweep", self.case, *SPEEDS, "-o", "out", says=["at work"])

    def test_where_nothing_can_be_written(self):
        for place in ("block.toml", "block.toml/below", "/dev/null"):
            self.fail_with(FILE_TROUBLE, "sweep", self.case, *SPEEDS, "-o", place, says=[place])
        (self.place / "out/sweep.csv/x").mkdir(parents=True)
        self.fail_with(FILE_TROUBLE, "sweep", self.case, *SPEEDS, "-o", "out", "--resume",
                       says=["sweep.csv"])


class FailingCaseTest(SweepTest):
    def test_a_case_that_fails_keeps_no_other_from_running(self):
        result = self.sweep("--set", "platen[0].speed=-1|-1e6|1", "--jobs", 1,
                            code=PHYSICS_STOPPED)
        self.assertIn("1 of 3 cases failed", result.stderr)
        self.assertEqual(self.column("status"), ["finished", "physics stopped", "finished"])
        message = self.column("message")[1]
        self.assertIn("time step", message)
        self.assertIn(message, result.stdout)
        self.assertEqual(self.column("message")[::2], ["", ""])

    def test_a_case_that_cannot_be_written(self):
        self.sweep(*SPEEDS)
        (self.place / "out/002/summary.json").unlink()
        (self.place / "out/002/history.csv").unlink()
        (self.place / "out/002/history.csv").mkdir()
        self.sweep(*SPEEDS, "--resume", code=PHYSICS_STOPPED)
        self.assertEqual(self.column("status"), ["finished", "failed", "finished"])
        self.assertIn("history.csv", self.column("message")[1])


class ResumeTest(SweepTest):
    LONG = ("--set", "time.steps=4000|40000000", "--set", "output.snapshot_steps=[]",
            "--set", "output.snapshot_every=40000000", "--set", "output.checkpoint_every=100000")

    def interrupt(self, *arguments):
        """Sends SIGINT when the second case is under way."""
        with subprocess.Popen([COMMAND, "sweep", self.case, "-o", "out", *arguments],
                              cwd=self.place, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                              text=True, preexec_fn=hear_signals) as process:
            limit = time.monotonic() + 60
            while not (self.place / "out/002/history.csv").exists():
                self.assertLess(time.monotonic(), limit)
                time.sleep(0.02)
            process.send_signal(signal.SIGINT)
            return process.communicate(timeout=60) + (process.returncode,)

    def test_ctrl_c_stops_with_checkpoints_and_resume_goes_on(self):
        stdout, stderr, code = self.interrupt(*self.LONG, "--jobs", "1")
        self.assertEqual(code, 128 + signal.SIGINT)
        self.assertIn("--resume", stderr)
        self.assertEqual(self.column("status"), ["finished", "stopped"])
        self.assertIn("stopped", stdout)
        self.assertTrue(list((self.place / "out/002").glob("checkpoint_*.rgimp")))
        before = (self.place / "out/001/summary.json").read_bytes()
        steps = max(int(row["step"]) for row in self.history("out/002")) + 200
        result = self.sweep("--set", f"time.steps=4000|{steps}", *self.LONG[2:], "--resume")
        self.assertIn("case 002: going on from step", result.stderr)
        self.assertEqual((self.place / "out/001/summary.json").read_bytes(), before)
        self.assertEqual(self.column("status"), ["finished", "finished"])
        self.rgimp("run", self.case, "--quiet", "--steps", steps, *self.LONG[2:])
        self.assertEqual(self.summary("out/002")["state_hash"], self.summary()["state_hash"])

    def test_cases_that_were_not_begun_begin(self):
        self.sweep("--set", "platen[0].speed=-1|0")
        self.sweep(*SPEEDS, "--resume")
        self.assertEqual(self.column("status"), ["finished"] * 3)


if __name__ == "__main__":
    unittest.main()
