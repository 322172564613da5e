"""Softening by fracture energy, our extension, beside the paper's rule."""

from math import atan2, cos, degrees, radians, sin

import numpy as np
from matplotlib.figure import Figure

from .. import cohesive, finite_elements, table
from ..registry import check
from ..study import EXAMPLES, Run, StudyError
from ..table import Row

ORDER = 60

MODULUS, RATIO = 17e9, 0.14
PLANE_MODULUS = MODULUS / (1.0 - RATIO**2)
STRENGTH, ENERGY = 2e6, 1.0  # Pa, J/m2
WIDTH, NOTCH = 50e-3, 7.5e-3  # m, of the plate; half the crack
SLOT = 12e-3  # m, of the plate pulled on all sides

MATERIAL = '\nmaterial = "rock"' + finite_elements.MATERIAL
SOFTENING = """
[material.rock.failure]
criterion = "principal-stress"
tensile_strength = 2e6
fracture_energy = {energy}
"""
PLATEN = """
[[platen]]
side = "{side}"
speed = {speed}
ramp = {ramp}
lateral = "{lateral}"
"""
TIME = """
[time]
duration = {duration}
step_factor = 0.4
[damping]
local = {damping}
[output]
history_every = 20
"""


@check("fracture_energy", title="Softening by fracture energy, beside the paper's rule",
       minutes=9.0, short=True)
def fracture_energy(study, short):
    """G_f = 1 J/m2, sigma_t = 2 MPa. A cell pulled apart, held sideways, takes G_f per area whatever
    its size.

    A plate, 50 x 100 mm, with a centred slot across the load, 15 mm long and two cells wide, ends
    square, pulled by slipping platens at 0.01 m/s in all, local damping 0.1: its peak load against
    a cohesive crack of no width with the same strength and fracture energy and linear softening.

    A plate, 60 x 60 mm, pulled alike on all four sides, with a slot of 12 x 1.5 mm: every direction
    is a principal one, so the crack must go on along the slot, whatever its angle, and nothing but
    the mesh can turn it; at 45 degrees symmetry holds it there. This is harsher than tension across
    the slot alone, which holds a crack on its way.

    Examples 1 and 3 at step factor 0.4 with each rule and damping 0 and 0.1, and example 2 at 0.1.
    First failure comes later with G_f, and damage comes before it: this is no way to the paper's
    step numbers. Last, example 1 with G_f in cells of half the size."""
    yield from elements(study)
    if not short:
        yield from plates(study)
        yield from paths(study)
        yield from examples(study)
        yield from refined(study)


def block(cell, size, flaw="", material=""):
    return (f'[grid]\ncell_size = {cell!r}\n{flaw}[[body]]\nshape = "box"\ncenter = [0.0, 0.0]\n'
            f"size = [{size[0]!r}, {size[1]!r}]{MATERIAL}{material}")


def platens(sides, speed, ramp, lateral="slip"):
    return "".join(PLATEN.format(side=side, speed=speed, ramp=ramp, lateral=lateral)
                   for side in sides)


def elements(study):
    for cell in (1e-3, 0.5e-3, 0.25e-3):
        case = (block(cell, (cell, cell), material=SOFTENING.format(energy=ENERGY))
                + platens(["top"], -0.02, 1e-6, "stick") + platens(["bottom"], 0.0, 0.0, "stick")
                + TIME.format(duration=1.1 * 2.0 * ENERGY / STRENGTH / 0.02, damping=0.0))
        run = study.run(f"element_{cell * 1e6:.0f}um", case)
        yield Row(f"one element of {cell * 1e3:g} mm", "energy dissipated", "J/m2",
                  run.history["released_energy_J"][-1] / cell, ENERGY, "the material's G_f", 0.01,
                  table.RELATIVE)
        yield Row(f"one element of {cell * 1e3:g} mm", "energy error", "1",
                  run.summary["energy_error"], 0.0, "conservation of energy", 0.01, table.ABSOLUTE)


def plate(cell, energy):
    slot = (f'[[flaw]]\nshape = "slot"\ncenter = [0.0, 0.0]\nlength = {2.0 * NOTCH!r}\n'
            f"width = {2.0 * cell!r}\n")
    duration = 0.7e-3 if energy else 0.4e-3
    return (block(cell, (WIDTH, 2.0 * WIDTH), slot, SOFTENING.format(energy=energy))
            + platens(["top", "bottom"], -0.005, 1e-4)
            + TIME.format(duration=duration, damping=0.1))


def peak_tension(run):
    """MPa."""
    return -1e-6 * float(run.history["axial_stress_Pa"].min())


def plates(study):
    reference = (NOTCH, WIDTH, PLANE_MODULUS, STRENGTH, ENERGY)
    theory = 1e-6 * cohesive.strength(*reference)
    irwin = 1e-6 * cohesive.irwin_strength(*reference)
    case = "centre-cracked plate"
    peaks, instant = {}, {}
    for cell in (1e-3, 0.5e-3, 0.25e-3):
        name = f"{cell * 1e6:.0f}um"
        peaks[cell] = peak_tension(study.run(f"plate_{name}", plate(cell, ENERGY)))
        instant[cell] = peak_tension(study.run(f"plate_instant_{name}", plate(cell, 0.0)))
        yield Row(case, f"strength, cells of {cell * 1e3:g} mm", "MPa", peaks[cell], theory,
                  "cohesive crack (verification/cohesive.py)", 0.03, table.RELATIVE,
                  note=f"Irwin's estimate: {irwin:.3f} MPa, {peaks[cell] / irwin - 1.0:+.1%}")
        yield Row(case, f"strength by the paper's rule, cells of {cell * 1e3:g} mm", "MPa",
                  instant[cell])
    yield Row(case, "largest over smallest of three strengths, less 1", "1",
              max(peaks.values()) / min(peaks.values()) - 1.0, 0.03, "target", 0.0, table.AT_MOST)
    draw_plates(study, peaks, instant, theory, irwin)


def draw_plates(study, peaks, instant, theory, irwin):
    figure = Figure(figsize=(5.0, 3.4), layout="constrained")
    axes = figure.subplots()
    for values, label in ((peaks, "G_f = 1 J/m²"), (instant, "the paper's rule")):
        axes.plot([1e3 * cell for cell in values], list(values.values()), "o-", label=label)
    axes.axhline(theory, color="black", linewidth=0.8, label="cohesive crack")
    axes.axhline(irwin, color="black", linewidth=0.8, linestyle=":", label="Irwin's estimate")
    axes.set(xlabel="cell size (mm)", ylabel="strength (MPa)", xlim=(0.0, 1.1), ylim=(0.0, None),
             title="Centre-cracked plate in tension")
    axes.legend(frameon=False)
    figure.savefig(study.picture("plate"), dpi=100)


def slot_at(angle, energy):
    slot = (f'[[flaw]]\nshape = "slot"\ncenter = [0.0, 0.0]\nlength = {SLOT!r}\nwidth = 1.5e-3\n'
            f'angle = {angle!r}\nends = "round"\n')
    return (block(0.5e-3, (60e-3, 60e-3), slot, SOFTENING.format(energy=energy))
            + platens(["top", "bottom", "left", "right"], -0.005, 1e-4)
            + TIME.format(duration=0.42e-3, damping=0.1))


def direction_error(run, angle):
    """Degrees between the slot and the cracks' first 6 mm, both turned alike, as a mean of least
    squares through the tips."""
    last = run.snapshot()
    errors = []
    for side in (1.0, -1.0):
        along = side * np.array([cos(radians(angle)), sin(radians(angle))])
        from_tip = last["position"][last["failed"] > 0, :2] - 0.5 * SLOT * along
        ahead, beside = from_tip @ along, from_tip @ np.array([-along[1], along[0]])
        near = (ahead > 0.5e-3) & (np.hypot(ahead, beside) < 6e-3)
        errors.append(degrees(atan2((ahead * beside)[near].sum(), (ahead**2)[near].sum())))
    return float(np.mean(errors))


def paths(study):
    for angle in (15.0, 30.0, 45.0):
        for energy, rule in ((ENERGY, "G_f = 1 J/m2"), (0.0, "the paper's rule")):
            run = study.run(f"path_{angle:.0f}_{'gf' if energy else 'instant'}",
                            slot_at(angle, energy))
            yield Row(f"slot at {angle:g}°, pulled on all sides", f"direction error, {rule}", "°",
                      direction_error(run, angle), note="0 along the slot")


RULES = (("paper", "the paper's rule", ()),
         ("gf", "G_f = 1 J/m2", ("material.rock.failure.fracture_energy=1.0",
                                 "material.rock.failure.shear_fracture_energy=10.0")))
# example, file, steps at factor 0.4, dampings
EXAMPLE_RUNS = (("example 1", "single_flaw", 36000, (0.0, 0.1)),
                ("example 2", "double_flaw", 25000, (0.1,)),
                ("example 3", "brazilian_disk", 40000, (0.0, 0.1)))


def run_to_end(study, name, *arguments):
    """A run, also one that the physics stopped, and how it ended."""
    try:
        return study.run(name, *arguments), "ran to its end"
    except StudyError:
        return Run(study.runs / study.name / name), "stopped"


def examples(study):
    for case, file, steps, dampings in EXAMPLE_RUNS:
        for damping in dampings:
            for key, rule, overrides in RULES:
                name = f"{file}_{key}_{damping:g}"
                run, end = run_to_end(
                    study, name, EXAMPLES / f"{file}.toml", "time.step_factor=0.4",
                    f"time.steps={steps}", f"damping.local={damping}", "output.snapshot_steps=[]",
                    f"output.snapshot_every={steps}", *overrides)
                yield from describe(run, end, f"{case}, {rule}, damping {damping:g}")


def strayed(run):
    """Particles farther than 1 mm from where they began."""
    steps = run.steps()
    first, last = run.snapshot(steps[0]), run.snapshot(steps[-1])
    return int((np.linalg.norm(last["position"] - first["position"], axis=1) > 1e-3).sum())


def describe(run, end, case):
    summary = run.summary
    first = summary["first_failure"]
    yield Row(case, "closure at first failure", "mm",
              1e3 * first["closure_m"] if first else "none")
    yield Row(case, "failed in tension + shear", "1",
              f"{summary['failed_tension']} + {summary['failed_shear']}")
    yield Row(case, "peak axial stress", "MPa", 1e-6 * summary["peak_axial_stress_Pa"])
    yield Row(case, "particles strayed over 1 mm", "1", strayed(run), note=end)
    yield Row(case, "energy error", "1", summary["energy_error"], 0.0, "conservation of energy",
              0.01, table.ABSOLUTE)


def refined(study):
    """Example 1 with G_f, damping 0.1, in cells of half the size too."""
    _, rule, overrides = RULES[1]
    stresses = []
    for cell, steps in ((0.5e-3, 30000), (0.25e-3, 60000)):
        run = study.run(f"refined_{cell * 1e6:.0f}um", EXAMPLES / "single_flaw.toml",
                        f"grid.cell_size={cell!r}", "time.step_factor=0.4", f"time.steps={steps}",
                        "damping.local=0.1", "output.snapshot_steps=[]",
                        f"output.snapshot_every={steps}", *overrides)
        case = f"example 1, {rule}, cells of {cell * 1e3:g} mm"
        first = run.summary["first_failure"]
        stresses.append(1e-6 * first["axial_stress_Pa"])
        yield Row(case, "closure at first failure", "mm", 1e3 * first["closure_m"])
        yield Row(case, "axial stress at first failure", "MPa", stresses[-1])
        yield Row(case, "failed in tension", "1", run.summary["failed_tension"])
    yield Row(f"example 1, {rule}", "stress at first failure, finer over coarser cells, less 1", "1",
              stresses[1] / stresses[0] - 1.0)
