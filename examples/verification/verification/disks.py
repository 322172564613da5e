"""The centre of a disk pressed along a diameter, in closed form."""

from math import asin, pi, sin

import numpy as np


def hondros_centre(force, diameter, half_width):
    """Stress (Pa) across and along the load under a uniform *radial* pressure on two arcs.

    `force` (N/m) is the pressure's resultant, `half_width` (m) that of the chord under an arc.
    Hondros, Aust. J. Appl. Sci. 10 (1959) 243-268, at r = 0: (2p/pi)(sin 2a - a) and
    -(2p/pi)(sin 2a + a), with a the half angle of an arc and p = force/(diameter sin a).
    """
    angle = asin(2.0 * half_width / diameter)
    pressure = force / (diameter * sin(angle))
    return (2.0 / pi * pressure * (sin(2.0 * angle) - angle),
            -2.0 / pi * pressure * (sin(2.0 * angle) + angle))


def michell_centre(force, diameter, half_width):
    """As `hondros_centre`, under a *vertical* pressure, uniform over the width.

    Michell's disk under two opposed forces F along a chord, whose ends are an angle b off the
    diameter (Timoshenko & Goodier, Theory of Elasticity, art. 41), has at its centre
    F cos b (1 - 4 sin2 b)/(pi R) and F cos b (1 - 4 cos2 b)/(pi R); here its mean over chords.
    """
    points, weights = np.polynomial.legendre.leggauss(8)
    sine2 = (2.0 * half_width / diameter * points)**2
    cosine = np.sqrt(1.0 - sine2)
    scale = 2.0 * force / (pi * diameter) * 0.5 * weights
    return (float(scale @ (cosine * (1.0 - 4.0 * sine2))),
            float(scale @ (cosine * (4.0 * sine2 - 3.0))))
