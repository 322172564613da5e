"""Averages of particles' stress, and how far two fields are apart."""

from dataclasses import dataclass

import numpy as np

XX, YY, ZZ, XY = 0, 1, 2, 3  # components of a snapshot's stress


def principal(stress):
    """The larger and the smaller in-plane principal stress of tensors (n, 6)."""
    middle = 0.5 * (stress[:, XX] + stress[:, YY])
    radius = np.hypot(0.5 * (stress[:, XX] - stress[:, YY]), stress[:, XY])
    return middle + radius, middle - radius


@dataclass(frozen=True)
class CellMeans:
    """Mean stress tensors of square cells; `solid` is the part of a cell that particles fill."""
    x: np.ndarray  # of the cells' centres, m
    y: np.ndarray
    stress: np.ndarray  # Pa, (n, 6)
    solid: np.ndarray


def cell_means(snapshot, spacing, size, offset=(0.0, 0.0)):
    """Means over cells of `size` (m), of particles `spacing` apart.

    A line of cells' edges passes through `offset`. Particles of one lattice have one volume, but
    for strains of 1e-3, so that a plain mean is the one weighted with volume.
    """
    cells = np.floor((snapshot["position"][:, :2] - offset) / size).astype(int)
    unique, cell_of, count = np.unique(cells, axis=0, return_inverse=True, return_counts=True)
    cell_of = cell_of.reshape(-1)
    stress = np.stack([np.bincount(cell_of, weights=column) / count
                       for column in snapshot["stress"].T], axis=1)
    center = (unique + 0.5) * size + offset
    return CellMeans(center[:, 0], center[:, 1], stress, count * (spacing / size)**2)


def circle_mean(snapshot, center, diameter):
    """Mean of the larger in-plane principal stress over a circle, Pa."""
    apart = np.hypot(*(snapshot["position"][:, :2] - center).T)
    return principal(snapshot["stress"][apart < 0.5 * diameter])[0].mean()


def look_up(x, y, values, size, at_x, at_y):
    """`values` of the cells around points; nan where there is no cell."""
    def key(first, second):
        return list(zip(np.floor(first / size).astype(int), np.floor(second / size).astype(int)))
    known = dict(zip(key(x, y), values))
    return np.array([known.get(cell, np.nan) for cell in key(at_x, at_y)])


@dataclass(frozen=True)
class Agreement:
    """Of a field with its reference: `slope` of the line through zero, root mean square of the
    difference by that of the reference, and correlation."""
    slope: float
    relative_rms: float
    correlation: float

    def __str__(self):
        return (f"slope {self.slope:.3f}, RMS {100 * self.relative_rms:.1f} %, "
                f"correlation {self.correlation:.4f}")


def agreement(field, reference):
    square = float(reference @ reference)
    return Agreement(float(field @ reference) / square,
                     float(np.sum((field - reference)**2) / square)**0.5,
                     float(np.corrcoef(field, reference)[0, 1]))


def observed_order(sizes, errors):
    """Slope of log |error| over log size, fitted."""
    return float(np.polyfit(np.log(sizes), np.log(np.abs(errors)), 1)[0])
