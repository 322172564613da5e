"""The finite element references: reading them, and their cases for RGIMP."""

import gzip
import json
from dataclasses import dataclass
from functools import cached_property
from math import radians, sin

import numpy as np

from .study import REFERENCES

SOURCE = "finite elements, `reference/{}`"
CELL = 0.5e-3  # m, of the grid that field.csv is on

MATERIAL = """
[material.rock]
density = 2600.0
youngs_modulus = 17e9
poisson_ratio = 0.14
"""
FAILURE = """
[material.rock.failure]
criterion = "mohr-coulomb"
cohesion = 5.95e6
friction_angle = 40.0
tensile_strength = 2e6
"""


@dataclass(frozen=True)
class Loading:
    """Both platens close at `speed` (m/s) each, after a smooth ramp (s), for `duration` (s).

    No damping: Cundall's acts against the velocity, which platens that keep moving never let reach
    zero. With it the reaction of example 1 still was 0.15 % off after ten wave transits, without
    0.02 % after the same time (L = 0.5 mm; against ten times slower loading).
    """
    ramp: float = 2e-4
    duration: float = 3.5e-4
    speed: float = 0.02
    step_factor: float = 0.8
    damping: float = 0.0

    def text(self, half_width=None):
        contact = "" if half_width is None else f"half_width = {half_width!r}\n"
        platens = "".join(f'[[platen]]\nside = "{side}"\nspeed = {self.speed!r}\n'
                          f"ramp = {self.ramp!r}\n{contact}" for side in ("top", "bottom"))
        return (f"{platens}[time]\nduration = {self.duration!r}\n"
                f"step_factor = {self.step_factor!r}\n[damping]\nlocal = {self.damping!r}\n"
                "[output]\nhistory_every = 10\n")


class Reference:
    """One folder of `reference/`; lengths in m, forces in N/m, stresses as fractions of `nominal`."""

    def __init__(self, name):
        self.name = name
        self.folder = REFERENCES / name
        self.meta = json.loads((self.folder / "meta.json").read_text(encoding="utf-8"))
        self.body = self.meta["body"]
        self.source = SOURCE.format(name)
        self.closure = self.meta["reaction"]["delta_mm"] * 1e-3
        self.reaction = self.meta["reaction"]["P_N"] * 1e3
        self.is_disk = self.body["kind"] == "disk"
        self.size = ([self.body["diameter_mm"] * 1e-3] * 2 if self.is_disk else
                     [self.body["width_mm"] * 1e-3, self.body["height_mm"] * 1e-3])

    @cached_property
    def field(self):
        """Columns of field.csv by name; `x`, `y` in m."""
        with gzip.open(self.folder / "field.csv.gz", "rt", encoding="utf-8") as lines:
            names = next(line for line in lines if not line.startswith("#")).strip().split(",")
            values = np.loadtxt(lines, delimiter=",", unpack=True)
        columns = dict(zip(names, values))
        return {"x": columns.pop("x_mm") * 1e-3, "y": columns.pop("y_mm") * 1e-3, **columns}

    def nominal(self, reaction):
        """P/W, or 2P/(pi D) of a disk; of a reaction in N/m, in Pa."""
        return (2.0 / np.pi if self.is_disk else 1.0) * reaction / self.size[0]

    @property
    def half_width(self):
        """Of the platens' contact, m; None over the whole end."""
        if not self.is_disk:
            return None
        return 0.5 * self.size[0] * sin(radians(0.5 * self.body["contact_arc_deg"]))

    @property
    def slot_width(self):
        return self.body["flaws"][0]["width_mm"] * 1e-3

    @property
    def tips(self):
        """(name, diameter, centre, mean of s1) of every circle, in m."""
        for name, peaks in self.meta["tip_peaks"]["values"].items():
            for diameter in (0.5, 1.0):
                circle = peaks[f"circle_{diameter}mm"]
                yield (name, diameter * 1e-3, (circle["x_mm"] * 1e-3, circle["y_mm"] * 1e-3),
                       circle["sigma1_norm"])

    def case(self, cell, loading, failure="", half_width=None):
        """TOML text at a cell size (m)."""
        shape = (f'shape = "disk"\nsize = {self.size[0]!r}' if self.is_disk else
                 f'shape = "box"\nsize = {self.size!r}')
        flaws = "".join(
            f'[[flaw]]\nshape = "slot"\ncenter = {[1e-3 * value for value in flaw["centre_mm"]]}\n'
            f'length = {1e-3 * flaw["length_tip_to_tip_mm"]!r}\nwidth = {1e-3 * flaw["width_mm"]!r}\n'
            f'angle = {float(flaw["angle_deg_from_horizontal"])!r}\nends = "round"\n'
            for flaw in self.body["flaws"])
        return (f'title = "{self.name}"\n[grid]\ncell_size = {cell!r}\n[[body]]\n{shape}\n'
                f'center = [0.0, 0.0]\nmaterial = "rock"\n{flaws}{MATERIAL}{failure}'
                f"{loading.text(half_width or self.half_width)}")

    def clear(self, x, y):
        """Of a point (m): more than 1 mm from slots, and 5 mm from platens (disks: 6 mm from the
        contacts' centres, as the reference's own rule has it)."""
        half = 0.5 * self.size[1]
        apart = (np.minimum(np.hypot(x, y - half), np.hypot(x, y + half)) > 6e-3 if self.is_disk
                 else np.abs(y) < half - 5e-3)
        for flaw in self.body["flaws"]:
            apart &= distance_to_slot(x, y, flaw) > 1e-3
        return apart


def distance_to_slot(x, y, flaw):
    """m, of points to a slot with round ends; negative inside."""
    center = 1e-3 * np.asarray(flaw["centre_mm"])
    angle = radians(flaw["angle_deg_from_horizontal"])
    radius = 0.5e-3 * flaw["width_mm"]
    reach = 0.5e-3 * flaw["length_tip_to_tip_mm"] - radius
    along = (x - center[0]) * np.cos(angle) + (y - center[1]) * np.sin(angle)
    across = (y - center[1]) * np.cos(angle) - (x - center[0]) * np.sin(angle)
    return np.hypot(along - np.clip(along, -reach, reach), across) - radius
