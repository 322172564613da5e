"""Closed-form answers."""

from math import cos, radians, sin

import numpy as np

from .. import fields, table
from ..finite_elements import FAILURE, MATERIAL, Loading
from ..disks import hondros_centre, michell_centre
from ..registry import check
from ..table import Row

ORDER = 10

MODULUS, POISSON = 17e9, 0.14
COHESION, FRICTION_ANGLE, TENSILE_STRENGTH = 5.95e6, radians(40.0), 2e6
HEIGHT = 10e-3
DIAMETER = 40e-3
HALF_WIDTHS = (1e-3, 2e-3, 3e-3)
SHORT_CELL, CELL = 0.5e-3, 0.25e-3

BODY = f"""
title = "a slipping block, loaded slowly"
[grid]
cell_size = 0.5e-3
[[body]]
shape = "box"
center = [0.0, 0.0]
size = [5e-3, {HEIGHT}]
material = "rock"
{MATERIAL}"""
BLOCK = BODY + """
[[platen]]
side = "top"
speed = 0.01
ramp = 2e-5
[[platen]]
side = "bottom"
speed = 0.01
ramp = 2e-5
[time]
steps = 6000
step_factor = 0.4
[damping]
local = 0.7
"""
DISK = f"""
title = "an intact disk between short platens"
[grid]
cell_size = {{cell!r}}
[[body]]
shape = "disk"
center = [0.0, 0.0]
size = {DIAMETER}
material = "rock"
{MATERIAL}"""
# Slow enough for waves to leave the strength alone: the block takes 4 us to cross.
PRESS = Loading(ramp=4e-5, duration=8e-4, speed=0.01, step_factor=0.4, damping=0.7)
PULL = Loading(ramp=4e-5, duration=2e-4, speed=-0.004, step_factor=0.4, damping=0.7)


@check("analytic", title="Closed-form answers", minutes=0.3, short=True)
def analytic(study, short):
    """A block between slipping platens, elastic and until it fails, and the centre of an intact
    disk under three widths of contact. Platens press along y, which Michell's solution does too and
    Hondros's, radial, does not: the wider the contact the more they differ."""
    yield from modulus(study)
    yield from strength(study)
    if short:
        yield from disk(study, SHORT_CELL, HALF_WIDTHS[0])
        return
    for half_width in HALF_WIDTHS:
        yield from disk(study, CELL, half_width)


def modulus(study):
    run = study.run("block", BLOCK)
    last = {name: column[-1] for name, column in run.history.items()}
    stress = run.snapshot()["stress"].mean(axis=0)
    yield Row("slipping block", "plane-strain modulus", "GPa",
              last["axial_stress_Pa"] * HEIGHT / last["closure_m"] * 1e-9,
              MODULUS / (1.0 - POISSON**2) * 1e-9, "E / (1 − ν²)", 0.002, table.RELATIVE)
    yield Row("slipping block", "σ_zz / σ_yy", "1", stress[fields.ZZ] / stress[fields.YY], POISSON,
              "ν, plane strain", 0.002, table.RELATIVE)


def strength(study):
    compression = 2.0 * COHESION * cos(FRICTION_ANGLE) / (1.0 - sin(FRICTION_ANGLE))
    for name, loading, sign, expected, source in (
            ("pressed", PRESS, 1.0, compression, "2c·cos φ / (1 − sin φ)"),
            ("pulled", PULL, -1.0, TENSILE_STRENGTH, "σ_t")):
        run = study.run(name, BODY + FAILURE + loading.text())
        first = run.summary["first_failure"]
        yield Row(f"block, {name}", "axial stress at the first failure", "MPa",
                  sign * first["axial_stress_Pa"] * 1e-6 if first else np.nan, expected * 1e-6,
                  source, 0.015, table.RELATIVE)


def disk(study, cell, half_width):
    run = study.run(f"disk_{cell * 1e6:.0f}um_{half_width * 1e3:g}mm",
                    DISK.format(cell=cell) + Loading().text(half_width))
    force = run.history["reaction_N"][-1]
    snapshot = run.snapshot()
    near = np.all(np.abs(snapshot["position"][:, :2]) < SHORT_CELL, axis=1)
    stress = snapshot["stress"][near].mean(axis=0)
    case = f"intact disk, L = {cell * 1e3:g} mm, contact {2e3 * half_width:g} mm"
    nominal = 2.0 * force / (np.pi * DIAMETER)
    for centre, source in ((hondros_centre, "Hondros 1959, uniform radial pressure"),
                           (michell_centre, "Michell, uniform vertical pressure")):
        across, along = centre(force, DIAMETER, half_width)
        yield Row(case, "centre stress across the load", "2P/(πD)", stress[fields.XX] / nominal,
                  across / nominal, source, 0.01, table.RELATIVE)
        yield Row(case, "centre stress along the load", "2P/(πD)", stress[fields.YY] / nominal,
                  along / nominal, source, 0.01, table.RELATIVE)
