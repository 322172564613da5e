"""Runs rgimp-plot on output directories it cannot draw."""

import unittest

import numpy as np

import synthetic_output as synthetic
from plot_test import PlotTest


class ErrorsTest(PlotTest):
    def test_bad_usage(self):
        self.write()
        self.assert_fails(2, "DIR", "--dpi", 100)
        self.assert_fails(2, "--dpi", self.directory, "--dpi", 5)
        self.assert_fails(2, "invalid int value", self.directory, "--step", "x")
        self.assert_fails(2, "no snapshot of step 1234; the nearest are 0, 1000, 2000, 3000",
                          self.directory, "--step", 1234)

    def test_not_an_output_directory(self):
        self.assert_fails(2, "no such directory")
        self.directory.mkdir()
        self.assert_fails(2, "not an output directory")

    def test_no_snapshots(self):
        synthetic.write_case(self.directory)
        synthetic.write_history(self.directory, (0,))
        self.assert_fails(4, "no snapshots")

    def test_slices_of_a_plane_run(self):
        self.write()
        self.assert_fails(2, "three-dimensional", self.directory, "--slices", 0, 0, 0)

    def test_broken_history(self):
        self.write()
        history = self.directory / "history.csv"
        text = history.read_text()
        history.write_text(text[:-40])
        self.assert_fails(4, "history.csv, line 5: ")
        history.write_text(text.replace("closure_m", "closure"))
        self.assert_fails(4, "column closure_m is missing")
        history.write_text(text.split("\n")[0] + "\n")
        self.assert_fails(4, "has no rows")
        history.write_text(text.replace("1000,", "one,", 1))
        self.assert_fails(4, "history.csv, line 3: ")
        history.write_text("")
        self.assert_fails(4, "column step is missing")
        history.unlink()
        history.mkdir()
        self.assert_fails(4, "cannot read")

    def test_broken_snapshot(self):
        self.write()
        path = self.directory / "snapshots" / "step_000003000.vtkhdf"
        whole = path.read_bytes()
        path.write_bytes(whole[:len(whole) // 2])
        self.assert_fails(4, "step_000003000.vtkhdf")
        synthetic.write_snapshot(self.directory, 3000, self.position, np.zeros(3))
        self.assert_fails(4, "shape")
        with synthetic.h5py.File(path, "w") as file:
            file.create_group("VTKHDF")
        self.assert_fails(4, "is not a snapshot")

    def test_broken_case_and_summary(self):
        self.write()
        summary = self.directory / "summary.json"
        for text in ("{", "[1]", '{"first_failure": 3}', '{"steps": 1}'):
            summary.write_text(text)
            self.assert_fails(4, "summary.json is damaged")
        summary.unlink()
        (self.directory / "case.toml").write_text("title = \n")
        self.assert_fails(4, "case.toml is damaged")

    def test_cannot_write(self):
        self.write()
        blocker = self.directory / "blocker"
        blocker.write_text("")
        self.assert_fails(4, "cannot write", self.directory, "-o", blocker / "pictures")


if __name__ == "__main__":
    unittest.main()
