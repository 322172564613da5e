"""Runs rgimp-plot on made-up output directories and looks at the pictures and the errors."""

import subprocess
import tempfile
import unittest
from pathlib import Path

import numpy as np
from matplotlib.image import imread

import synthetic_output as synthetic

PROGRAM = Path(__file__).resolve().parents[2] / "engine/python/rgimp-plot"
PICTURES = ("crack.png", "stress.png", "growth.png", "stress_closure.png", "energy.png")
BLUE, RED, ORANGE, GREY = (0x5b, 0x9b, 0xd5), (0xc0, 0x0d, 0x1e), (0xff, 0xab, 0x00), (0x4d,) * 3
TENSION, SHEAR = 1, 2
STEPS = (0, 1000, 2000, 3000)


def run(*arguments):
    return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True,
                          timeout=120)


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

    # Pictures

    def test_writes_and_lists_every_picture(self):
        self.write(TENSION)
        listed = self.draw().stdout.split()
        self.assertEqual(listed, [str(self.picture(name)) for name in PICTURES])
        for name in PICTURES:
            self.assertGreater(len(np.unique(pixels(self.picture(name)))), 3, name)

    def test_tension_is_red(self):
        self.write(TENSION)
        self.draw()
        self.assertGreater(count(self.picture("crack.png"), RED), 100)
        self.assertGreater(count(self.picture("growth.png"), RED), 100)
        self.assertEqual(count(self.picture("crack.png"), ORANGE), 0)

    def test_shear_is_orange(self):
        self.write(SHEAR)
        self.draw()
        self.assertGreater(count(self.picture("crack.png"), ORANGE), 100)
        self.assertGreater(count(self.picture("growth.png"), ORANGE), 100)
        self.assertEqual(count(self.picture("crack.png"), RED), 0)

    def test_nothing_failed_is_all_blue(self):
        self.write()
        self.draw()
        for name in ("crack.png", "growth.png"):
            self.assertGreater(count(self.picture(name), BLUE), 10000, name)
            self.assertEqual(count(self.picture(name), RED), 0, name)
            self.assertEqual(count(self.picture(name), ORANGE), 0, name)

    def test_particles_fill_the_block_and_leave_the_hole_out(self):
        self.write()
        self.draw()
        blue = (pixels(self.picture("crack.png")) == BLUE).all(axis=2)
        tall = blue.sum(axis=1) > 50  # rows of the block, not of the legend
        block = blue[tall][:, blue[tall].any(axis=0)]
        self.assertAlmostEqual(block.shape[0] / block.shape[1], 2.0, delta=0.03)
        expected = 1 - np.pi * 2.0 ** 2 / (10 * 20)  # no gaps between particles
        self.assertAlmostEqual(block.mean(), expected, delta=0.01)
        self.assertFalse(block[block.shape[0] // 2, block.shape[1] // 2])

    def test_step_chooses_the_snapshot(self):
        self.write(TENSION)
        self.draw("--step", 1000)
        self.assertEqual(count(self.picture("crack.png"), RED), 0)
        self.assertLess(count(self.picture("stress.png"), GREY), 50)  # but in letters
        self.draw("--step", 3000)
        self.assertGreater(count(self.picture("crack.png"), RED), 100)
        self.assertGreater(count(self.picture("stress.png"), GREY), 100)

    def test_stress_is_of_the_eve_of_failure_and_red_in_tension(self):
        self.write(TENSION, steps=(0, 1000, 3000))
        self.draw()
        stress = pixels(self.picture("stress.png"))
        self.assertLess(count(self.picture("stress.png"), GREY), 50)  # but in letters
        height, width, _ = stress.shape
        upper, lower = stress[height // 5, width // 2], stress[3 * height // 4, width // 2]
        self.assertGreater(upper[0], upper[2])  # tension above, red
        self.assertLess(lower[0], lower[2])

    def test_stress_of_a_specimen_at_rest_gives_way_to_the_next(self):
        self.write(TENSION, steps=(0, 3000))
        self.draw()
        self.assertGreater(count(self.picture("stress.png"), GREY), 100)

    def test_growth_prefers_the_listed_steps(self):
        self.write(TENSION, snapshot_steps=[2000])
        self.draw()
        three = pixels(self.picture("growth.png")).shape[1]
        self.write(TENSION, snapshot_steps=[1000, 2000])
        self.draw()
        self.assertGreater(pixels(self.picture("growth.png")).shape[1], three)

    def test_growth_has_at_most_six_panels(self):
        self.write(steps=tuple(range(0, 2000, 100)))
        self.draw()
        blue = (pixels(self.picture("growth.png")) == BLUE).all(axis=2)
        row = blue[blue.shape[0] // 3].astype(int)  # above the hole
        self.assertEqual(int((np.diff(row) == 1).sum()), 6)

    def test_one_snapshot_and_one_row(self):
        self.write(steps=(0,))
        self.draw()
        self.assertTrue(self.picture("energy.png").exists())

    def test_a_run_that_has_not_ended(self):
        self.write(TENSION)
        (self.directory / "summary.json").unlink()
        self.draw()
        self.assertGreater(count(self.picture("crack.png"), RED), 100)

    def test_one_particle(self):
        self.position = np.array([[0.0, 0.0]])
        self.write(steps=(0, 1000))
        self.draw()
        self.assertGreater(count(self.picture("crack.png"), BLUE), 1000)

    def test_fragments_do_not_shrink_the_specimen(self):
        self.write()
        flown = self.position.copy()
        flown[0] = (5.0, 5.0)
        synthetic.write_snapshot(self.directory, 3000, flown)
        self.draw()
        self.assertGreater(count(self.picture("crack.png"), BLUE), 10000)

    def test_damping_is_named_in_the_small_print(self):
        self.write(damping=0.0)
        self.draw()
        plain = pixels(self.picture("stress_closure.png"))[-12:]
        self.write(damping=0.7)
        self.draw()
        damped = pixels(self.picture("stress_closure.png"))[-12:]
        self.assertEqual(int((plain < 200).sum()), 0)
        self.assertGreater(int((damped < 200).sum()), 100)

    def test_output_and_dpi(self):
        self.write()
        self.draw()
        other = self.directory.parent / "deep" / "er"
        result = run(self.directory, "-o", other, "--dpi", 160)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(pixels(other / "energy.png").shape[0],
                         2 * pixels(self.picture("energy.png")).shape[0])

    # Errors

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

    def test_three_dimensions(self):
        self.write(dimension=3)
        self.assert_fails(2, "three-dimensional")

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
