"""Every failure criterion and treatment of the paper's section 3."""

from dataclasses import dataclass
from math import cos, expm1, log1p, radians, sin

import numpy as np
from matplotlib.figure import Figure

from rgimp_plot import particles, style

from .. import table
from ..registry import check
from ..study import EXAMPLES
from ..table import Row

ORDER = 50

MODULUS, RATIO, DENSITY = 17e9, 0.14, 2600.0
COHESION, ANGLE = 5.95e6, 40.0
LAMBDA = MODULUS * RATIO / ((1 + RATIO) * (1 - 2 * RATIO))
SHEAR = MODULUS / (2 * (1 + RATIO))
BULK = LAMBDA + 2 * SHEAR / 3
CONFINED = LAMBDA + 2 * SHEAR
CELL = 0.5e-3
STEPS = 1000  # to the limit, so that a step is a part in a thousand of the strain

# Of one uniaxial tensile strength, 2 MPa: what each criterion's quantity is then.
TENSILE = 2e6
LIKE_2_MPA = {
    "mohr-coulomb": {"cohesion": COHESION, "friction_angle": ANGLE, "tensile_strength": TENSILE},
    "principal-stress": {"tensile_strength": TENSILE},
    "hydrostatic-tension": {"tensile_strength": TENSILE / 3},
    "principal-strain": {"tensile_strain": TENSILE / MODULUS},
    "shear-stress": {"shear_strength": TENSILE / 2},
    "shear-strain": {"shear_strain": (1 + RATIO) * TENSILE / MODULUS},
}
WINDOW = {"treatment": "pressure-window", "pressure_min": -0.3e6, "pressure_max": 5e6}


@check("criteria", title="Failure criteria and treatments", minutes=1.0, short=True)
def criteria(study, short):
    """One cell between four platens of constant speed: the natural strain at which it fails by each
    criterion, against Hooke's law in plane strain, within the strain of one step; then the
    stress that each treatment leaves of it, strained on to twice that.

    Then example 3 under every criterion, at step factor 0.4. Strengths are comparable in this
    sense: each is its criterion's quantity in a bar at a uniaxial tension of 2 MPa, the paper's
    tensile strength: 2/3 MPa of mean stress, 1 MPa of shear, strains of 1.18e-4 and 1.34e-4.
    In an isotropic elastic solid the shear strain is (1 + nu)/E times twice the shear stress, so
    these two criteria are one. Rock in shear is much stronger than 1 MPa: with that little the
    contacts (at y = -20 and 20 mm) are crushed before the flaws' tips (at 3 and 11 mm) crack."""
    for path in PATHS:
        yield strain_at_failure(study, path)
    for aftermath in AFTERMATHS:
        yield stress_left(study, aftermath)
    if not short:
        yield from disk(study)


def literal(failure):
    """A failure table as TOML on one line."""
    values = (f'{key} = "{value}"' if isinstance(value, str) else f"{key} = {value!r}"
              for key, value in failure.items())
    return "{" + ", ".join(values) + "}"


@dataclass(frozen=True)
class Path:
    """A cell strained by `along_y` and `along_x` (1 or -1: longer, shorter) times what fails it."""
    criterion: str
    keys: dict
    name: str
    along_y: float
    along_x: float
    strain: float  # natural, along y at failure, in size
    source: str
    mode: str


def paths():
    sine, cosine = sin(radians(ANGLE)), cos(radians(ANGLE))
    like = LIKE_2_MPA
    shear, shear_strain = like["shear-stress"], like["shear-strain"]
    strain = like["principal-strain"]
    return [
        Path("mohr-coulomb", like["mohr-coulomb"], "pulled", 1, 0, TENSILE / CONFINED,
             "sigma_t / (lambda + 2 mu)", "tension"),
        Path("mohr-coulomb", like["mohr-coulomb"], "squeezed", -1, 0,
             COHESION * cosine / (SHEAR - (LAMBDA + SHEAR) * sine),
             "c cos phi / (mu - (lambda + mu) sin phi)", "shear"),
        Path("hydrostatic-tension", like["hydrostatic-tension"], "pulled", 1, 0,
             TENSILE / 3 / BULK, "sigma / K", "tension"),
        Path("hydrostatic-tension", like["hydrostatic-tension"], "pulled both ways", 1, 1,
             TENSILE / 6 / BULK, "sigma / 2 K", "tension"),
        Path("principal-stress", like["principal-stress"], "sheared at 45°", 1, -1,
             TENSILE / (2 * SHEAR), "sigma_t / 2 mu", "tension"),
        Path("principal-strain", strain, "pulled", 1, 0, strain["tensile_strain"],
             "the limit itself", "tension"),
        Path("principal-strain", strain, "sheared at 45°", 1, -1, strain["tensile_strain"],
             "the limit itself", "tension"),
        Path("shear-stress", shear, "squeezed", -1, 0, shear["shear_strength"] / SHEAR,
             "tau / mu", "shear"),
        Path("shear-stress", shear, "sheared at 45°", -1, 1, shear["shear_strength"] / (2 * SHEAR),
             "tau / 2 mu", "shear"),
        Path("shear-strain", shear_strain, "squeezed both ways", -1, -1,
             shear_strain["shear_strain"], "the limit: eps_z = 0 is the major one", "shear"),
        Path("shear-strain", shear_strain, "sheared at 45°", -1, 1,
             shear_strain["shear_strain"] / 2, "half the limit", "shear"),
    ]


PATHS = paths()


def cell_case(path, failure, steps):
    """Platens that reach the limit of `path` half a step before step STEPS."""
    dt = 0.4 * CELL / (CONFINED / DENSITY) ** 0.5
    along = {"top": path.along_y, "bottom": path.along_y, "left": path.along_x,
             "right": path.along_x}
    speeds = {side: -expm1(sign * path.strain) / ((STEPS - 0.5) * dt) * CELL / 2
              for side, sign in along.items()}
    platens = "".join(f'[[platen]]\nside = "{side}"\nspeed = {speed!r}\n'
                      for side, speed in speeds.items())
    return f"""
title = "one cell, {path.name}"
[grid]
cell_size = {CELL}
[[body]]
shape = "box"
center = [0.0, 0.0]
size = [{CELL}, {CELL}]
material = "rock"
[material.rock]
density = {DENSITY}
youngs_modulus = {MODULUS}
poisson_ratio = {RATIO}
failure = {literal({"criterion": path.criterion, **failure})}
{platens}
[time]
steps = {steps}
step_factor = 0.4
"""


def strain_at_failure(study, path):
    run = study.run(f"{path.criterion}_{path.name}".replace(" ", "_").replace("°", ""),
                    cell_case(path, path.keys, STEPS + 10))
    first = run.summary["first_failure"]
    found = np.nan
    if first and first["mode"] == path.mode:
        found = abs(log1p(-first["closure_m"] / CELL))
    return Row(f"one cell, {path.criterion}, {path.name}", f"strain at failure in {path.mode}", "1",
               found, path.strain, path.source, 1 / STEPS, table.RELATIVE)


@dataclass(frozen=True)
class Aftermath:
    treatment: dict
    path: Path
    stress: float  # Pa, all three normal ones, at twice the strain of failure
    source: str


def aftermaths():
    pulled = next(path for path in PATHS if path.criterion == "mohr-coulomb" and path.along_y > 0)
    squeezed = next(path for path in PATHS if path.criterion == "shear-stress" and not path.along_x)
    # A strength that leaves more pressure than the window takes.
    squeezed = Path(squeezed.criterion, {"shear_strength": 6e6}, squeezed.name, -1, 0, 6e6 / SHEAR,
                    squeezed.source, "shear")
    pressed = BULK * log1p(expm1(-squeezed.strain) * 2 * STEPS / (STEPS - 0.5))
    no_tension, stress_free = {"treatment": "no-tension"}, {"treatment": "stress-free"}
    return [Aftermath(no_tension, pulled, 0.0, "no tension"),
            Aftermath(no_tension, squeezed, pressed, "K eps"),
            Aftermath(stress_free, pulled, 0.0, "no stress"),
            Aftermath(stress_free, squeezed, 0.0, "no stress"),
            Aftermath(WINDOW, pulled, -WINDOW["pressure_min"], "the window's end"),
            Aftermath(WINDOW, squeezed, -WINDOW["pressure_max"], "the window's end")]


AFTERMATHS = aftermaths()


def stress_left(study, aftermath):
    path, name = aftermath.path, aftermath.treatment["treatment"]
    run = study.run(f"{name}_{path.name}",
                    cell_case(path, {**path.keys, **aftermath.treatment}, 2 * STEPS))
    stress = run.snapshot()["stress"] * 1e-6
    # Differences, for the mean of three equal numbers need not equal them.
    deviator = np.hstack([np.ptp(stress[:, :3], axis=1, keepdims=True), np.abs(stress[:, 3:])])
    failed = (run.snapshot()["failed"] > 0).all() and deviator.max() == 0
    row = (f"one cell, {name}, {path.name} on", "stress left", "MPa",
           float(stress[:, 1].mean()) if failed else np.nan, aftermath.stress * 1e-6,
           aftermath.source)
    if aftermath.stress == 0:
        return Row(*row, kind=table.EQUAL)
    return Row(*row, tolerance=1 / STEPS, kind=table.RELATIVE)


DISK = ("time.step_factor=0.4", "time.steps=19008", "output.snapshot_every=19008",
        "output.snapshot_steps=[]")


def disk(study):
    runs = {}
    for criterion, keys in LIKE_2_MPA.items():
        runs[criterion] = disk_run(study, criterion, {"criterion": criterion, **keys})
    mohr_coulomb = {"criterion": "mohr-coulomb", **LIKE_2_MPA["mohr-coulomb"]}
    for treatment in ({"treatment": "stress-free"}, WINDOW):
        runs[treatment["treatment"]] = disk_run(study, treatment["treatment"],
                                                {**mohr_coulomb, **treatment})
    draw(study, runs)
    for name, run in runs.items():
        yield from report(name, run)
    yield Row("example 3, principal-stress", "hash of the final state", "",
              runs["principal-stress"].summary["state_hash"],
              runs["mohr-coulomb"].summary["state_hash"],
              "mohr-coulomb: its tensile branch alone, as nothing fails in shear", kind=table.EQUAL)
    yield Row("example 3, shear-strain", "failed particles that shear-stress's are not", "1",
              int((runs["shear-strain"].snapshot()["failed"]
                   != runs["shear-stress"].snapshot()["failed"]).sum()),
              0, "one criterion in isotropic elasticity", kind=table.EQUAL)


def disk_run(study, name, failure):
    return study.run(f"disk_{name}", EXAMPLES / "brazilian_disk.toml", *DISK,
                     f"material.rock.failure={literal(failure)}")


def report(name, run):
    summary, case = run.summary, f"example 3, {name}"
    first = summary["first_failure"]
    x, y, _ = (1e3 * coordinate for coordinate in first["position_m"])
    yield Row(case, "first failure: closure", "µm", first["closure_m"] * 1e6)
    yield Row(case, "first failure: place", "mm", f"({x:.2f}, {y:.2f})")
    yield Row(case, "failed at the end", "", f"{summary['failed_tension']} in tension, "
              f"{summary['failed_shear']} in shear")


def draw(study, runs):
    """Failed particles at the end, a panel a run."""
    figure = Figure(figsize=(10.4, 6.3), dpi=80)
    results = {name: run.result for name, run in runs.items()}
    for place, (name, result) in enumerate(results.items()):
        snapshot = result.snapshot(result.steps()[-1])
        window = particles.Window(result, [snapshot])
        axes = figure.add_subplot(2, 4, place + 1)
        window.prepare(axes, labels=False)
        particles.add_modes(axes, window, snapshot)
        first = runs[name].summary["first_failure"]
        failed = int((snapshot.failed > 0).sum())
        axes.set_title(f"{name}\n{failed} failed, from {first['closure_m'] * 1e6:.2f} µm on",
                       fontsize=9)
    caption = style.caption(
        next(iter(results.values())),
        "Red: failed in tension, orange: in shear. Closure 5.41 µm. The last two: mohr-coulomb "
        "with other treatments than no-tension.")
    style.add_title(figure, "Example 3 under every criterion, all of a uniaxial tensile strength "
                    "of 2 MPa, and every treatment")
    style.add_caption(figure, caption)
    figure.subplots_adjust(left=0.02, right=0.98, bottom=0.07, top=0.86, wspace=0.08, hspace=0.24)
    figure.savefig(study.picture())
