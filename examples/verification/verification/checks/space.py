"""Three dimensions against closed forms, and against two."""

from math import cos, expm1, radians, sin, sqrt

import numpy as np

from .. import fields, goodier, table
from ..finite_elements import FAILURE, MATERIAL, Loading
from ..registry import check
from ..study import EXAMPLES, StudyError
from ..table import Row
from . import space_pictures

ORDER = 15

MODULUS, RATIO, DENSITY = 17e9, 0.14, 2600.0
COHESION, ANGLE = 5.95e6, radians(40.0)
LAMBDA = MODULUS * RATIO / ((1.0 + RATIO) * (1.0 - 2.0 * RATIO))
SHEAR = MODULUS / (2.0 * (1.0 + RATIO))
CONFINED = LAMBDA + 2.0 * SHEAR
WAVE_SPEED = sqrt(CONFINED / DENSITY)
COMPRESSION = 2.0 * COHESION * cos(ANGLE) / (1.0 - sin(ANGLE))
WIDTH, HEIGHT = 3e-3, 6e-3

COLUMN = f"""
title = "a column in space"
dimension = 3
[grid]
cell_size = 0.5e-3
[[body]]
shape = "box"
center = [0.0, 0.0, 0.0]
size = [{WIDTH}, {HEIGHT}, {WIDTH}]
material = "rock"
{MATERIAL}"""
SLOW = Loading(ramp=2e-5, duration=4e-4, speed=0.01, step_factor=0.4, damping=0.7)
PRESS = Loading(ramp=4e-5, duration=5e-4, speed=0.01, step_factor=0.4, damping=0.7)
PULL = Loading(ramp=4e-5, duration=2e-4, speed=-0.003, step_factor=0.4, damping=0.7)
SIDES = ("left", "right", "front", "back")


def held(*sides):
    return "".join(f'[[platen]]\nside = "{side}"\nspeed = 0.0\n' for side in sides)


@check("space", title="Three dimensions: closed forms", minutes=0.5, short=True)
def space(study, short):
    """A column of 6 by 12 by 6 cells between slipping platens, free and held on four sides; a bar
    along z that a platen pushes; the column until it fails, pressed, pulled, and squeezed by six
    platens whose speeds keep the ratio of the stresses across and along it (conventional triaxial
    compression, two equal principal stresses): sigma_1 = N sigma_3 + the uniaxial strength, with
    N = (1 + sin phi) / (1 - sin phi)."""
    yield from moduli(study)
    yield from wave(study)
    for name, loading, sign, expected, source in (
            ("pressed", PRESS, 1.0, COMPRESSION, "2c·cos φ / (1 − sin φ)"),
            ("pulled", PULL, -1.0, 2e6, "σ_t")):
        yield strength(study.run(name, COLUMN + FAILURE + loading.text()), f"column, {name}", sign,
                       expected, source)
    for ratio in (0.05, 0.1):
        yield triaxial(study, ratio)


def moduli(study):
    free = study.run("free", COLUMN + SLOW.text())
    confined = study.run("held", COLUMN + held(*SIDES) + SLOW.text())
    for name, run, expected, source in (("free", free, MODULUS, "E"),
                                        ("held on four sides", confined, CONFINED, "λ + 2μ")):
        last = {key: column[-1] for key, column in run.history.items()}
        yield Row(f"column, {name}", "modulus", "GPa",
                  last["axial_stress_Pa"] * HEIGHT / last["closure_m"] * 1e-9, expected * 1e-9,
                  source, 0.002, table.RELATIVE)
    stress = confined.snapshot()["stress"].mean(axis=0)
    for side, name in ((fields.XX, "σ_xx / σ_yy"), (fields.ZZ, "σ_zz / σ_yy")):
        yield Row("column, held on four sides", name, "1", stress[side] / stress[fields.YY],
                  RATIO / (1.0 - RATIO), "ν / (1 − ν)", 0.002, table.RELATIVE)
    start, end = free.snapshot(0), free.snapshot()
    order = np.argsort(start["id"]), np.argsort(end["id"])
    before, after = start["position"][order[0]], end["position"][order[1]]
    strain = ((after - before) * before).sum(axis=0) / (before**2).sum(axis=0)
    for axis, name in ((0, "−ε_xx / ε_yy"), (2, "−ε_zz / ε_yy")):
        yield Row("column, free", name, "1", -strain[axis] / strain[1], RATIO, "ν", 0.004,
                  table.RELATIVE)


def wave(study):
    """Along z, so that every axis of the kernels is somewhere the load's."""
    length, speed, ramp = 0.1, 0.1, 8e-6
    run = study.run("wave", f"""
title = "a wave along z"
dimension = 3
[grid]
cell_size = 1e-3
[[body]]
shape = "box"
center = [0.0, 0.0, {0.5 * length}]
size = [2e-3, 2e-3, {length}]
material = "rock"
{MATERIAL}
[viscosity]
quadratic = 0.0
linear = 0.0
[[platen]]
side = "back"
speed = {speed}
ramp = {ramp}
{held("left", "right", "top", "bottom")}
[time]
duration = 9e-5
step_factor = 0.4
[output]
history_every = 1
""")
    time, stress = run.history["time_s"], run.history["axial_stress_Pa"]
    plateau = stress[(time > 2e-5) & (time < 6.5e-5)].mean()
    after = np.argmax((time > 4e-5) & (stress < 0.0))
    back = np.interp(0.0, [-stress[after - 1], -stress[after]], time[after - 1:after + 1])
    yield Row("bar along z", "arrival after 2 l", "µs", 1e6 * (back - 0.5 * ramp),
              2e6 * length / WAVE_SPEED, "2 l / c", 0.01, table.RELATIVE)
    yield Row("bar along z", "plateau", "MPa", plateau * 1e-6,
              DENSITY * WAVE_SPEED * speed * 1e-6, "ρ c v", 0.002, table.RELATIVE)


def strength(run, name, sign, expected, source):
    first = run.summary["first_failure"]
    return Row(name, "axial stress at the first failure", "MPa",
               sign * first["axial_stress_Pa"] * 1e-6 if first else np.nan, expected * 1e-6, source,
               0.015, table.RELATIVE)


def triaxial(study, ratio):
    """sigma_3 / sigma_1 = `ratio` in elasticity, by the ratio of the strains across and along."""
    friction = (1.0 + sin(ANGLE)) / (1.0 - sin(ANGLE))
    expected = COMPRESSION / (1.0 - friction * ratio)
    across = ((ratio * CONFINED - LAMBDA) / (2.0 * (LAMBDA + SHEAR) - 2.0 * LAMBDA * ratio))
    strain = expected / (CONFINED + 2.0 * LAMBDA * across)
    rate = PRESS.speed * 2.0 / HEIGHT
    speed_across = -expm1(-across * strain) / -expm1(-strain) * rate * 0.5 * WIDTH
    platens = "".join(f'[[platen]]\nside = "{side}"\nspeed = {speed_across!r}\n'
                      f"ramp = {PRESS.ramp}\n" for side in SIDES)
    duration = 1.1 * strain / rate + PRESS.ramp
    loading = Loading(ramp=PRESS.ramp, duration=duration, speed=PRESS.speed, step_factor=0.4,
                      damping=0.7).text()
    top_first = loading.replace("[time]", f"{platens}[time]")  # the load's axis is the first one's
    run = study.run(f"triaxial_{ratio}", COLUMN + FAILURE + top_first)
    return strength(run, f"column, confined, σ_3 = {ratio} σ_1", 1.0, expected,
                    "N σ_3 + the uniaxial strength")


RADIUS, EDGE = 8e-3, 32e-3  # of the hole, and of an eighth of the block
# As many transits of the eighth as Loading's own of the paper's specimens.
HOLE_LOADING = Loading(ramp=7e-5, duration=1.2e-4, speed=-0.02)


def hole_case(cells):
    """An eighth of a block with a hole `cells` in radius, between planes of symmetry."""
    pull = HOLE_LOADING
    return f"""
title = "spherical hole"
dimension = 3
[grid]
cell_size = {RADIUS / cells!r}
[[body]]
shape = "box"
center = [{EDGE / 2}, {EDGE / 2}, {EDGE / 2}]
size = [{EDGE}, {EDGE}, {EDGE}]
material = "rock"
[[flaw]]
shape = "sphere"
center = [0.0, 0.0, 0.0]
length = {2.0 * RADIUS}
{MATERIAL}
[[platen]]
side = "top"
speed = {pull.speed}
ramp = {pull.ramp}
{held("bottom", "left", "back")}
[time]
duration = {pull.duration}
step_factor = {pull.step_factor}
[output]
history_every = 10
"""


@check("spherical_hole", title="Spherical hole under tension", minutes=4.0, short=True)
def spherical_hole(study, short):
    """An eighth of a cube of 8 radii with a spherical hole, pulled along y between planes of
    symmetry (platens that hold and let slip), against Goodier's solution in an infinite solid. Its
    S is that whose share in the cube's section through the hole, 0.9936 S, is the load: the mean
    stress of the cube, the hole counted as nothing. (The reaction in the history is of the step
    before, when the load was 0.2 to 0.7 % less.)

    `fitted`: 1 + a + b of a least-squares fit of the solution's own form, 1 + a (R/r)³ + b (R/r)⁵,
    to particles within half a cell of the equator's plane from one cell off the hole to 3 R.
    `first cell`: those up to one cell off the hole, a hole made of cubes, over Goodier's mean at
    their places. `field`: what the hole adds to the stress along y, wherever a particle is up to
    3 R and farther than two cells from the hole."""
    profiles = {}
    for cells in (4,) if short else (4, 8, 16):
        run = study.run(f"hole_{cells}", hole_case(cells))
        last = run.snapshot()
        whole = (2 * EDGE / RADIUS * cells)**3
        remote = (last["stress"][:, fields.YY].sum() / whole
                  / goodier.section_mean(EDGE / RADIUS, RATIO))
        distance = np.linalg.norm(last["position"], axis=1) / RADIUS
        cosine = last["position"][:, 1] / RADIUS / distance
        stress = last["stress"][:, fields.YY] / remote
        equator = last["position"][:, 1] < 0.5 * RADIUS / cells
        profiles[cells] = distance[equator], stress[equator]
        yield from hole_rows(cells, distance, cosine, stress, equator)
    space_pictures.draw_hole(study.picture(), profiles, RATIO)


def hole_rows(cells, distance, cosine, stress, equator):
    case = f"radius of {cells} cells"
    off = 1.0 / cells
    fitted = equator & (distance > 1.0 + off) & (distance < 3.0)
    form = np.stack([distance[fitted]**-3, distance[fitted]**-5], axis=1)
    coefficients = np.linalg.lstsq(form, stress[fitted] - 1.0, rcond=None)[0]
    yield Row(case, "concentration at the equator, fitted", "1", 1.0 + coefficients.sum(),
              goodier.concentration(RATIO), "Goodier, (27 − 15ν) / (2(7 − 5ν))", 0.05,
              table.RELATIVE)
    first = equator & (distance < 1.0 + off)
    yield Row(case, "first cell at the equator: mean stress", "1", stress[first].mean(),
              goodier.equator(distance[first], RATIO).mean(), "Goodier, at the same places", 0.03,
              table.RELATIVE)
    clear = (distance > 1.0 + 2.0 * off) & (distance < 3.0)
    field = fields.agreement(stress[clear] - 1.0,
                             goodier.axial_stress(distance[clear], cosine[clear], RATIO) - 1.0)
    yield Row(case, "field: slope", "1", field.slope, 1.0, "Goodier", 0.05, table.RELATIVE)
    yield Row(case, "field: RMS of the difference by that of Goodier's", "1", field.relative_rms)


SLAB_CELL = 1e-3
SLAB = (f"grid.cell_size={SLAB_CELL}", "flaw[0].width=3e-3", "time.step_factor=0.4",
        "time.steps=27805", "output.snapshot_every=27805", "output.snapshot_steps=[]")


def slab_case(damping):
    """Example 1 one cell deep between front and back platens that hold and let slip."""
    text = (EXAMPLES / "single_flaw.toml").read_text(encoding="utf-8")
    for old, new in (("dimension = 2", "dimension = 3"),
                     ("center = [0.0, 0.0]", "center = [0.0, 0.0, 0.0]"),
                     ("size = [50e-3, 100e-3]", f"size = [50e-3, 100e-3, {SLAB_CELL}]"),
                     ("[time]", f"{held('front', 'back')}[time]")):
        if old not in text:
            raise StudyError(f"example 1 has no {old}")
        text = text.replace(old, new)
    return text, (*SLAB, f"damping.local={damping}")


@check("slab", title="Example 1 as a slab in plane strain", minutes=5.0)
def slab(study, short):
    """Example 1 at cells of 1 mm (the flaw three of them wide) in two dimensions, and one cell deep
    in three between front and back platens that stand still and let slip. In exact arithmetic the
    two are one. Undamped they stay one to round-off, cracks and all. Local damping turns on the
    signs of velocities, so that round-off of a velocity near zero counts in full: damped, the slab
    is off by more than round-off. So is the plane from itself when its grid is shifted by whole
    cells, which changes round-off alone: the slab must be off by no more than ten times that."""
    for damping in (0.0, 0.7):
        flat = study.run(f"plane_{damping}", EXAMPLES / "single_flaw.toml", *SLAB,
                         f"damping.local={damping}")
        shifted = study.run(f"shifted_{damping}", EXAMPLES / "single_flaw.toml", *SLAB,
                            "grid.min=[-37e-3, -58e-3]", f"damping.local={damping}")
        text, overrides = slab_case(damping)
        deep = study.run(f"slab_{damping}", text, *overrides)
        yield from compare(f"damping {damping}", flat, shifted, deep)


def compare(case, flat, shifted, deep):
    first, expected = deep.summary["first_failure"], flat.summary["first_failure"]
    yield Row(case, "first failure: step", "1", first["step"], expected["step"], "two dimensions",
              kind=table.EQUAL)
    yield Row(case, "first failure: place in the plane", "mm",
              "({:.3f}, {:.3f})".format(*(1e3 * value for value in first["position_m"][:2])),
              "({:.3f}, {:.3f})".format(*(1e3 * value for value in expected["position_m"][:2])),
              "two dimensions", kind=table.EQUAL)
    before = flat.history["step"] < expected["step"]
    for rows, name in ((before, "before it"), (~before, "after it")):
        yield Row(case, f"axial stress {name}: largest difference", "1",
                  apart(flat, deep, rows), 10.0 * apart(flat, shifted, rows),
                  "10 times that of 2D on a shifted grid", kind=table.AT_MOST)
    layers = deep.summary["particles"] // flat.summary["particles"]
    yield Row(case, "failed at the end, a layer of particles", "1",
              (deep.summary["failed_tension"] + deep.summary["failed_shear"]) / layers,
              flat.summary["failed_tension"] + flat.summary["failed_shear"], "two dimensions", 0.1,
              table.RELATIVE)


def apart(one, other, rows):
    """Largest difference of two runs' axial stresses in these rows, by the largest stress there."""
    stress, others = (run.history["axial_stress_Pa"][rows] for run in (one, other))
    return np.abs(stress - others).max() / np.abs(stress).max()
