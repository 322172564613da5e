"""--json: what the command prints for programs, and nothing else on stdout."""

import json
import re
import unittest

from command_test import PHYSICS_STOPPED, STEPS, WRONG_REQUEST, CommandTest


class JsonTest(CommandTest):
    def json_of(self, *arguments, code=0):
        result = self.rgimp(*arguments, "--json", code=code)
        return json.loads(result.stdout), result.stderr

    def test_run_prints_its_summary(self):
        printed, stderr = self.json_of("run", self.case)
        self.assertEqual(printed, self.summary())
        self.assertEqual(stderr, "")

    def test_a_finished_run_prints_it_again(self):
        self.rgimp("run", self.case, "--quiet")
        printed, stderr = self.json_of("run", self.case, "--resume")
        self.assertEqual(printed, self.summary())
        self.assertIn("nothing to do", stderr)

    def test_a_run_that_the_physics_stops_prints_how_far_it_got(self):
        printed, stderr = self.json_of("run", self.case, "--set", "platen[0].speed=-1e6",
                                       code=PHYSICS_STOPPED)
        self.assertEqual(printed, self.summary())
        self.assertLess(printed["steps"], STEPS)
        self.assertIn("rgimp: error: step", stderr)

    def test_a_wrong_case_prints_nothing_on_stdout(self):
        for verb in ("run", "check"):
            result = self.fail_with(WRONG_REQUEST, verb, self.case, "--json", "--set", "time.pace=1")
            self.assertEqual(result.stdout, "")

    def test_check(self):
        printed, stderr = self.json_of("check", self.case)
        self.assertEqual(stderr, "")
        self.rgimp("run", self.case, "--quiet")
        summary = self.summary()
        for key in ("particles", "steps", "dt_s", "isa", "threads"):
            self.assertEqual(printed[key], summary[key])
        self.assertEqual(printed["title"], "pulled block")
        self.assertEqual(printed["nodes"], [24, 31, 1])
        self.assertAlmostEqual(printed["critical_step_ratio"], 0.1)
        self.assertGreater(printed["peak_memory_bytes"], printed["memory_bytes"])
        self.assertGreater(printed["particle_steps_per_second"], 0)
        self.assertGreater(printed["estimated_wall_s"], 0)
        self.assertEqual(printed["warnings"], [])

    def test_help_names_the_keys(self):
        printed, _ = self.json_of("check", self.case)
        words = re.findall(r"\w+", self.rgimp("check", "--help").stdout)
        self.assertLessEqual(set(printed), set(words))
        printed, _ = self.json_of("sweep", self.case, "--set", "platen[0].speed=-1|1", "-o", "out")
        words = re.findall(r"\w+", self.rgimp("sweep", "--help").stdout)
        one = printed["cases"][0]
        self.assertLessEqual({*printed, *one, *one["first_failure"]}, set(words))

    def test_check_lists_warnings(self):
        printed, stderr = self.json_of("check", self.case, "--set", "output.snapshot_steps=[999]")
        self.assertEqual(len(printed["warnings"]), 1)
        self.assertIn("999", printed["warnings"][0])
        self.assertIn(printed["warnings"][0], stderr)

    def test_info(self):
        printed, _ = self.json_of("info")
        self.assertIn(printed["isa"], printed["isas"])
        self.assertIn("reference", printed["isas"])
        self.assertIn(printed["version"], self.rgimp("--version").stdout)
        self.assertGreaterEqual(printed["threads"], 1)

    def test_cracks_on_stdout(self):
        self.rgimp("run", self.case, "--quiet")
        printed = json.loads(self.rgimp("cracks", "block", "--json", "-").stdout)
        self.rgimp("cracks", "block", "--json", "cracks.json")
        written = json.loads((self.place / "cracks.json").read_text(encoding="utf-8"))
        self.assertEqual(printed, written)
        self.assertFalse((self.place / "-").exists())


if __name__ == "__main__":
    unittest.main()
