"""Runs rgimp-plot on output directories that somebody else prepared: an error in one line, never a
traceback, and no other file is read."""

import os
import sys
import unittest
from pathlib import Path

import numpy as np

import synthetic_output as synthetic
from plot_test import PlotTest, run

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "support"))
from hostile_snapshots import HostileSnapshots  # noqa: E402

FLIPS = 8


class HostileTest(HostileSnapshots, PlotTest):
    def setUp(self):
        super().setUp()
        self.write(mode=1)
        self.snapshot = self.directory / "snapshots" / "step_000003000.vtkhdf"

    def assert_no_traceback(self, *arguments):
        result = run(self.directory, "--dpi", 40, *arguments)
        self.assertIn(result.returncode, (0, 4), result.stderr)
        self.assertNotIn("Traceback", result.stderr)
        return result

    def test_snapshots(self):
        self.for_each_hostile(lambda: self.assert_fails(4, self.snapshot.name))
        self.snapshot.unlink()
        os.mkfifo(self.snapshot)
        self.assert_fails(4, self.snapshot.name)

    def test_turned_bits(self):
        self.for_each_turned_bit(FLIPS, self.assert_no_traceback)

    def test_numbers_at_the_edge(self):
        for x in (1e300, np.inf):
            for rows in (slice(0, 1), slice(None)):
                with self.subTest(x=x, rows=rows):
                    position = self.position.copy()
                    position[rows, 0] = x
                    synthetic.write_snapshot(self.directory, 3000, position)
                    self.assert_no_traceback()

    def test_texts(self):
        for title in ("$\\\\frac{$", "\\u001b[31m\\u0000\\U0010ffff", "x" * 10000):
            with self.subTest(title=title[:20]):
                self.write(title=title)
                self.assertEqual(self.assert_no_traceback().returncode, 0)

    def test_other_files(self):
        history = (self.directory / "history.csv").read_text(encoding="utf-8")
        case = (self.directory / "case.toml").read_text(encoding="utf-8")
        for name, text in (
                ("summary.json", "[" * 100000), ("case.toml", "a=" + "[" * 100000),
                ("case.toml", case.replace("[]", "[1e400]")),
                ("case.toml", case.replace("local = 0.0", "local = inf")),
                ("case.toml", "body = 3\n" + case.replace("[[body]]", "[x]")),
                ("history.csv", history.replace("e-06", "e+306")),
                ("history.csv", history + history.splitlines()[-1].replace("3000,", "inf,") + "\n")):
            with self.subTest(name=name, text=text[:30]):
                self.write(mode=1)
                (self.directory / name).write_text(text, encoding="utf-8")
                self.assert_no_traceback()

    def test_errors_are_harmless_on_a_terminal(self):
        (self.directory / "case.toml").write_text('"\\u001b[31m" = 1\n"\\u001b[31m" = 2\n',
                                                  encoding="utf-8")
        self.assertNotIn("\x1b", self.assert_no_traceback().stderr)
        self.assertNotIn("\x1b", run(self.directory.with_name("\x1b[31m")).stderr)


if __name__ == "__main__":
    unittest.main()
