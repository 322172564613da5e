"""Slices through three-dimensional specimens: one layer of particles across each axis."""

from dataclasses import replace

import numpy as np
from matplotlib.collections import PolyCollection
from matplotlib.figure import Figure

from . import output, particles, style

# The axis a slice is normal to, those to the right and up on the picture, from where it is seen.
PLANES = ((2, 0, 1, "from the front"), (0, 2, 1, "from the left"), (1, 0, 2, "from above"))
NAMES = "xyz"
GAP, LEFT = 0.75, 0.75  # inches
NOTE = "A slice is the layer of particles that lay nearest to its plane at step 0."


def draw_modes(result, step=None, planes=None):
    snapshot = result.snapshot(result.steps()[-1] if step is None else step)
    slices = Slices(result, planes)
    caption = style.caption(result, NOTE, *slices.remark(snapshot))
    figure, panels = slices.figure(f"{result.title()}\n{particles.describe(result, snapshot)}",
                                   caption, legend=particles.LEGEND)
    for axes, plane in zip(panels, PLANES):
        layer = slices.layer(snapshot, plane)
        for mode, colour, _ in particles.MODES:
            slices.add_squares(axes, layer, plane, layer.failed == mode, facecolor=colour)
    particles.add_legend(figure, snapshot, caption, " in the whole specimen")
    return figure


def draw_stress(result, step=None, planes=None):
    first_failure = result.first_failure_step()
    snapshot = result.snapshot(particles.eve_step(result, first_failure) if step is None else step)
    slices = Slices(result, planes)
    layers = [slices.layer(snapshot, plane) for plane in PLANES]
    usable = np.concatenate([layer.max_principal_stress[layer.failed == output.INTACT]
                             for layer in layers]) * 1e-6
    limit = particles.stress_limit(usable)
    caption = style.caption(result, NOTE, *slices.remark(snapshot), *particles.stress_caption(
        usable, any(layer.failed.any() for layer in layers)))
    figure, panels = slices.figure(particles.stress_title(result, snapshot, first_failure),
                                   caption, right=1.25)
    for axes, plane, layer in zip(panels, PLANES, layers):
        intact = layer.failed == output.INTACT
        cloud = slices.add_squares(axes, layer, plane, intact, cmap="coolwarm",
                                   array=layer.max_principal_stress[intact] * 1e-6,
                                   clim=(-limit, limit))
        slices.add_squares(axes, layer, plane, ~intact, facecolor=style.FAILED)
    particles.add_stress_bar(figure, panels[-1], cloud, max(panels[0].get_position().height,
                                                            panels[1].get_position().height))
    return figure


class Slices:
    """Three layers of particles, chosen at step 0, and the room they take, in mm."""

    def __init__(self, result, planes=None):
        self.first = particles.first_snapshot(result)
        self.size = particles.pitch(result.case) * 1e3
        position = self.first.position * 1e3
        self.low, self.high = position.min(axis=0) - self.size / 2, \
            position.max(axis=0) + self.size / 2
        middle = np.round((self.low + self.high) / 2, 6) + 0.0  # never -0
        self.at = middle if planes is None else np.array(planes)
        for axis, name in enumerate(NAMES):
            if not self.low[axis] <= self.at[axis] <= self.high[axis]:
                raise output.OutputError(
                    f"the plane {name} = {self.at[axis]:g} mm does not cut the specimen, which "
                    f"reaches from {self.low[axis]:g} to {self.high[axis]:g} mm", output.USAGE)
        self.ids = [self.layer_ids(position[:, axis], self.at[axis]) for axis in range(3)]

    def layer_ids(self, coordinate, plane):
        nearest = coordinate[np.argmin(np.abs(coordinate - plane))]
        return self.first.id[np.abs(coordinate - nearest) < self.size / 2]

    def layer(self, snapshot, plane):
        chosen = np.isin(snapshot.id, self.ids[plane[0]])
        return replace(snapshot, **{name: getattr(snapshot, name)[chosen] for name in (
            "id", "position", "max_principal_stress", "failed", "failure_step")})

    def figure(self, title, caption, legend=0.0, right=0.25):
        """Three pictures of one scale, side by side."""
        margin = 0.02 * (self.high - self.low).max() + self.size / 2
        low, high = self.low - margin, self.high + margin
        extent = high - low
        widths = np.array([extent[right_axis] for _, right_axis, _, _ in PLANES])
        heights = np.array([extent[up_axis] for _, _, up_axis, _ in PLANES])
        scale = min(5.0 / heights.max(), 9.5 / widths.sum())  # inches per mm
        width = LEFT + scale * widths.sum() + 2 * GAP + right
        below = style.caption_height(caption) + legend + particles.AXIS_LABEL
        height = below + scale * heights.max() + 0.35 + style.title_height(title, width)
        figure = Figure(figsize=(width, height))
        style.add_title(figure, title)
        style.add_caption(figure, caption)
        panels, start = [], LEFT
        for plane, wide, tall in zip(PLANES, widths, heights):
            axes = figure.add_axes([start / width, below / height, scale * wide / width,
                                    scale * tall / height])
            self.prepare(axes, plane, low, high)
            panels.append(axes)
            start += scale * wide + GAP
        return figure, panels

    def prepare(self, axes, plane, low, high):
        normal, right, up, seen = plane
        axes.set_xlim(low[right], high[right])
        # Seen from above, the front (+z) is at the bottom.
        axes.set_ylim(*((high[up], low[up]) if up == 2 else (low[up], high[up])))
        axes.set_xlabel(f"{NAMES[right]} (mm)")
        axes.set_ylabel(f"{NAMES[up]} (mm)", labelpad=1)
        axes.set_title(f"{NAMES[normal]} = {self.at[normal]:.3g} mm, {seen}", fontsize=9)

    def add_squares(self, axes, layer, plane, chosen, **options):
        _, right, up, _ = plane
        flat = layer.position[chosen][:, [right, up]] * 1e3
        squares = PolyCollection(particles.squares(flat, self.size), edgecolor="none",
                                 antialiased=False, **options)
        axes.add_collection(squares, autolim=False)
        return squares

    def remark(self, snapshot):
        return particles.remarks(0, snapshot.left_out, self.first.count() - snapshot.count())
