"""Outlines of a case's bodies and flaws in space, from its case.toml."""

from dataclasses import dataclass

import numpy as np

from . import output

AROUND = 72  # segments of a circle


@dataclass
class Outline:
    """Straight pieces, m; each lies between two faces, whose outward normals say which are in view.
    Those of the rims that spheres show to a viewer depend on where that is: they are listed apart."""
    start: np.ndarray  # (n, 3)
    end: np.ndarray
    normals: np.ndarray  # (n, 2, 3)
    spheres: list  # (centre, radius)


def read_outlines(case):
    """Of the bodies and of the flaws. A case that lacks what they need is damaged."""
    try:
        bodies = [outline_of_body(body) for body in case["body"]]
        low, high = bounding_box(bodies)
        flaws = [outline_of_flaw(flaw, low, high) for flaw in case.get("flaw", [])]
    except (ArithmeticError, AttributeError, KeyError, TypeError, ValueError) as error:
        raise output.OutputError("case.toml is damaged: its bodies or flaws cannot be drawn: "
                                 f"{type(error).__name__} {error}") from None
    return bodies, flaws


def outline_of_body(body):
    center = vector(body["center"])
    if body["shape"] == "box":
        return box(center, np.eye(3), vector(body["size"]) / 2)
    if body["shape"] == "cylinder":
        diameter, height = map(finite, body["size"])
        return cylinder(center, vector(body.get("axis", (0, 1, 0))), diameter / 2, height / 2)
    return sphere(center, finite(body["size"]) / 2)


def outline_of_flaw(flaw, low, high):
    center = vector(flaw["center"])
    if flaw["shape"] == "box":
        return box(center, np.eye(3), vector(flaw["size"]) / 2)
    if flaw["shape"] == "sphere":
        return sphere(center, finite(flaw["length"]) / 2)
    if flaw["shape"] == "penny":
        return cylinder(center, vector(flaw["normal"]), finite(flaw["length"]) / 2,
                        finite(flaw["width"]) / 2)
    return slot(flaw, center, low, high)


def slot(flaw, center, low, high):
    """Without a depth it goes through: from one side of the bodies' bounding box to the other."""
    if "direction" in flaw:
        along, across = unit(vector(flaw["direction"])), unit(vector(flaw["normal"]))
    else:
        angle = np.radians(finite(flaw.get("angle", 0.0)))
        along = np.array([np.cos(angle), np.sin(angle), 0.0])
        across = np.array([-np.sin(angle), np.cos(angle), 0.0])
    through = np.cross(along, across)
    if "depth" in flaw:
        near, far = -finite(flaw["depth"]) / 2, finite(flaw["depth"]) / 2
    else:
        corners = np.where(corner_signs() > 0, high, low) - center
        near, far = (corners @ through).min(), (corners @ through).max()
    half = np.array([finite(flaw["length"]), finite(flaw["width"]), far - near]) / 2
    return box(center + (near + far) / 2 * through, np.array([along, across, through]), half)


def corner_signs():
    return np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)])


def box(center, frame, half):
    """Twelve edges; the rows of `frame` are its axes."""
    start, end, normals = [], [], []
    for axis in range(3):
        one, two = (axis + 1) % 3, (axis + 2) % 3
        for sign_one in (-1, 1):
            for sign_two in (-1, 1):
                middle = center + sign_one * half[one] * frame[one] \
                    + sign_two * half[two] * frame[two]
                start.append(middle - half[axis] * frame[axis])
                end.append(middle + half[axis] * frame[axis])
                normals.append((sign_one * frame[one], sign_two * frame[two]))
    return Outline(np.array(start), np.array(end), np.array(normals), [])


def cylinder(center, axis, radius, half_height):
    """The circles at its ends, and four lines between them."""
    axis = unit(axis)
    one = unit(np.cross(axis, np.eye(3)[np.argmin(np.abs(axis))]))
    angles = np.linspace(0, 2 * np.pi, AROUND + 1)
    rim = np.outer(np.cos(angles), one) + np.outer(np.sin(angles), np.cross(axis, one))
    outwards = (rim[:-1] + rim[1:]) / 2
    start, end, normals = [], [], []
    for side in (-1, 1):
        face = center + side * half_height * axis
        start.append(face + radius * rim[:-1])
        end.append(face + radius * rim[1:])
        normals.append(np.stack([outwards, np.tile(side * axis, (AROUND, 1))], axis=1))
    lines = rim[:-1:AROUND // 4]
    start.append(center - half_height * axis + radius * lines)
    end.append(center + half_height * axis + radius * lines)
    normals.append(np.stack([lines, lines], axis=1))
    return Outline(*map(np.concatenate, (start, end, normals)), [])


def sphere(center, radius):
    return Outline(np.empty((0, 3)), np.empty((0, 3)), np.empty((0, 2, 3)), [(center, radius)])


def bounding_box(outlines):
    points = [np.concatenate([outline.start, outline.end]) for outline in outlines]
    points += [center + np.array([[-radius] * 3, [radius] * 3])
               for outline in outlines for center, radius in outline.spheres]
    points = np.concatenate(points)
    return points.min(axis=0), points.max(axis=0)


def vector(numbers):
    result = np.array(numbers, float)
    if result.shape != (3,) or not np.isfinite(result).all():
        raise ValueError(f"{numbers} is no vector of three numbers")
    return result


def unit(direction):
    length = np.linalg.norm(direction)
    if not length > 0:
        raise ValueError("a direction of no length")
    return direction / length


def finite(number):
    if not np.isfinite(float(number)):
        raise ValueError(f"{number} is not finite")
    return float(number)
