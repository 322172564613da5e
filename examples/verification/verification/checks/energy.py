"""Energy and momentum: what a run puts in, keeps and loses."""

import numpy as np
from matplotlib.figure import Figure

from rgimp_plot import style

from .. import table
from ..registry import check
from ..study import EXAMPLES
from ..table import Row
from .analytic import BLOCK

ORDER = 60

STORES = (("strain_energy_J", "strain energy", style.INTACT),
          ("kinetic_energy_J", "kinetic energy", "#009e73"),
          ("damping_work_J", "taken by local damping", "#cc79a7"),
          ("viscous_work_J", "taken by bulk viscosity", "#56b4e9"),
          ("released_energy_J", "released by failure", style.TENSION))
SOURCE = "conservation of energy"

ROCK = """
[material.rock]
density = 2600.0
youngs_modulus = 17e9
poisson_ratio = 0.14
"""
FAILURE = """[material.rock.failure]
criterion = "mohr-coulomb"
cohesion = 5.95e6
friction_angle = 40.0
tensile_strength = 2e6
"""
DISKS = """
title = "two disks that graze each other"
[grid]
cell_size = 0.5e-3
min = [-15e-3, -15e-3]
max = [15e-3, 15e-3]
[[body]]
shape = "disk"
center = [-3.5e-3, -1.5e-3]
size = 6e-3
material = "rock"
velocity = [8.0, 3.0]
[[body]]
shape = "disk"
center = [3.5e-3, 1.5e-3]
size = 6e-3
material = "rock"
velocity = [-8.0, 3.0]
""" + ROCK


@check("energy", title="Energy and momentum", minutes=2.5, short=True)
def energy(study, short):
    """The budget: the work W of the platens against the kinetic energy, the strain energy and the
    three sinks, which are the work of local damping, that of bulk viscosity, and the strain energy
    that failing particles drop. `missing` is what is left of W. The strain energy is the sum of
    V sigma : C^-1 : sigma / 2 of small strains; the work of the hypoelastic law differs from it by
    a third of the volume strain. In blocks at 4e-4 that is within the 2e-4 asked for; at the
    contacts of example 3 strains are larger, and a second row takes this part into account.

    Momentum: two disks in free flight that graze each other and turn, whole or breaking. The sums
    are over particles of equal mass, before and after; angular momentum is about the origin."""
    for integrator in ("musl", "usl", "usf"):
        yield from elastic_block(study, integrator)
    for integrator in ("musl", "usl", "usf"):
        yield from momentum(study, integrator, "whole", DISKS)
    yield from momentum(study, "musl", "whole, half the cell size",
                        DISKS.replace("cell_size = 0.5e-3", "cell_size = 0.25e-3"))
    yield from momentum(study, "musl", "breaking", DISKS + FAILURE)
    if not short:
        yield from examples(study)


def missing(history):
    """J, at each row of the history."""
    return history["external_work_J"] - sum(history[column] for column, *_ in STORES)


def elastic_block(study, integrator):
    run = study.run(f"block_{integrator}", BLOCK, f"time.integrator={integrator}",
                    "platen[0].speed=0.005", "platen[1].speed=0.005", "time.step_factor=0.1",
                    "time.steps=20000")
    share = abs(missing(run.history)[-1]) / run.history["external_work_J"][-1]
    yield Row(f"elastic block, {integrator}", "missing / W at a strain of 4e-4", "1", share, 2e-4,
              SOURCE, kind=table.AT_MOST)


def momentum(study, integrator, name, case):
    run = study.run(f"disks_{name}_{integrator}".replace(", ", "_").replace(" ", "_"),
                    case + "[time]\nduration = 2.4e-4\nstep_factor = 0.4\n",
                    f"time.integrator={integrator}")
    case = f"two disks, {name}, {integrator}"
    before, after = run.snapshot(0), run.snapshot()
    size = np.linalg.norm(before["velocity"], axis=1).sum()
    change = np.abs(after["velocity"].sum(axis=0) - before["velocity"].sum(axis=0)).max()
    yield Row(case, "change of linear momentum / sum of |m v|", "1", change / size, 1e-12,
              "conservation of momentum, to round-off", kind=table.AT_MOST)
    yield Row(case, "angular momentum after / before", "1", turn(after) / turn(before))
    if name == "breaking":
        yield Row(case, "failed particles", "1", int((after["failed"] > 0).sum()))


def turn(snapshot):
    x, v = snapshot["position"], snapshot["velocity"]
    return float((x[:, 0] * v[:, 1] - x[:, 1] * v[:, 0]).sum())


def examples(study):
    one = example(study, "single_flaw", 55610, 9000)
    yield from elastic_phase("example 1", one, 9000)
    yield from whole_run("example 1", one)
    disk = example(study, "brazilian_disk", 19008, 16600)
    yield from elastic_phase("example 3", disk, 16600)
    yield from whole_run("example 3", disk)
    yield from whole_run("example 3, no damping",
                         example(study, "brazilian_disk", 19008, 16600, "damping.local=0"))
    draw(study, one)


def example(study, name, steps, eve, *overrides):
    """With a snapshot before the first failure, at step `eve`."""
    return study.run("_".join([name, *overrides]), EXAMPLES / f"{name}.toml",
                     "time.step_factor=0.4", f"time.steps={steps}",
                     f"output.snapshot_every={steps}", f"output.snapshot_steps=[{eve}]", *overrides)


def elastic_phase(case, run, eve):
    history = run.history
    row = int(np.flatnonzero(history["step"] == eve)[0])
    work, stored = history["external_work_J"][row], history["strain_energy_J"][row]
    share = missing(history)[row] / work
    whole = history["failed_tension"][row] + history["failed_shear"][row] == 0
    yield Row(case, "missing / W before the first failure", "1", abs(share) if whole else np.nan,
              2e-4, SOURCE, kind=table.AT_MOST, note=f"step {eve:,}, step factor 0.4")
    yield Row(case, "the same with the work of the hypoelastic law for U", "1",
              abs(share - hypoelastic_excess(run.snapshot(eve)) * stored / work), 2e-4, SOURCE,
              kind=table.AT_MOST, note="V u (1 - tr eps / 3) for V u, in compression more")


def hypoelastic_excess(snapshot):
    """Of the strain energy: what stress times rate of strain has done beyond it, to first order in
    strain. Volumes, almost equal, are taken as equal."""
    modulus, ratio = 17e9, 0.14
    stress = snapshot["stress"]
    trace = stress[:, :3].sum(axis=1)
    square = (stress[:, :3]**2).sum(axis=1) + 2 * (stress[:, 3:]**2).sum(axis=1)
    density = ((1 + ratio) * square - ratio * trace**2) / (2 * modulus)
    volume_strain = (1 - 2 * ratio) * trace / modulus
    return float((-volume_strain / 3 * density).sum() / density.sum())


def whole_run(case, run):
    history = run.history
    work, cracked = history["external_work_J"], history["failed_tension"] > 0
    yield Row(case, "largest missing / W while cracks grow", "1",
              float(np.max(np.abs(missing(history)[cracked]) / work[cracked])), 0.01, SOURCE,
              kind=table.AT_MOST)
    for column, name, _ in STORES:
        yield Row(case, f"share of W at the end: {name}", "1", history[column][-1] / work[-1])


def draw(study, run):
    """Where the work went, stacked, and what is missing."""
    history = run.history
    closure, work = history["closure_m"] * 1e6, history["external_work_J"]
    figure = Figure(figsize=(7.0, 6.4), dpi=90)
    upper, lower = figure.subplots(2, 1, sharex=True, gridspec_kw={
        "height_ratios": [3, 1], "hspace": 0.08, "left": 0.13, "right": 0.97, "bottom": 0.13,
        "top": 0.92})
    known = work > 0
    # In growing order, so that the thin bands are seen beside the strain energy's.
    shares = [100 * history[column][known] / work[known] for column, *_ in STORES[1:]]
    upper.stackplot(closure[known], shares, colors=[colour for *_, colour in STORES[1:]],
                    labels=[name for _, name, _ in STORES[1:]])
    rest = 100 * (1 - history["strain_energy_J"][known] / work[known])
    upper.plot(closure[known], rest, color=style.MARK, linewidth=1.0,
               label="all that is not strain energy: 1 − U / W")
    upper.set_ylim(0, 8)
    upper.set_ylabel("share of the work put in (%)")
    upper.legend(fontsize=8.5, loc="upper right")
    lower.plot(closure[known], 1e4 * missing(history)[known] / work[known], color=style.MARK)
    lower.set_ylim(-10, 10)
    lower.set_ylabel("missing (1e-4 W)")
    lower.set_xlabel("closure of the platens (µm)")
    first = run.summary["first_failure"]["closure_m"] * 1e6
    for axes in (upper, lower):
        axes.axvline(first, color=style.MARK, linewidth=0.7, linestyle=":")
        axes.grid(color="#dddddd", linewidth=0.6)
    style.add_title(figure, "Example 1: where the platens' work went, besides strain energy")
    style.add_caption(figure, style.caption(
        run.result, f"Dotted: first failure. Step factor 0.4. Work at the end {work[-1]:.3g} J/m."))
    figure.savefig(study.picture())
