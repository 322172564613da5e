"""Runs rgimp-plot on made-up three-dimensional output directories and looks at the pictures."""

import sys
import unittest
from pathlib import Path

import numpy as np

import synthetic_output as synthetic
from plot_test import (BLUE, GREY, ORANGE, PROGRAM, RED, SHEAR, STEPS, TENSION, PlotTest, count,
                       pixels, run)

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "support"))
from hostile_snapshots import HostileSnapshots  # noqa: E402

sys.path.insert(0, str(PROGRAM.parent))
from rgimp_plot import camera, curves, output, shapes  # noqa: E402

PICTURES = ("crack.png", "slices.png", "stress.png", "growth.png", "stress_closure.png",
            "energy.png")
FLAWS = """
[[flaw]]
shape = "slot"
center = [0, 0, 0]
length = 3e-3
width = 1e-3
angle = 45
[[flaw]]
shape = "slot"
center = [0, 0, 0]
length = 3e-3
width = 1e-3
depth = 2e-3
direction = [1, 1, 1]
normal = [1, -1, 0]
[[flaw]]
shape = "penny"
center = [0, 0, 0]
length = 3e-3
width = 1e-3
normal = [0, 0, 2]
[[flaw]]
shape = "sphere"
center = [0, 0, 0]
length = 3e-3
[[flaw]]
shape = "box"
center = [0, 0, 0]
size = [1e-3, 1e-3, 1e-3]
"""
BODIES = """
[[body]]
shape = "cylinder"
center = [0, 0, 0]
size = [5e-3, 10e-3]
[[body]]
shape = "cylinder"
center = [0, 0, 0]
size = [5e-3, 10e-3]
axis = [0, 0, 1]
[[body]]
shape = "sphere"
center = [0, 0, 0]
size = 5e-3
"""


class SpaceTest(HostileSnapshots, PlotTest):
    def setUp(self):
        super().setUp()
        self.position = synthetic.block()

    def write(self, mode=0, moved=0.0, **case):
        """A block whose upper half cracks along the plane x = 0 in step 2000, if `mode` says how,
        with tension above and compression below."""
        synthetic.write_case_in_space(self.directory, **case)
        cracked = (np.abs(self.position[:, 0]) < synthetic.PITCH) & (self.position[:, 1] > 0)
        for step in STEPS:
            failed = np.where(cracked & (step >= 2000), mode, 0)
            synthetic.write_snapshot(self.directory, step, self.position + moved * step / 3000,
                                     failed, np.where(failed > 0, 2000, -1),
                                     1e8 * self.position[:, 1] * step / 3000)
        failures = int(cracked.sum()) * (mode > 0)
        synthetic.write_history(self.directory, STEPS, failures * (mode == TENSION),
                                failures * (mode == SHEAR))
        synthetic.write_summary(self.directory,
                                {"step": 2000, "mode": mode} if failures else None)

    def test_writes_and_lists_every_picture(self):
        self.write(TENSION)
        listed = self.draw().stdout.split()
        self.assertEqual(listed, [str(self.picture(name)) for name in PICTURES])
        for name in PICTURES:
            self.assertGreater(len(np.unique(pixels(self.picture(name)))), 3, name)

    def test_modes_have_the_colours_of_two_dimensions(self):
        for mode, colour, other in ((TENSION, RED, ORANGE), (SHEAR, ORANGE, RED)):
            self.write(mode)
            self.draw()
            self.assertGreater(count(self.picture("slices.png"), colour), 500)
            self.assertGreater(count(self.picture("slices.png"), BLUE), 10000)
            self.assertEqual(count(self.picture("slices.png"), other), 0)
            shaded = pixels(self.picture("growth.png")).reshape(-1, 3)
            faces = [np.round(np.array(colour) * shade) for shade in (0.82, 1.0, 0.91)]
            for face in faces:  # of cubes, normal to x, y and z
                self.assertGreater(int((np.abs(shaded - face).max(axis=1) <= 1).sum()), 50)

    def test_nothing_failed(self):
        self.write()
        self.draw()
        for name in ("slices.png", "growth.png", "crack.png"):
            self.assertEqual(count(self.picture(name), RED), 0, name)
        self.assertGreater(count(self.picture("slices.png"), BLUE), 10000)

    def test_step_chooses_the_snapshot(self):
        self.write(TENSION)
        self.draw("--step", 1000)
        self.assertEqual(count(self.picture("slices.png"), RED), 0)
        self.assertLess(count(self.picture("stress.png"), GREY), 50)  # but in letters
        empty = len(np.unique(pixels(self.picture("crack.png")).reshape(-1, 3), axis=0))
        self.draw("--step", 3000)
        self.assertGreater(count(self.picture("slices.png"), RED), 500)
        self.assertGreater(count(self.picture("stress.png"), GREY), 500)
        self.assertNotEqual(
            empty, len(np.unique(pixels(self.picture("crack.png")).reshape(-1, 3), axis=0)))

    def test_stress_is_red_in_tension(self):
        self.write()
        self.draw("--step", 3000)
        stress = pixels(self.picture("stress.png"))
        height, width, _ = stress.shape
        upper, lower = stress[height // 3, width // 6], stress[3 * height // 4, width // 6]
        self.assertGreater(upper[0], upper[2])
        self.assertLess(lower[0], lower[2])

    def test_slices_lie_where_they_are_asked_for(self):
        self.write(TENSION)
        self.draw("--slices", 0, 2.5, 0)
        through = count(self.picture("slices.png"), RED)
        self.draw("--slices", 2, -2.5, 0)  # only the one across z meets the crack
        beside = count(self.picture("slices.png"), RED)
        self.assertGreater(beside, 100)
        self.assertGreater(through, 4 * beside)
        self.assert_fails(2, "the plane y = 5.1 mm does not cut the specimen, which reaches from "
                             "-5 to 5 mm", self.directory, "--slices", 0, 5.1, 0)
        self.assert_fails(2, "x = nan", self.directory, "--slices", "nan", 0, 0)

    def test_views_show_where_the_particles_were(self):
        self.write(TENSION)
        self.draw()
        still = pixels(self.picture("growth.png"))
        self.write(TENSION, moved=1.0)  # m
        self.draw()
        np.testing.assert_array_equal(pixels(self.picture("growth.png")), still)

    def test_every_body_and_flaw_has_an_outline(self):
        self.write()
        self.draw()
        block = pixels(self.picture("crack.png"))
        self.write(bodies=BODIES, flaws=FLAWS)
        self.draw()
        other = pixels(self.picture("crack.png"))
        self.assertGreater(int((other < 200).sum()), int((block < 200).sum()) + 500)

    def test_cases_that_cannot_be_drawn(self):
        for flaws in ('[[flaw]]\nshape = "penny"\n', FLAWS.replace("[0, 0, 2]", "[0, 0, 0]"),
                      FLAWS.replace("[1, 1, 1]", '"up"'), FLAWS.replace("= 45", "= nan"),
                      FLAWS.replace("[0, 0, 0]", "[0, 0]")):
            self.write(flaws=flaws)
            self.assert_fails(4, "case.toml is damaged")

    def test_particles_that_left_are_counted(self):
        self.write(TENSION)
        synthetic.write_snapshot(self.directory, 3000, self.position[:-100])
        self.draw()
        for name in ("crack.png", "slices.png", "growth.png"):
            bottom = pixels(self.picture(name))[-25:]
            self.assertGreater(int((bottom < 200).sum()), 1500, name)  # small print

    def test_turned_bits(self):
        self.write(TENSION)
        self.snapshot = self.directory / "snapshots" / "step_000003000.vtkhdf"
        self.for_each_turned_bit(4, self.assert_no_traceback)

    def assert_no_traceback(self):
        result = run(self.directory, "--dpi", 40)
        self.assertIn(result.returncode, (0, 4), result.stderr)
        self.assertNotIn("Traceback", result.stderr)

    def test_units(self):
        self.write(TENSION)
        result = output.read(self.directory)
        self.assertEqual(curves.draw_energy(result).axes[0].get_ylabel(), "energy (J)")
        labels = [text.get_text() for text in
                  curves.draw_stress_closure(result).axes[0].get_legend().get_texts()]
        self.assertRegex(labels[-1], r"^peak: .* MPa, .* kN, at ")


class CubesTest(unittest.TestCase):
    VIEW = camera.Camera(30.0, 20.0)

    def test_view_keeps_right_and_up(self):
        front = camera.Camera(0.0, 0.0)
        np.testing.assert_allclose(front.project(np.eye(3)), [[1, 0], [0, 1], [0, 0]], atol=1e-15)
        from_right = camera.Camera(90.0, 0.0)
        np.testing.assert_allclose(from_right.project(np.eye(3)), [[0, 0], [0, 1], [-1, 0]],
                                   atol=1e-15)
        np.testing.assert_allclose(self.VIEW.project(self.VIEW.towards), 0, atol=1e-15)

    def test_faces_in_view(self):
        block = np.stack(np.meshgrid(*[np.arange(3)] * 3), axis=-1).reshape(-1, 3)
        for cells, faces in (([[0, 0, 0]], 3), ([[0, 0, 0], [1, 0, 0]], 5), (block, 27)):
            owners, corners, axes = camera.visible_faces(np.array(cells), self.VIEW)
            self.assertEqual((len(owners), len(corners), len(axes)), (faces,) * 3)
        towards = corners.mean(axis=1).max(axis=0)  # of the block from 0 to 2
        np.testing.assert_allclose(towards, 2.5)

    def test_nearer_cubes_come_later(self):
        cells = np.array([[0, 0, 2], [0, 0, -2], [0, 0, 0]])
        owners, _, _ = camera.visible_faces(cells, self.VIEW)
        self.assertEqual(list(owners), [1, 1, 1, 2, 2, 2, 0, 0, 0])

    def test_a_through_slot_reaches_the_sides(self):
        case = {"body": [{"shape": "box", "center": [0, 0, 1], "size": [4, 4, 6]}],
                "flaw": [{"shape": "slot", "center": [0, 0, 0], "length": 2, "width": 1,
                          "angle": 30}]}
        _, (slot,) = shapes.read_outlines(case)
        np.testing.assert_allclose([slot.start[:, 2].min(), slot.end[:, 2].max()], [-2, 4])


if __name__ == "__main__":
    unittest.main()
