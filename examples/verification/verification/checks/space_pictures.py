"""Pictures of three dimensions."""

import numpy as np
from matplotlib.figure import Figure

from .. import goodier


def draw_hole(path, profiles, ratio):
    """Stress along the load at the equator over the distance from a hole, by resolution:
    `profiles` is cells of a radius -> (distance over radius, stress over the remote one)."""
    figure = Figure(figsize=(7.0, 4.0), layout="constrained")
    axes = figure.subplots()
    for cells, (distance, stress) in profiles.items():
        axes.plot(distance, stress, ".", markersize=3, label=f"radius of {cells} cells")
    exact = np.linspace(1.0, 3.0, 201)
    axes.plot(exact, goodier.equator(exact, ratio), "k-", linewidth=1, label="Goodier")
    axes.set(xlim=(0.95, 3.0), xlabel="distance from the hole's centre, radii",
             ylabel="stress along the load over S", title="Spherical hole: the equator")
    axes.legend()
    figure.savefig(path, dpi=80)
