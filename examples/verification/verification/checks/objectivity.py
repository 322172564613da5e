"""How much of a crack is the grid's: shifted grids, turned flaws, cell sizes."""

import json
import subprocess
from math import cos, hypot, radians, sin

from matplotlib.figure import Figure

from .. import table
from ..finite_elements import FAILURE, MATERIAL
from ..registry import check
from ..study import EXAMPLES
from ..table import Row

ORDER = 60

CELL = 0.5e-3
COARSE = "time.step_factor=0.4"
QUIET = ("output.snapshot_steps=[]", "output.snapshot_every=1000000")
SHIFTS = (0.0, 0.125, 0.25, 0.375)  # cells
DISK_ANGLES = (0, 15, 30, 45, 60, 90)  # degrees from the load
PLATE_ANGLES = (0, 15, 30, 45)  # degrees from the grid
SIZES = (1e-3, 0.5e-3, 0.25e-3)
SECONDS_BLOCK, SECONDS_PLATE, SECONDS_DISK = 1.05e-3, 0.3e-3, 1.55e-3

PLATE = """
title = "a square plate pulled alike along x and y, with a slot in its middle"
[grid]
cell_size = 0.5e-3
[[body]]
shape = "box"
center = [0.0, 0.0]
size = [60e-3, 60e-3]
material = "rock"
[[flaw]]
shape = "slot"
center = [0.0, 0.0]
length = 10e-3
width = 1.5e-3
ends = "round"
""" + MATERIAL.lstrip() + FAILURE.lstrip() + """[time]
duration = 1e-3
step_factor = 0.4
[damping]
local = 0.7
""" + "".join(f'[[platen]]\nside = "{side}"\nspeed = -0.005\nramp = 2e-4\n'
              for side in ("top", "bottom", "left", "right"))


@check("objectivity", title="Objectivity: the grid's part in a crack", minutes=6.0)
def objectivity(study, short):
    """Nothing here has a reference but symmetry: rows report what the grid does to one physical
    problem. All at step factor 0.4, by the paper's rule, without fracture energy.

    Example 1 to a closure of some 0.0095 mm, first with the grid's lines moved along x under the
    same particles' body (a platen must lie on a grid line, so not along y), then with the flaw
    moved in the body by fractions of a cell (the specimen is then lopsided by 0.19 mm of 50 mm).

    Example 3 with both flaws turned about the middle of the disk. All slots are 1.5 mm wide, three
    cells: two cells, as in the example, are enough along grid lines only.

    Grid bias: a square plate pulled alike along x and y. That state is the same in all directions,
    so the slot's angle to the grid should change neither the load nor the crack, which continues
    the slot; the square edges, six slot lengths apart, disturb this a little.

    Cell size: example 1 with a slot of 3 mm, resolved by three, six and twelve cells."""
    yield from shifted(study)
    yield from turned_in_disk(study)
    yield from turned_in_plate(study)
    yield from refined(study)


def start(study, name, case, duration, *overrides):
    return study.run(name, case, COARSE, *QUIET,
                     f"time.steps={steps_of(duration, CELL)}", *overrides)


def steps_of(duration, cell):
    """At step factor 0.4, with the pressure wave of the examples' rock."""
    modulus = 17e9 * (1 - 0.14) / ((1 + 0.14) * (1 - 2 * 0.14))
    return round(duration / (0.4 * cell / (modulus / 2600.0) ** 0.5))


def cracks_of(study, run):
    """What `rgimp cracks` measures of a run."""
    path = run.directory / "cracks.json"
    subprocess.run([study.build / "bin/rgimp", "cracks", run.directory, "--json", path],
                   check=True, capture_output=True)
    return json.loads(path.read_text(encoding="utf-8"))


def first_of(run):
    """First failure's closure (mm), stress (MPa) and place (mm); None without one."""
    first = run.summary["first_failure"]
    if first is None:
        return None, None, None
    x, y = first["position_m"][:2]
    return first["closure_m"] * 1e3, first["axial_stress_Pa"] * 1e-6, (x * 1e3, y * 1e3)


def wing_angle(cracks, key="to_load_deg"):
    """Over the first 2 mm of the longest wing, degrees; None if none is that long."""
    measured = [wing for wing in cracks["wings"] if wing["angles"][0][key] is not None]
    longest = max(measured, key=lambda wing: wing["failed"], default=None)
    return None if longest is None else longest["angles"][0][key]


def describe(run, cracks):
    _, stress, place = first_of(run)
    if place is None:
        return "nothing failed"
    angle = wing_angle(cracks)
    wing = "no wing of 2 mm" if angle is None else f"wing over 2 mm {angle:.0f}° from the load"
    return (f"at ({place[0]:.2f}, {place[1]:.2f}) mm, {stress:.3f} MPa; {cracks['failed']} failed, "
            f"{cracks['outline']} along faces; {wing}")


def shifted(study):
    runs = {}
    for shift in SHIFTS[:3]:  # 3/8 is the mirror image of 1/8
        corner = f"grid.min=[{-29e-3 - shift * CELL!r}, -52.5e-3]"
        runs[f"grid moved {shift:g} cell"] = start(
            study, f"grid_{shift:g}", EXAMPLES / "single_flaw.toml", SECONDS_BLOCK, corner)
    for shift in SHIFTS[1:]:
        runs[f"flaw moved {shift:g} cell"] = start(
            study, f"flaw_{shift:g}", EXAMPLES / "single_flaw.toml", SECONDS_BLOCK,
            f"flaw[0].center=[{shift * CELL!r}, 0.0]")
    closures = []
    for name, run in runs.items():
        cracks = cracks_of(study, run)
        closures.append(first_of(run)[0])
        yield Row("example 1, " + name, "closure at first failure", "mm", closures[-1],
                  note=describe(run, cracks))
    yield Row("example 1, all six", "spread of that closure, (largest - smallest)/mean", "%",
              100 * (max(closures) - min(closures)) / (sum(closures) / len(closures)))
    draw(study, runs, "shift", 10e-3)
    yield symmetry(runs["grid moved 0 cell"])


def symmetry(run):
    """Example 1 is the same turned by 180°: so must its cracks be, to the step. They are at first
    failure; sums are added in one order from below, so round-off is not symmetric and grows."""
    last = run.snapshot()
    failed = last["failed"] > 0
    where = (last["position"][failed][:, :2] / (CELL / 4)).round().astype(int)
    steps = dict(zip(map(tuple, where.tolist()), last["failure_step"][failed].tolist()))
    lone = sum(steps.get((-x, -y)) != step for (x, y), step in steps.items())
    return Row("example 1", "failed particles without a twin across the middle, same step", "",
               lone, 0, "symmetry under a half turn", kind=table.EQUAL,
               note=f"of {len(steps)}")


def turned_in_disk(study):
    runs = {}
    for angle in DISK_ANGLES:
        x, y = 7e-3 * sin(radians(angle)), 7e-3 * cos(radians(angle))
        flaws = [f"flaw[{i}].{key}" for i, sign in enumerate((1, -1)) for key in (
            f"center=[{sign * x!r}, {sign * y!r}]", "width=1.5e-3", f"angle={90.0 - angle}")]
        runs[f"{angle}°"] = start(study, f"disk_{angle}", EXAMPLES / "brazilian_disk.toml",
                                  SECONDS_DISK, *flaws)
    for name, run in runs.items():
        cracks = cracks_of(study, run)
        case = f"example 3, flaws at {name} to the load"
        yield Row(case, "closure at first failure", "mm", first_of(run)[0],
                  note=describe(run, cracks))
        yield Row(case, "closure when two flaws' wings meet", "mm", closure_of_meeting(run, cracks),
                  note=f"peak {run.summary['peak_axial_stress_Pa'] * 1e-6:.3f} MPa")
    draw(study, runs, "disk", 20.5e-3)


def closure_of_meeting(run, cracks):
    steps = [event["step"] for event in cracks["events"]
             if event["wing"] and event["other_wing"]]
    if not steps:
        return None
    index = run.history["step"].searchsorted(min(steps))
    return run.history["closure_m"][index] * 1e3


def turned_in_plate(study):
    runs = {angle: start(study, f"plate_{angle}", PLATE.replace("duration = 1e-3", "steps = 1"),
                         SECONDS_PLATE, f"flaw[0].angle={float(angle)}")
            for angle in PLATE_ANGLES}
    whole = -first_of(runs[0])[1]
    for angle, run in runs.items():
        cracks = cracks_of(study, run)
        _, stress, (x, y) = first_of(run)
        case = f"plate pulled both ways, slot at {angle}° to the grid"
        yield Row(case, "stress at first failure over that at 0°", "", -stress / whole,
                  note=f"{-stress:.3f} MPa, at ({x:.2f}, {y:.2f}) mm, "
                       f"{hypot(x, y):.2f} mm from the middle")
        yield Row(case, "wing over 2 mm to the slot's line", "deg",
                  to_line(wing_angle(cracks, "deg"), angle),
                  note=f"0 without bias; {cracks['failed']} failed, "
                       f"{cracks['outline']} along faces")


def to_line(direction, angle):
    """Between a direction and a line, degrees, -90 to 90; None without a direction."""
    return None if direction is None else (direction - angle + 90.0) % 180.0 - 90.0


def refined(study):
    for cell in SIZES:
        run = study.run(f"cell_{cell * 1e3:g}", EXAMPLES / "single_flaw.toml", COARSE, *QUIET,
                        f"grid.cell_size={cell!r}", "flaw[0].width=3e-3",
                        f"time.steps={steps_of(SECONDS_BLOCK, cell)}")
        closure, stress, (x, y) = first_of(run)
        yield Row(f"example 1, slot 3 mm wide, L = {cell * 1e3:g} mm", "stress at first failure",
                  "MPa", stress, note=f"closure {closure:.5f} mm, at ({x:.2f}, {y:.2f}) mm")


def draw(study, runs, name, reach):
    figure = Figure(figsize=(2.4 * 3, 2.4 * ((len(runs) + 2) // 3) + 0.4), layout="constrained")
    axes = figure.subplots((len(runs) + 2) // 3, 3).ravel()
    for axis, (title, run) in zip(axes, runs.items()):
        last = run.snapshot()
        position, failed = last["position"] * 1e3, last["failed"] > 0
        axis.scatter(position[~failed, 0], position[~failed, 1], s=0.2, c="0.85", linewidths=0,
                     rasterized=True)
        axis.scatter(position[failed, 0], position[failed, 1], s=2.5, c="tab:red", linewidths=0)
        axis.set(title=title, aspect="equal", xlim=(-reach * 1e3, reach * 1e3),
                 ylim=(-reach * 1e3, reach * 1e3))
        axis.title.set_fontsize(8)
        axis.tick_params(labelsize=6)
    figure.savefig(study.picture(name), dpi=100)
