"""Problems that codes of the particle family are held against, as case files."""

import math

import numpy as np

from .. import table
from ..registry import check
from ..table import Row
from . import community_pictures as pictures

ORDER = 41

SOLID = """
[[body]]
shape = "box"
center = [{x}, {y}]
size = [{width}, {height}]
material = "solid"
[material.solid]
density = {density}
youngs_modulus = {modulus}
poisson_ratio = {poisson}
"""
INVISCID = "[viscosity]\nquadratic = 0.0\nlinear = 0.0\n"

DISCS = """
[grid]
cell_size = {cell}
[[body]]
shape = "disk"
center = [0.2, 0.2]
size = 0.4
material = "solid"
velocity = [0.1, 0.1]
[[body]]
shape = "disk"
center = [0.8, 0.8]
size = 0.4
material = "solid"
velocity = [-0.1, -0.1]
[material.solid]
density = 1000.0
youngs_modulus = 1000.0
poisson_ratio = 0.3
[time]
duration = 3.5
[output]
history_every = 1
""" + INVISCID


@check("discs", title="Two discs (Sulsky, Chen & Schreyer 1994)", minutes=0.1, short=True)
def discs(study, short):
    """Two elastic discs of radius 0.2 m in a box of 1 m, E 1000 Pa, nu 0.3, rho 1000 kg/m3, fly at
    (0.1, 0.1) m/s and (-0.1, -0.1) m/s into each other and part again; cells of 1/20 m, no
    viscosity. Bodies meet on the grid, without a contact law, about a cell too early."""
    distance = math.hypot(0.6, 0.6) - 0.4
    touch = distance / (2.0 * math.hypot(0.1, 0.1))
    for cells in (20,) if short else (20, 40, 80):
        run = study.run(f"cells_{cells}", DISCS.format(cell=1.0 / cells))
        time, kinetic = run.history["time_s"], run.history["kinetic_energy_J"]
        energy = kinetic + run.history["strain_energy_J"]
        case = f"cells of 1/{cells} m"
        least = kinetic.argmin()
        early = touch - time[np.argmax(kinetic < 0.99 * kinetic[0])]
        yield Row(case, "contact too early, in cells' travel", "1",
                  early * 2.0 * math.hypot(0.1, 0.1) * cells, 2.0,
                  "nodes are shared within two cells", kind=table.AT_MOST)
        if not short:
            yield Row(case, "time of least kinetic energy", "s", time[least])
            yield Row(case, "least kinetic energy", "J", kinetic[least])
            yield Row(case, "kinetic energy at the end, of the first", "%",
                      100.0 * kinetic[-1] / kinetic[0])
            yield Row(case, "energy, largest change", "%",
                      100.0 * float(np.abs(energy / energy[0] - 1.0).max()), 0.0, "conservation",
                      2.0, table.ABSOLUTE, "the strain energy is that of small strains, off by "
                      "their size while the discs are pressed")
        yield Row(case, "energy, change at the end", "%", 100.0 * (energy[-1] / energy[0] - 1.0), 0.0,
                  "conservation", 2.0, table.ABSOLUTE)
        end = run.snapshot()
        speed = np.abs(end["velocity"].mean(axis=0)).max() / math.hypot(0.1, 0.1)
        yield Row(case, "momentum at the end, of a disc's", "1", float(speed), 1e-12, "conservation",
                  kind=table.AT_MOST)
        if cells == 20 and not short:
            pictures.draw_discs(study.picture(), run.history)


def column_case(cells):
    size = 50.0 / cells
    solid = SOLID.format(x=size, y=25.0, width=2.0 * size, height=50.0, density=80.0, modulus=1e6,
                         poisson=0.0)
    return f"[grid]\ncell_size = {size}\n{solid}" + """
[[platen]]
side = "bottom"
speed = 0.0
[[platen]]
side = "left"
speed = 0.0
[[platen]]
side = "right"
speed = 0.0
[body_force]
acceleration = [0.0, -9.81]
[damping]
local = 0.3
[time]
duration = 40.0
step_factor = 0.4
"""


@check("column", title="Column under its own weight", minutes=0.1, short=True)
def column(study, short):
    """50 m of E 1 MPa, nu 0, rho 80 kg/m3 (Coombs & Augarde 2020) compacted by g = 9.81 m/s2, to
    rest under local damping, two cells wide between slipping sides, as it buckles without. The Cauchy stress, -rho g (l - Y) at a point once at Y, holds for any
    law, as nu = 0 keeps the width. The settlement does not: our law in one dimension is
    s = E ln F, which gives E/(rho g) (1 - exp(-rho g l / E)) for the length; small strains give
    l - rho g l^2 / (2 E). Large deformation is needed (4 % at the foot)."""
    errors, weight = [], 80.0 * 9.81
    for cells in (8, 16) if short else (8, 16, 32, 64):
        run = study.run(f"cells_{cells}", column_case(cells))
        start, end = run.snapshot(0), run.snapshot()
        place = dict(zip(start["id"], start["position"][:, 1]))
        point = np.array([place[name] for name in end["id"]])
        errors.append(float(np.abs(end["stress"][:, 1] + weight * (50.0 - point)).mean())
                      / (50.0 * weight))
    yield Row(f"{cells} cells", "stress error, mean over rho g l", "1", errors[-1])
    yield Row(f"{cells // 2} to {cells} cells", "order of the stress", "1",
              math.log2(errors[-2] / errors[-1]), 1.0, "first order, of the gradients of linear weights",
              kind=table.AT_LEAST)
    top = point.argmax()
    factor = weight / 1e6
    found = point[top] - end["position"][top, 1]
    at = point[top]
    hencky = at - (math.exp(-factor * (50.0 - at)) - math.exp(-factor * 50.0)) / factor
    yield Row(f"{cells} cells", "settlement of the top", "m", found, hencky, "s = E ln F, our law", 0.01,
              table.RELATIVE)
    yield Row(f"{cells} cells", "settlement off small strains'", "%",
              100.0 * (found / (factor * (50.0 * at - 0.5 * at**2)) - 1.0))


def beam_case(cells, gravity, duration, damping):
    solid = SOLID.format(x=5.0, y=0.5, width=10.0, height=1.0, density=1.0, modulus=1.0, poisson=0.0)
    grid = f"[grid]\ncell_size = {1.0 / cells}\nmin = [-3.0, -13.0]\nmax = [14.0, 5.0]\n"
    return grid + solid + INVISCID + f"""
[[platen]]
side = "left"
speed = 0.0
lateral = "stick"
[body_force]
acceleration = [0.0, -{gravity}]
[damping]
local = {damping}
[time]
duration = {duration}
step_factor = 0.4
[output]
history_every = 20
"""


def swing(time, work):
    """Mean and angular frequency of an oscillation about a mean, by least squares."""
    best = None
    for omega in np.linspace(0.006, 0.014, 801):
        basis = np.column_stack([np.ones_like(time), np.cos(omega * time), np.sin(omega * time)])
        values, _, _, _ = np.linalg.lstsq(basis, work, rcond=None)
        rest = float(((basis @ values - work)**2).sum())
        best = min(best or (rest, 0, 0), (rest, values[0], omega))
    return best[1], best[2]


def elastica(load, length=10.0, points=2000):
    """Centre line (x, y), m, of a cantilever under its weight: theta'' = -load (1 - s) cos theta
    with s over the length, load = q l^3 / (E I); by shooting."""
    s = np.linspace(0.0, 1.0, points + 1)

    def shoot(curvature):
        theta, path = 0.0, [0.0]
        for middle in 0.5 * (s[1:] + s[:-1]):
            half = theta + 0.5 * curvature / points
            change = -load * (1.0 - middle) * math.cos(half) / points
            theta += (curvature + 0.5 * change) / points
            curvature += change
            path.append(theta)
        return curvature, np.array(path)

    low, high = 0.0, load
    for _ in range(50):
        middle = 0.5 * (low + high)
        low, high = (low, middle) if shoot(middle)[0] > 0.0 else (middle, high)
    theta = shoot(low)[1]
    centre = 0.5 * (theta[1:] + theta[:-1])
    return (np.append(0.0, np.cumsum(np.cos(centre))) * length / points,
            -np.append(0.0, np.cumsum(np.sin(centre))) * length / points)


@check("cantilever", title="Cantilever under its own weight", minutes=0.7)
def cantilever(study, short):
    """10 m by 1 m, E 1 Pa, nu 0, rho 1 kg/m3, built in at a sticking platen. Let go under a small
    weight, it swings about its static deflection: mean and period against Timoshenko's beam
    (bending, shear with 5/6, rotary inertia). Under a weight of q l^3 / (E I) = 6 and local
    damping it comes to rest at more than half its length: against the elastica, large rotations but
    strains under a tenth, so that the law of the solid hardly matters."""
    gravity = 1e-6
    mean = gravity**2 * (10.0**5 * 12.0 / 20.0 + 10.0**3 / 3.0 / (5.0 / 6.0 * 0.5))
    bending = 1.8751**2 / 100.0 * math.sqrt(1.0 / 12.0)
    shearing = 0.5 * math.pi / 10.0 * math.sqrt(5.0 / 6.0 * 0.5)
    rotary = 1.0 + 4.648 / 12.0 / 100.0
    period = 2.0 * math.pi * math.sqrt(rotary / bending**2 + 1.0 / shearing**2)
    for cells in (4, 8, 16):
        run = study.run(f"small_{cells}", beam_case(cells, gravity, 1256.0, 0.0))
        work, omega = swing(run.history["time_s"], run.history["external_work_J"])
        yield Row(f"small, {cells} cells across", "mean of the weight's work", "J", work, mean,
                  "Timoshenko, static", 0.02, table.RELATIVE)
        yield Row(f"small, {cells} cells across", "period", "s", 2.0 * math.pi / omega, period,
                  "Timoshenko, first mode", 0.01, table.RELATIVE)
    x, y = elastica(6.0)
    for cells in (4, 8):
        run = study.run(f"large_{cells}", beam_case(cells, 5e-4, 6000.0, 0.3))
        start, end = run.snapshot(0), run.snapshot()
        tip = start["id"][start["position"][:, 0] > 10.0 - 0.5 / cells]
        ends = end["position"][np.isin(end["id"], tip)][:, :2].mean(axis=0)
        reach = 1.0 - 0.25 / cells / 10.0
        yield Row(f"large, {cells} cells across", "drop of the tip", "m", 0.5 - ends[1],
                  -float(np.interp(reach, np.linspace(0.0, 1.0, len(y)), y)), "elastica", 0.03,
                  table.RELATIVE)
    pictures.draw_cantilever(study.picture(), start, end, (x, y + 0.5))


def wave_case(viscosity):
    solid = SOLID.format(x=0.1, y=2e-3, width=0.2, height=4e-3, density=2600.0, modulus=17e9,
                         poisson=0.14)
    return f"[grid]\ncell_size = 1e-3\n{solid}" + ("" if viscosity else INVISCID) + """
[[platen]]
side = "left"
speed = 0.1
ramp = 8e-6
[[platen]]
side = "top"
speed = 0.0
[[platen]]
side = "bottom"
speed = 0.0
[time]
duration = 1.7e-4
step_factor = 0.4
[output]
history_every = 1
"""


@check("bar_wave", title="Wave along a bar", minutes=0.1, short=True)
def bar_wave(study, short):
    """A bar of 200 cells, held sideways, is pushed by a platen at v = 0.1 m/s after a ramp of
    8 us: the platen feels rho c v until the wave comes back from the free end, at 2 l / c after
    the ramp's middle, and -rho c v after it. c is that of uniaxial strain."""
    c = math.sqrt(17e9 * 0.86 / (1.14 * 0.72 * 2600.0))
    for name, viscosity in (("without viscosity", False), ("with viscosity", True)):
        run = study.run(name.replace(" ", "_"), wave_case(viscosity))
        time, stress = run.history["time_s"], run.history["axial_stress_Pa"]
        plateau = stress[(time > 2e-5) & (time < 1.4e-4)].mean()
        after = np.argmax((time > 1e-4) & (stress < 0.0))
        back = time[after - 1] + (time[after] - time[after - 1]) * stress[after - 1] / (
            stress[after - 1] - stress[after])
        yield Row(name, "arrival after 2 l", "us", 1e6 * (back - 4e-6), 0.4 / c * 1e6, "2 l / c", 0.01,
                  table.RELATIVE)
        yield Row(name, "plateau", "MPa", 1e-6 * plateau, 2600.0 * c * 0.1e-6, "rho c v", 0.002,
                  table.RELATIVE)
