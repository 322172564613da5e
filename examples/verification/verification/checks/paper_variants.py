"""The paper's examples with other numbers of particles, slot widths and time steps."""

import numpy as np
from matplotlib.figure import Figure
from rgimp_plot import output, particles, style

from .. import table
from ..cracks import Cracks
from ..registry import check
from ..study import EXAMPLES
from ..table import Row

ORDER = 41
DPI = 75
PAPER_CELL, PAPER_STEPS = 0.5e-3, 55610  # at alpha = 0.4
# 100 mm over whole numbers of cells, so that both platens lie on grid lines.
CELLS_HIGH = {"7/8 of the particles": (187, 0.875), "3/4 of the particles": (173, 0.75),
              "finer": (250, None)}
FIGURE = "paper, Fig. 16"


@check("paper_variants", title="The paper's examples at other resolutions, slot widths, time steps",
       minutes=5)
def paper_variants(study, short):
    """Example 1 with 7/8 and 3/4 of the particles (the paper's Fig. 16) and with finer cells; the
    slot keeps its 1.5 mm. Then examples 1 and 2 with slots two cells wide, as the paper's pictures
    show them: such a slot still carries load, its faces outline themselves with failed particles.
    Then example 2, for what follows once the specimen is split. All at alpha = 0.4: a step stands for four
    of the paper's."""
    base = run_example(study, "resolution_base", "single_flaw", PAPER_STEPS)
    yield from resolutions(study, base)
    yield from paper_widths(study)
    yield from end_of_example_2(study)


def run_example(study, name, example, steps, *overrides):
    return study.run(name, EXAMPLES / f"{example}.toml", "time.step_factor=0.4",
                     f"time.steps={steps}", "output.snapshot_steps=[]", *overrides)


def resolutions(study, base):
    runs = {"0.5 mm cells": base}
    for name, (cells, _) in CELLS_HIGH.items():
        cell = 0.1 / cells
        runs[name] = run_example(study, f"resolution_{cells}", "single_flaw",
                                 round(PAPER_STEPS * PAPER_CELL / cell),
                                 f"grid.cell_size={cell!r}")
    count = base.summary["particles"]
    reference = Cracks(study, base)
    for name, run in runs.items():
        case = f"example 1, {name}"
        cracks = Cracks(study, run)
        ratio = CELLS_HIGH.get(name, (None, None))[1]
        if ratio:
            yield Row(case, "particles over those of 0.5 mm cells", "1",
                      run.summary["particles"] / count, ratio, FIGURE, 0.005, table.RELATIVE)
        yield Row(case, "tips with a wing", "", cracks.tips(), "A, B", FIGURE, kind=table.EQUAL)
        yield Row(case, "platens reached", "", cracks.sides("A", "B"), "bottom, top", FIGURE,
                  kind=table.EQUAL)
        yield Row(case, "closure at the first failure", "µm",
                  1e6 * run.summary["first_failure"]["closure_m"])
        yield Row(case, "wing A off the load over its first 5 mm", "degrees",
                  cracks.angle_to_load("A", 5e-3))
        yield Row(case, "closure with wing A 30 mm above the middle", "µm",
                  closure_at_height(run, cracks, "A", 30e-3))
        if run is not base:
            yield Row(case, "wing A beside that of 0.5 mm cells, mean over y = 8 to 45 mm", "mm",
                      1e3 * path_distance(cracks, reference, "A"))
        yield Row(case, "failed particles along faces of the flaw", "1", cracks.outline)
        yield Row(case, "failed particles connected to no flaw", "1", cracks.elsewhere)
        yield Row(case, "failed in shear", "1", run.summary["failed_shear"])
    figure = draw_side_by_side({name: run.result for name, run in runs.items()})
    output.save_picture(figure, study.picture("resolution"), DPI)


def closure_at_height(run, cracks, name, height):
    step = cracks.step_at_height(name, height)
    return None if step is None else 1e6 * run.result.closure(step)


def path(cracks, name, heights):
    """x (m) of a wing's front as it passed these heights."""
    front = [entry["position_m"] for entry in cracks.wings[name]["front"]]
    y = np.maximum.accumulate([position[1] for position in front])
    return np.interp(heights, y, [position[0] for position in front])


def path_distance(cracks, reference, name):
    """Mean distance of two wings along x, m."""
    heights = np.linspace(8e-3, 45e-3, 75)
    if name not in cracks.wings or name not in reference.wings:
        return float("nan")
    return float(np.abs(path(cracks, name, heights) - path(reference, name, heights)).mean())


def paper_widths(study):
    for example, name, steps, width, tips, ends in (
            ("example 1", "single_flaw", 55610, 1.0e-3, "A, B", {"A": "top", "B": "bottom"}),
            ("example 2", "double_flaw", 49968, 1.4e-3, "A, B, C, D",
             {"A": "top", "D": "bottom"})):
        flaws = len(tips.split(", ")) // 2
        run = run_example(study, f"width_{name}", name, steps,
                          *(f"flaw[{flaw}].width={width}" for flaw in range(flaws)))
        cracks = Cracks(study, run)
        case = f"{example}, slots of {1e3 * width:g} mm"
        yield Row(case, "tips with a wing", "", cracks.tips(), tips, "paper, Figs. 6, 10",
                  kind=table.EQUAL)
        for wing, side in ends.items():
            yield Row(case, f"platen reached by wing {wing}", "", cracks.sides(wing), side,
                      "paper, Figs. 6, 10", kind=table.EQUAL)
        yield Row(case, "first failure, in steps of alpha = 0.1", "step",
                  4 * run.summary["first_failure"]["step"])
        yield Row(case, "wing A off the load over its first 5 mm", "degrees",
                  cracks.angle_to_load("A", 5e-3))
        yield Row(case, "failed particles", "1", cracks.failed)
        yield Row(case, "failed particles along faces of flaws", "1", cracks.outline)
        yield Row(case, "cracks besides the first of each tip", "1",
                  len(cracks.wings) - len(tips.split(", ")))
        output.save_picture(particles.draw_crack(run.result), study.picture(f"width_{name}"), DPI)


def end_of_example_2(study):
    run = run_example(study, "double_flaw", "double_flaw", 49968)
    cracks = Cracks(study, run)
    case = "example 2, alpha = 0.4"
    second = cracks.second_cracks()
    merged = cracks.meeting("B", "C")
    yield Row(case, "first failure, in steps of alpha = 0.1", "step",
              4 * run.summary["first_failure"]["step"])
    yield Row(case, "B and C meet, in steps of alpha = 0.1", "step", merged and 4 * merged)
    yield Row(case, "platens reached by A and D", "", cracks.sides("A", "D"))
    yield Row(case, "second cracks from a tip", "1", len(second))
    yield Row(case, "length of the longest second crack", "mm", 1e3 * max(
        (cracks.wings[name]["front"][-1]["length_m"] for name in second), default=0.0))
    yield Row(case, "failed particles", "1", cracks.failed)


def draw_side_by_side(results):
    """The last snapshot of each run, with its number of particles."""
    first = next(iter(results.values()))
    caption = style.caption(first)
    height, width, gap, left = 5.0, 2.6, 0.2, 0.75
    total_width = left + (width + gap) * len(results) + 0.1
    below = style.caption_height(caption) + particles.AXIS_LABEL
    total_height = below + height + 0.75
    figure = Figure(figsize=(total_width, total_height))
    style.add_title(figure, first.title())
    style.add_caption(figure, caption)
    for index, (name, result) in enumerate(results.items()):
        snapshot = result.snapshot(result.steps()[-1])
        window = particles.Window(result, [snapshot])
        axes = figure.add_axes([(left + index * (width + gap)) / total_width,
                                below / total_height, width / total_width,
                                height / total_height])
        window.prepare(axes, labels=index == 0)
        particles.add_modes(axes, window, snapshot)
        axes.set_title(f"{name}\n{len(snapshot.position):,} particles", fontsize=9)
    return figure
