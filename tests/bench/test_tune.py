"""bench/tune: the block it prints, its picture, and what it says of wrong requests.

Usage: test_tune.py RGIMP [unittest's options]
"""

import subprocess
import sys
import tempfile
import tomllib
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "support"))
from case_text import BLOCK  # noqa: E402

RGIMP = sys.argv.pop(1)
TUNE = Path(__file__).resolve().parents[2] / "bench" / "tune"
CASE = BLOCK.replace("[material.rock]", "velocity = [0.1, 0.0]\n[material.rock]") + """[time]
steps = 100000
"""


class TuneTest(unittest.TestCase):
    def setUp(self):
        place = tempfile.TemporaryDirectory(prefix="rgimp_tune_test_")
        self.addCleanup(place.cleanup)
        self.place = Path(place.name)
        self.case = self.place / "block.toml"
        self.case.write_text(CASE, encoding="utf-8")

    def tune(self, *arguments):
        return subprocess.run([TUNE, "--rgimp", RGIMP, *map(str, arguments)], text=True,
                              capture_output=True, check=False, timeout=300)

    def test_the_block_can_be_pasted_and_the_picture_is_there(self):
        picture = self.place / "pictures" / "tune.png"
        done = self.tune(self.case, "--repetitions", 1, "-o", picture)
        self.assertEqual(done.returncode, 0, done.stderr)
        tuning = tomllib.loads(done.stdout)["tuning"]
        self.assertGreaterEqual(tuning["threads"], 1)
        self.assertIn(tuning["bands_per_task"], (1, 2, 4, 8, 16))
        self.assertIn("M particle-steps/s", done.stdout)
        self.assertEqual(picture.read_bytes()[:4], b"\x89PNG")
        self.case.write_text(CASE + done.stdout, encoding="utf-8")
        subprocess.run([RGIMP, "run", self.case, "-o", self.place / "out", "--quiet", "--steps",
                        "5"], check=True)

    def test_wrong_requests(self):
        for arguments, says in (
                ((self.place / "missing.toml",), "missing.toml"),
                ((self.case, "--set", "grid.cell_size=-1"), "grid.cell_size"),
                ((self.case, "--rgimp", "no_such_command"), "no_such_command"),
                ((self.case, "--repetitions", "0"), "--repetitions")):
            with self.subTest(arguments=arguments):
                done = self.tune(*arguments)
                self.assertNotEqual(done.returncode, 0)
                self.assertIn(says, done.stderr)
                self.assertNotIn("Traceback", done.stderr)
                self.assertEqual(done.stdout, "")


if __name__ == "__main__":
    unittest.main()
