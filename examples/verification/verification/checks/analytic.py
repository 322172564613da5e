"""Closed-form answers."""

from .. import table
from ..registry import check
from ..table import Row

ORDER = 10

MODULUS, POISSON = 17e9, 0.14
HEIGHT = 10e-3

BLOCK = """
title = "a slipping block, compressed slowly"
[grid]
cell_size = 0.5e-3
[[body]]
shape = "box"
center = [0.0, 0.0]
size = [5e-3, 10e-3]
material = "rock"
[material.rock]
density = 2600.0
youngs_modulus = 17e9
poisson_ratio = 0.14
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


@check("analytic", title="Closed-form answers", minutes=0.1, short=True)
def analytic(study, short):
    """A block between slipping platens."""
    run = study.run("block", BLOCK)
    last = {name: column[-1] for name, column in run.history.items()}
    yield Row("slipping block", "plane-strain modulus", "GPa",
              last["axial_stress_Pa"] * HEIGHT / last["closure_m"] * 1e-9,
              MODULUS / (1.0 - POISSON**2) * 1e-9, "E / (1 - nu²)", 0.002, table.RELATIVE)
