"""Bodies as regions, and the outlines of flaws in the plane; lengths in mm."""

from dataclasses import dataclass

import numpy as np

from . import shapes

AROUND = np.linspace(0, 2 * np.pi, 73)


@dataclass
class Shape:
    low: np.ndarray  # corners of its bounding box
    high: np.ndarray
    distance: object  # (n, d) points -> how far outside they are; negative inside


def of_body(body, dimension):
    center = np.array(body["center"], float)[:dimension] * 1e3
    if body["shape"] == "box":
        half = np.array(body["size"], float)[:dimension] * 1e3 / 2
        return Shape(center - half, center + half,
                     lambda points: (np.abs(points - center) - half).max(axis=1))
    if body["shape"] == "cylinder":
        return cylinder(center, body)
    radius = float(body["size"]) * 1e3 / 2  # of a disk or sphere
    return Shape(center - radius, center + radius,
                 lambda points: np.linalg.norm(points - center, axis=1) - radius)


def cylinder(center, body):
    axis = shapes.unit(shapes.vector(body.get("axis", (0, 1, 0))))
    radius, half = np.array(body["size"], float) * 1e3 / 2
    reach = half * np.abs(axis) + radius * np.sqrt(np.maximum(0.0, 1 - axis ** 2))

    def distance(points):
        along = (points - center) @ axis
        across = np.linalg.norm(points - center - np.outer(along, axis), axis=1)
        return np.maximum(across - radius, np.abs(along) - half)

    return Shape(center - reach, center + reach, distance)


def outline_of_flaw(flaw):
    """Of a flaw in the plane, (n, 2)."""
    center = np.array(flaw["center"], float)[:2] * 1e3
    circle = np.stack([np.cos(AROUND), np.sin(AROUND)], axis=1)
    if flaw["shape"] == "box":
        half = np.array(flaw["size"], float)[:2] * 1e3 / 2
        return center + half * np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]])
    length = float(flaw["length"]) * 1e3
    if flaw["shape"] == "circle":
        return center + length / 2 * circle
    width = float(flaw["width"]) * 1e3
    if flaw.get("ends", "square") == "round":
        ends = np.where(circle[:, :1] >= 0, 1, -1) * np.array([(length - width) / 2, 0])
        outline = width / 2 * circle + ends
    else:
        outline = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]]) * [length / 2, width / 2]
    angle = np.radians(float(flaw.get("angle", 0.0)))
    turn = np.array([[np.cos(angle), np.sin(angle)], [-np.sin(angle), np.cos(angle)]])
    return center + outline @ turn

