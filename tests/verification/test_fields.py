"""Averages of particles, comparisons of fields, and closed forms of disks."""

import sys
import unittest
from math import pi
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "examples/verification"))

from verification import disks, fields, finite_elements  # noqa: E402


class FieldTest(unittest.TestCase):
    def test_principal_stresses_of_a_shear(self):
        larger, smaller = fields.principal(np.array([[1.0, 1.0, 0.0, 3.0, 0.0, 0.0]]))
        self.assertEqual((larger[0], smaller[0]), (4.0, -2.0))

    def test_cells_hold_the_means_of_their_particles(self):
        stress = np.zeros((5, 6))
        stress[:, 0] = [1.0, 2.0, 3.0, 6.0, 9.0]
        position = np.array([[0.25, 0.25], [0.75, 0.25], [0.25, 0.75], [0.75, 0.75], [-0.25, 0.25]])
        means = fields.cell_means({"position": position, "stress": stress}, 0.5, 1.0)
        self.assertEqual(list(means.x), [-0.5, 0.5])
        self.assertEqual(list(means.stress[:, 0]), [9.0, 3.0])
        self.assertEqual(list(means.solid), [0.25, 1.0])
        found = fields.look_up(means.x, means.y, means.stress[:, 0], 1.0, np.array([0.5, 1.5]),
                               np.array([0.5, 0.5]))
        self.assertEqual(found[0], 3.0)
        self.assertTrue(np.isnan(found[1]))

    def test_agreement_and_order(self):
        reference = np.array([1.0, -2.0, 3.0])
        found = fields.agreement(1.1 * reference, reference)
        self.assertAlmostEqual(found.slope, 1.1)
        self.assertAlmostEqual(found.relative_rms, 0.1)
        self.assertAlmostEqual(found.correlation, 1.0)
        self.assertAlmostEqual(fields.observed_order([4.0, 2.0, 1.0], [-0.16, 0.04, 0.01]), 2.0)


class DiskTest(unittest.TestCase):
    def test_narrow_contacts_give_the_point_load_s_answer(self):
        for centre in (disks.hondros_centre, disks.michell_centre):
            across, along = centre(pi / 2.0, 1.0, 1e-4)
            self.assertAlmostEqual(across, 1.0, 6)
            self.assertAlmostEqual(along, -3.0, 6)

    def test_wide_ones_take_stress_off_the_centre(self):
        # To second order in a = 2 half_width/diameter, radial 1 - 7/6 a², vertical 1 - 3/2 a².
        self.assertAlmostEqual(disks.hondros_centre(pi / 2.0, 1.0, 0.05)[0], 1 - 7 / 6 * 0.01, 4)
        self.assertAlmostEqual(disks.michell_centre(pi / 2.0, 1.0, 0.05)[0], 1 - 3 / 2 * 0.01, 4)


class ReferenceTest(unittest.TestCase):
    def test_slots_have_round_ends(self):
        slot = {"centre_mm": [0, 0], "length_tip_to_tip_mm": 10, "width_mm": 2,
                "angle_deg_from_horizontal": 90}
        x, y = 1e-3 * np.array([[0.0, 2.0, 0.0], [7.0, 0.0, 0.0]])
        for found, expected in zip(finite_elements.distance_to_slot(x, y, slot), (2e-3, 1e-3, -1e-3)):
            self.assertAlmostEqual(found, expected, 12)

    def test_reference_of_example_1(self):
        reference = finite_elements.Reference("1_single45_w10_free")
        self.assertEqual(reference.size, [0.05, 0.1])
        self.assertAlmostEqual(reference.nominal(reference.reaction) * 1e-6, 1.6605, 4)
        self.assertEqual(len(reference.field["s1cell"]), 19936)


if __name__ == "__main__":
    unittest.main()
