"""What the tests of rgimp-plot share: made-up output directories, running it, reading pictures."""

import contextlib
import importlib.machinery
import importlib.util
import io
import sys
import tempfile
import unittest
import warnings
from collections import namedtuple
from pathlib import Path
from unittest import mock

import numpy as np
from matplotlib.image import imread

import synthetic_output as synthetic

PROGRAM = Path(__file__).resolve().parents[2] / "engine/python/rgimp-plot"
PICTURES = ("crack.png", "stress.png", "growth.png", "stress_closure.png", "energy.png")
BLUE, RED, ORANGE, GREY = (0x5b, 0x9b, 0xd5), (0xc0, 0x0d, 0x1e), (0xff, 0xab, 0x00), (0x4d,) * 3
TENSION, SHEAR = 1, 2
STEPS = (0, 1000, 2000, 3000)
Finished = namedtuple("Finished", "returncode stdout stderr")


def load_program(path):
    sys.path.insert(0, str(path.parent))
    loader = importlib.machinery.SourceFileLoader(path.name.replace("-", "_") + "_program",
                                                  str(path))
    program = importlib.util.module_from_spec(
        importlib.util.spec_from_loader(loader.name, loader))
    loader.exec_module(program)
    return program


MAINS = {}  # program -> its main function


def run(*arguments, program=PROGRAM):
    """Runs a program in this process: starting Python and matplotlib takes most of its time."""
    if program not in MAINS:
        MAINS[program] = load_program(program).main
    out, err = io.StringIO(), io.StringIO()
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err), \
            mock.patch.object(sys, "argv", [str(program), *map(str, arguments)]), \
            warnings.catch_warnings():
        warnings.simplefilter("always")  # each test sees its own
        try:
            code = MAINS[program]()
        except SystemExit as stop:  # argparse
            code = stop.code
    return Finished(code, out.getvalue(), err.getvalue())


def pixels(path):
    return (imread(path)[:, :, :3] * 255).round().astype(int)


def count(path, colour):
    return int((pixels(path) == colour).all(axis=2).sum())


class PlotTest(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.directory = Path(temporary.name) / "out"
        self.position = synthetic.lattice()

    def write(self, mode=0, steps=STEPS, stress=1e6, **case):
        """A block that cracks along a column of particles in step 2000, if `mode` says how."""
        synthetic.write_case(self.directory, **case)
        cracked = (np.abs(self.position[:, 0]) < synthetic.PITCH) & (self.position[:, 1] > 2e-3)
        gradient = stress * self.position[:, 1] / 10e-3
        for step in steps:
            failed = np.where(cracked & (step >= 2000), mode, 0)
            synthetic.write_snapshot(self.directory, step, self.position, failed,
                                     np.where(failed > 0, 2000, -1), gradient * step / 3000)
        failures = int(cracked.sum()) if steps[-1] >= 2000 else 0
        synthetic.write_history(self.directory, steps, failures * (mode == TENSION),
                                failures * (mode == SHEAR))
        first = {"step": 2000, "mode": mode} if failures and mode else None
        synthetic.write_summary(self.directory, first)

    def draw(self, *arguments):
        result = run(self.directory, "--dpi", 80, *arguments)
        self.assertEqual(result.stderr, "")
        self.assertEqual(result.returncode, 0)
        return result

    def picture(self, name):
        return self.directory / "pictures" / name

    def assert_fails(self, code, message, *arguments):
        result = run(*(arguments or [self.directory]))
        self.assertEqual(result.returncode, code, result.stderr)
        self.assertIn("rgimp-plot: error: ", result.stderr)
        self.assertIn(message, result.stderr)
        self.assertNotIn("Traceback", result.stderr)
