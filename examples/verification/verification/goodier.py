"""A spherical hole in an infinite solid under tension along y, in closed form.

Goodier, J. Appl. Mech. 1 (1933) 39-44; Timoshenko & Goodier, Theory of Elasticity, art. 137. The
hole adds, to the tension S, displacements of the harmonic functions A / r + B d2(1/r)/dy2 and
C d(1/r)/dy (Papkovich and Neuber), whose three constants free its surface of traction.
"""

import numpy as np


def axial_stress(distance, cosine, ratio):
    """Stress along y over S at `distance` radii from the centre (>= 1), in a direction whose angle
    to y has `cosine`, in a solid of Poisson's ratio `ratio`; arrays or numbers."""
    scale = 2.0 * (7.0 - 5.0 * ratio)
    square = cosine**2
    second = (3.0 * square - 1.0) / distance**3           # d2(1/r)/dy2
    third = (9.0 - 15.0 * square) * square / distance**3  # y d3(1/r)/dy3
    fourth = (105.0 * square**2 - 90.0 * square + 9.0) / distance**5
    return 1.0 + ((6.0 - 5.0 * ratio - 10.0 * (1.0 - ratio)) * second + 5.0 * third
                  + fourth) / scale


def concentration(ratio):
    """Of the stress along y at the equator: (27 - 15 nu) / (2 (7 - 5 nu))."""
    return (27.0 - 15.0 * ratio) / (2.0 * (7.0 - 5.0 * ratio))


def equator(distance, ratio):
    """`axial_stress` in the plane across y, as the books have it."""
    scale = 2.0 * (7.0 - 5.0 * ratio)
    return 1.0 + (4.0 - 5.0 * ratio) / scale / distance**3 + 9.0 / scale / distance**5


def section_mean(half_edge, ratio, points=2000):
    """Mean of the stress along y over S in the square |x|, |z| < `half_edge` radii of the plane
    y = 0, the hole counted as nothing: what of S a section of that size carries."""
    middle = (np.arange(points) + 0.5) * half_edge / points
    distance = np.hypot(*np.meshgrid(middle, middle))
    return float(np.where(distance > 1.0, equator(np.maximum(distance, 1.0), ratio), 0.0).mean())
