"""rgimp check --picture: the specimen drawn before anything is computed."""

import os
import shutil
import subprocess
import sys
import unittest
from pathlib import Path

import numpy
from matplotlib.image import imread

from command_test import CASE, COMMAND, FILE_TROUBLE, PHYSICS_STOPPED, WRONG_REQUEST, CommandTest

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "engine/python"))
from rgimp_plot import specimen_views as views  # noqa: E402

SLOT = """
[[flaw]]
shape = "slot"
center = [0.0, 0.0]
length = 3e-3
width = 1.5e-3
angle = 30.0
"""
SECOND = """
[[body]]
shape = "disk"
center = [8e-3, 0.0]
size = 5e-3
material = "steel"
velocity = [-1.0, 0.0]
[material.steel]
density = 7800.0
youngs_modulus = 210e9
poisson_ratio = 0.3
"""
IN_SPACE = CASE.replace("dimension = 2", "dimension = 3").replace(
    "center = [0.0, 0.0]", "center = [0.0, 0.0, 0.0]").replace(
    "size = [5e-3, 10e-3]", "size = [5e-3, 10e-3, 5e-3]") + """
[[flaw]]
shape = "penny"
center = [0.0, 0.0, 0.0]
length = 3e-3
width = 1.5e-3
normal = [0.0, 1.0, 0.0]
"""


class PictureTest(CommandTest):
    def setUp(self):
        super().setUp()
        self.scratch = self.place / "scratch"
        self.scratch.mkdir()

    def draw(self, text, *arguments):
        self.case.write_text(text, encoding="utf-8")
        result = self.rgimp("check", self.case, "--picture", "specimen.png", *arguments,
                            TMPDIR=str(self.scratch))
        self.assertEqual(result.stderr, "")
        self.assertEqual(os.listdir(self.scratch), [])
        self.assertEqual(sorted(os.listdir(self.place)),
                         ["block.toml", "scratch", "specimen.png"])
        self.pixels = (imread(self.place / "specimen.png")[:, :, :3] * 255).round().astype(int)
        return result

    def count(self, colour):
        wanted = [int(colour[i:i + 2], 16) for i in (1, 3, 5)]
        return int(numpy.count_nonzero((self.pixels == wanted).all(axis=2)))

    def test_particles_flaw_and_platens(self):
        self.assertIn("specimen.png", self.draw(CASE + SLOT).stdout)
        with_flaw = self.count(views.MATERIALS[0])
        self.assertGreater(self.count(views.FLAW), 300)
        # Two bars as wide as the block, a fiftieth of the grid's 15 mm high: 6 % of the block.
        self.assertAlmostEqual(self.count(views.PLATEN) / with_flaw, 0.06 / 0.64 / 0.91,
                               delta=0.03)
        self.draw(CASE)
        # The flaw takes 4.5 of the block's 50 mm2.
        self.assertAlmostEqual(with_flaw / self.count(views.MATERIALS[0]), 0.91, delta=0.02)
        self.assertEqual(self.count(views.MATERIALS[1]), 0)

    def test_materials_have_colours_of_their_own(self):
        self.draw(CASE + SECOND, "--set", "platen=[]")
        block, disk = (self.count(colour) for colour in views.MATERIALS[:2])
        self.assertAlmostEqual(disk / block, numpy.pi * 2.5**2 / 50, delta=0.03)
        self.assertEqual(self.count(views.FLAW), 0)

    def test_odd_names(self):
        """Of a material: no formula, and not left out for its underscore."""
        for name in ("_$\\frac{1$", "x" * 500):
            self.draw(CASE.replace('"rock"', f"'{name}'").replace("material.rock",
                                                                  f"material.'{name}'"))
            self.assertGreater(self.count(views.MATERIALS[0]), 10000)

    def test_three_dimensions(self):
        self.draw(IN_SPACE)
        self.assertGreater(self.count(views.MATERIALS[0]), 20000)
        self.assertGreater(self.count(views.FLAW), 100)
        self.assertGreater(self.pixels.shape[1], self.pixels.shape[0])

    def test_it_is_drawn_before_any_step(self):
        result = self.rgimp("check", self.case, "--picture", "specimen.png",
                            "--set", "body[0].velocity=[6000.0, 0.0]",
                            "--set", "platen[0].speed=-1e6", code=PHYSICS_STOPPED)
        self.assertIn("picture", result.stdout)
        self.assertTrue((self.place / "specimen.png").exists())

    def test_json_alone_on_stdout(self):
        self.assertTrue(self.draw(CASE, "--json").stdout.startswith("{"))

    def test_wrong_requests(self):
        self.fail_with(WRONG_REQUEST, "check", self.case, "--picture", "specimen.jpg",
                       says=["--picture", ".png"])
        result = self.rgimp("check", self.case, "--picture", "block.toml/x.png", code=FILE_TROUBLE,
                            TMPDIR=str(self.scratch))
        self.assertIn("block.toml/x.png", result.stderr)
        self.assertNotIn("Traceback", result.stderr)
        self.assertEqual(os.listdir(self.scratch), [])
        self.fail_with(FILE_TROUBLE, "check", self.case, "--picture", "x.png",
                       TMPDIR=str(self.place / "nowhere"))

    def test_without_rgimp_plot_beside_it(self):
        alone = self.place / "alone"
        alone.mkdir()
        shutil.copy(COMMAND, alone / "rgimp")
        done = subprocess.run([alone / "rgimp", "check", self.case, "--picture", "x.png"],
                              cwd=self.place, capture_output=True, text=True)
        self.assertEqual(done.returncode, FILE_TROUBLE)
        self.assertRegex(done.stderr, "rgimp: error: cannot run '.*/alone/rgimp-plot': No such")


if __name__ == "__main__":
    unittest.main()
