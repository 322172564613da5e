"""Runs rgimp-plot on made-up output directories and looks at the pictures."""

import subprocess
import unittest

import numpy as np

import synthetic_output as synthetic
from plot_test import (BLUE, GREY, ORANGE, PICTURES, PROGRAM, RED, SHEAR, TENSION, PlotTest, count,
                       pixels, run)


class PicturesTest(PlotTest):
    def test_writes_and_lists_every_picture(self):
        self.write(TENSION)
        listed = self.draw().stdout.split()
        self.assertEqual(listed, [str(self.picture(name)) for name in PICTURES])
        for name in PICTURES:
            self.assertGreater(len(np.unique(pixels(self.picture(name)))), 3, name)

    def test_program_starts_by_itself(self):
        self.write()
        result = subprocess.run([PROGRAM, self.directory, "--dpi", "40"], capture_output=True,
                                text=True, timeout=120)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assertTrue(self.picture("energy.png").exists())

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

    def test_what_is_not_finite_is_left_out_and_counted(self):
        self.write(TENSION)
        self.draw()
        whole = count(self.picture("crack.png"), BLUE)
        low = self.position[:, 1] < -5e-3  # a quarter of the block
        position, stress = self.position.copy(), np.zeros(len(low))
        position[low & (self.position[:, 0] < 0), 0] = np.nan
        stress[low & (self.position[:, 0] >= 0)] = np.inf
        synthetic.write_snapshot(self.directory, 3000, position, stress=stress)
        self.draw("--step", 3000)
        self.assertAlmostEqual(count(self.picture("crack.png"), BLUE) / whole, 0.75, delta=0.02)
        for name in ("crack.png", "stress.png", "growth.png"):
            bottom = pixels(self.picture(name))[-12:]
            self.assertGreater(int((bottom < 200).sum()), 100, name)  # small print

    def test_particles_that_left_are_counted(self):
        self.write()
        self.draw("--step", 3000)
        whole = count(self.picture("crack.png"), BLUE)
        staying = self.position[self.position[:, 1] >= -5e-3]  # three quarters of the block
        synthetic.write_snapshot(self.directory, 3000, staying)
        self.draw("--step", 3000)
        self.assertAlmostEqual(count(self.picture("crack.png"), BLUE) / whole, 0.75, delta=0.02)
        for name in ("crack.png", "stress.png", "growth.png"):
            bottom = pixels(self.picture(name))[-12:]
            self.assertGreater(int((bottom < 200).sum()), 100, name)  # small print

    def test_nothing_finite_at_the_end(self):
        self.write()
        everywhere = np.full_like(self.position, np.nan)
        synthetic.write_snapshot(self.directory, 3000, everywhere)
        self.draw("--step", 3000)
        self.assertEqual(count(self.picture("crack.png"), BLUE), 0)
        self.assertGreater(count(self.picture("growth.png"), BLUE), 10000)
        synthetic.write_snapshot(self.directory, 0, everywhere)
        self.assert_fails(4, "step 0, has a finite position")

    def test_a_history_that_ends_in_infinity(self):
        self.write()
        with open(self.directory / "history.csv", "a", encoding="utf-8") as file:
            file.write("3001,3e-5,1e-6,inf,nan,inf,nan,inf,0,0,-nan,3,0\n")
        self.draw()

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


if __name__ == "__main__":
    unittest.main()
