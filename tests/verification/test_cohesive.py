"""The cohesive crack that softening is verified against, against closed forms."""

import sys
import unittest
from pathlib import Path

import numpy as np

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "examples/verification"))

from verification import cohesive  # noqa: E402

MODULUS, ENERGY = 17e9, 1.0


class Cohesive(unittest.TestCase):
    def test_uniform_pressure_opens_an_ellipse(self):
        crack = 8e-3
        edges = np.linspace(0.0, np.pi / 2.0, 101)
        x = crack * np.sin(0.5 * (edges[1:] + edges[:-1]))
        found = cohesive.openings(crack, x, edges, MODULUS).sum(axis=1)
        expected = 4.0 / MODULUS * np.sqrt(crack**2 - x**2)
        self.assertLess(np.abs(found / expected - 1.0).max(), 1e-3)

    def test_a_short_zone_lengthens_the_crack_by_its_known_share(self):
        """0.419 E G / sigma_t^2 with linear softening (Planas and Elices, Eng. Fract. Mech. 1990)."""
        notch, strength = 50e-3, 3e6
        zone = 0.419 * MODULUS * ENERGY / strength**2
        expected = np.sqrt(MODULUS * ENERGY / (np.pi * (notch + zone)))
        found = cohesive.strength(notch, 100.0, MODULUS, strength, ENERGY)
        self.assertAlmostEqual(found / expected, 1.0, delta=0.01)


if __name__ == "__main__":
    unittest.main()
