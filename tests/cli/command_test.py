"""What the tests of the `rgimp` command share: a case, and running the command on it."""

import csv
import json
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "support"))
from case_text import BLOCK  # noqa: E402

COMMAND = Path(sys.argv.pop(1)).resolve()  # the command under test
DONE, WRONG_REQUEST, PHYSICS_STOPPED, FILE_TROUBLE = 0, 2, 3, 4

# A small block pulled so fast that the first wave breaks it.
CASE = '\ntitle = "pulled block"' + BLOCK + """[material.rock.failure]
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
STEPS = 250

class CommandTest(unittest.TestCase):
    timeout = 120  # s, of one command

    def setUp(self):
        place = tempfile.TemporaryDirectory(prefix="rgimp_command_")
        self.addCleanup(place.cleanup)
        self.place = Path(place.name)
        self.case = self.place / "block.toml"
        self.case.write_text(CASE, encoding="utf-8")

    def attempt(self, *arguments, pass_fds=(), **environment):
        """Runs the command in the test's directory."""
        return subprocess.run(
            [COMMAND, *map(str, arguments)], cwd=self.place, capture_output=True, text=True,
            timeout=self.timeout, check=False, env=os.environ | environment, pass_fds=pass_fds)

    def rgimp(self, *arguments, code=DONE, **environment):
        """Runs the command in the test's directory and checks its exit code."""
        result = self.attempt(*arguments, **environment)
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
