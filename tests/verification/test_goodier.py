"""The spherical hole's closed form against the books' values."""

import sys
import unittest
from pathlib import Path

import numpy as np

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "examples/verification"))

from verification import goodier  # noqa: E402


class Goodier(unittest.TestCase):
    def test_the_equator_is_that_of_the_books(self):
        distance = np.linspace(1.0, 5.0, 9)
        for ratio in (0.0, 0.14, 0.3, 0.5):
            np.testing.assert_allclose(goodier.axial_stress(distance, 0.0, ratio),
                                       goodier.equator(distance, ratio), rtol=1e-14)
            self.assertAlmostEqual(goodier.equator(1.0, ratio), goodier.concentration(ratio), 14)
        self.assertAlmostEqual(goodier.concentration(0.3), 45.0 / 22.0, 14)

    def test_the_pole_is_free_and_far_away_nothing_changes(self):
        for ratio in (0.0, 0.14, 0.3):
            self.assertAlmostEqual(goodier.axial_stress(1.0, 1.0, ratio), 0.0, 14)
            self.assertAlmostEqual(goodier.axial_stress(1e3, 0.7, ratio), 1.0, 8)

    def test_a_large_section_carries_the_load(self):
        self.assertAlmostEqual(goodier.section_mean(100.0, 0.14), 1.0, 5)
        # What lies beyond a circle of 4 radii carries pi (4 - 5 nu) / (4 (7 - 5 nu)) R² S of it.
        self.assertAlmostEqual(goodier.section_mean(4.0, 0.14), 1.0 - 0.41 / 64.0, 3)


if __name__ == "__main__":
    unittest.main()
