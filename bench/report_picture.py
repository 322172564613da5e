"""The picture of the sizes: time of a particle-step and start-up over particles."""

import math

import matplotlib

matplotlib.use("Agg")
from matplotlib.figure import Figure  # noqa: E402, the backend comes first

COLOURS = ("#0072b2", "#c00d1e", "#009e73", "#cc79a7")


def draw_sizes(results):
    figure = Figure(figsize=(7.0, 6.2), layout="constrained")
    upper, lower = figure.subplots(2, 1, sharex=True)
    for colour, threads in zip(COLOURS, results.values("threads", "size")):
        label = f"{threads} thread" + ("" if threads == "1" else "s")
        for axes, measure in ((upper, results.nanoseconds), (lower, results.startup_per_million)):
            axes.loglog(*curve(results, measure, threads), "o-", color=colour, label=label)
    upper.set_ylabel("time per particle-step (ns)")
    lower.set_ylabel("start-up (s per million particles)")
    lower.set_xlabel("particles")
    for axes in (upper, lower):
        axes.grid(which="both", color="#dddddd", linewidth=0.6)
        axes.set_axisbelow(True)
        axes.legend(frameon=False)
    return figure


def curve(results, measure, threads):
    """Particles and the measure of them, where there are any."""
    points = []
    for cells in results.values("cells", "size"):
        setting = {"cells": cells, "threads": threads}
        point = (results.number("particles", "size", **setting), measure("size", **setting))
        if None not in point and all(map(math.isfinite, point)):
            points.append(point)
    return tuple(zip(*points)) or ((), ())
