"""What the tests of the benchmarks share: running bench/report.py, reading its page."""

import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

PROGRAM = Path(__file__).resolve().parents[2] / "bench/report.py"


class ReportTest(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory(prefix="rgimp_bench_")
        self.addCleanup(temporary.cleanup)
        self.place = Path(temporary.name)
        self.page = self.place / "out/results.md"
        self.picture = self.place / "out/size.png"
        self.data = self.place / "out/results.json"

    def run_report(self, *inputs):
        return subprocess.run(
            [sys.executable, "-B", PROGRAM, *inputs, "--page", self.page, "--picture", self.picture,
             "--data", self.data], capture_output=True, text=True, check=False, timeout=120)

    def report(self, *inputs):
        """The page of inputs that can be reported."""
        done = self.run_report(*inputs)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return self.page.read_text(encoding="utf-8")

    def row(self, page, first):
        """The cells after the first of the one table row that begins with it."""
        rows = [[cell.strip() for cell in line.strip("|").split("|")]
                for line in page.splitlines() if line.startswith("|")]
        found = [row[1:] for row in rows if row[0] == first]
        self.assertEqual(len(found), 1, f"rows of {first}")
        return found[0]
