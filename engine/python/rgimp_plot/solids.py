"""Views of three-dimensional specimens: the failed particles in space, inside the outline."""

from dataclasses import dataclass

import matplotlib
import numpy as np
from matplotlib.cm import ScalarMappable
from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.colors import ListedColormap, Normalize, to_rgb
from matplotlib.figure import Figure

from . import output, particles, shapes, style
from .camera import Camera, visible_faces

VIEWS = ((25.0, 18.0, "from the front"), (-65.0, 18.0, "from the left"))  # degrees
BRIGHTNESS = np.array([0.82, 1.0, 0.91])  # of faces normal to x, y, z
OUTLINE, HIDDEN = "#555555", "#c4c4c4"
# Without the yellow of its end, which is hard to see on white.
COLOURS = ListedColormap(matplotlib.colormaps["viridis"](np.linspace(0, 0.92, 256)))
NOTE = "Each cube is a failed particle, where it was at step 0."


def draw_crack(result, step=None):
    """Coloured by the step of failure, from two sides."""
    step = result.steps()[-1] if step is None else step
    snapshot = result.snapshot(step)
    space = Space(result)
    failed = space.failed(step, snapshot)
    caption = style.caption(result, NOTE, *space.remark(snapshot))
    counts = [int(np.count_nonzero(failed.mode == mode)) for mode in (output.TENSION, output.SHEAR)]
    title = (f"{result.title()}\nFailed particles, {particles.describe(result, snapshot)}: "
             f"{counts[0]:,} in tension, {counts[1]:,} in shear")
    figure, panels = space.figure([Camera(*view[:2]) for view in VIEWS], title, caption, bar=True)
    steps = failed.failure_step
    norm = Normalize(int(steps.min(initial=step)), max(step, 1))
    for axes, (azimuth, elevation, name) in zip(panels, VIEWS):
        space.draw(axes, Camera(azimuth, elevation), failed, COLOURS(norm(steps))[:, :3])
        axes.set_title(name, fontsize=9)
    box, width = panels[-1].get_position(), figure.get_figwidth()
    bar = figure.colorbar(ScalarMappable(norm, COLOURS), cax=figure.add_axes(
        [box.x1 + 0.15 / width, box.y0 + 0.15 * box.height, 0.16 / width, 0.7 * box.height]))
    bar.set_label("step of failure")
    bar.ax.yaxis.set_major_formatter(lambda value, _: f"{int(value):,}")
    return figure


def draw_growth(result):
    """Coloured by mode. The last snapshot holds the history of all before."""
    last = result.snapshot(result.steps()[-1])
    space = Space(result)
    caption = style.caption(result, NOTE, *space.remark(last))
    steps = particles.growth_steps(result)
    camera = Camera(*VIEWS[0][:2])
    figure, panels = space.figure([camera] * len(steps), result.title(), caption, above=0.4)
    modes = np.array([to_rgb(colour) for _, colour, _ in particles.MODES])
    for axes, step in zip(panels, steps):
        failed = space.failed(step, last)
        space.draw(axes, camera, failed, modes[failed.mode])
        axes.set_title(f"{style.format_step(step)}\n"
                       f"closure {style.format_length(result.closure(step))}", fontsize=9)
    particles.add_legend(figure, last, caption, " at the end" if len(steps) > 1 else "")
    return figure


@dataclass
class Failed:
    """Failed particles."""
    cells: np.ndarray  # whole numbers, (n, 3): the place in the lattice
    failure_step: np.ndarray
    mode: np.ndarray


class Space:
    """The specimen at step 0, in mm, and how it is drawn."""

    def __init__(self, result):
        self.first = particles.first_snapshot(result)
        self.order = np.argsort(self.first.id)
        self.pitch = particles.pitch(result.case) * 1e3
        self.bodies, self.flaws = shapes.read_outlines(result.case)
        self.low, self.high = (1e3 * corner for corner in shapes.bounding_box(self.bodies))

    def failed(self, step, snapshot):
        """Those of a snapshot that had failed at a step."""
        chosen = (snapshot.failed != output.INTACT) & (snapshot.failure_step <= step)
        found = np.searchsorted(self.first.id, snapshot.id[chosen], sorter=self.order)
        rows = self.order[np.minimum(found, len(self.order) - 1)]
        known = self.first.id[rows] == snapshot.id[chosen]
        places = (self.first.position[rows[known]] * 1e3 - self.low) / self.pitch - 0.5
        limit = 1 << 19  # no case has as many
        return Failed(np.clip(np.round(places), -limit, limit).astype(int),
                      snapshot.failure_step[chosen][known], snapshot.failed[chosen][known])

    def figure(self, cameras, title, caption, bar=False, above=0.25):
        """A row of pictures of one scale; above each is room for a line or two."""
        extents = [self.extent(camera) for camera in cameras]
        widths = [high[0] - low[0] for low, high in extents]
        lowest, highest = min(low[1] for low, _ in extents), max(high[1] for _, high in extents)
        scale = min(5.0 / (highest - lowest), 11.0 / sum(widths))  # inches per mm
        gap, left, right = 0.3, 0.3, 1.35 if bar else 0.3
        wide = left + right + gap * (len(widths) - 1) + scale * sum(widths)
        width = max(wide, 6.5)
        below = style.caption_height(caption) + particles.LEGEND + 0.1
        tall = scale * (highest - lowest)
        height = below + tall + above + style.title_height(title, width)
        figure = Figure(figsize=(width, height))
        style.add_title(figure, title)
        style.add_caption(figure, caption)
        panels, start = [], left + (width - wide) / 2
        for low, high in extents:
            panel = scale * (high[0] - low[0])
            axes = figure.add_axes([start / width, below / height, panel / width, tall / height])
            axes.set_xlim(low[0], high[0])
            axes.set_ylim(lowest, highest)
            axes.axis("off")
            panels.append(axes)
            start += panel + gap
        return figure, panels

    def extent(self, camera):
        corners = np.where(shapes.corner_signs() > 0, self.high, self.low)
        places = camera.project(corners)
        room = 0.05 * np.linalg.norm(self.high - self.low)  # for the names of the axes
        return places.min(axis=0) - room, places.max(axis=0) + room

    def draw(self, axes, camera, failed, colours):
        for outline in self.bodies:
            add_outline(axes, camera, outline, HIDDEN, seen=False)
        for outline in self.flaws:
            add_outline(axes, camera, outline, style.MARK, width=0.5)
        owners, corners, normals = visible_faces(failed.cells, camera)
        places = camera.project(self.low + (corners + 0.5) * self.pitch)
        shaded = colours[owners] * BRIGHTNESS[normals][:, None]
        # An edge of the same colour: else rounding to pixels leaves white specks.
        axes.add_collection(PolyCollection(places, facecolor=shaded, edgecolor=shaded,
                                           linewidth=0.1, zorder=1), autolim=False)
        for outline in self.bodies:
            add_outline(axes, camera, outline, OUTLINE, seen=True)
        add_measures(axes, camera, self.low, self.high)

    def remark(self, snapshot):
        removed = self.first.count() - snapshot.count()
        return particles.remarks(0, snapshot.left_out, removed)


def add_measures(axes, camera, low, high):
    """The specimen's edges in mm, at the middles of three of them in view."""
    sign = np.where(camera.towards > 0, 1.0, -1.0)
    middle, half = (low + high) / 2, (high - low) / 2
    for axis, name in enumerate("xyz"):
        # Of the edges along an axis, that one which lies lowest, or for y farthest left.
        others = [other for other in range(3) if other != axis]
        places = []
        for signs in ((1, -1), (-1, 1), (1, 1), (-1, -1)):
            place = middle.copy()
            place[others] += np.array(signs) * half[others]
            places.append(place)
        seen = [place for place in places
                if any((place - middle)[other] * sign[other] > 0 for other in others)]
        flat = [camera.project(place) for place in seen]
        at = min(flat, key=lambda place: place[0] if axis == 1 else place[1])
        away = at - camera.project(middle)
        away = np.array([np.sign(away[0]), 0.0]) if axis == 1 else away / np.linalg.norm(away)
        at = at + 0.035 * np.linalg.norm(2 * half) * away
        axes.text(*at, f"{name}: {2 * half[axis]:g} mm", fontsize=7.5, color=style.MARK,
                  rotation=90 if axis == 1 else 0, ha="center", va="center")


def add_outline(axes, camera, outline, colour, seen=None, width=0.8):
    """Its edges in view, or those that are not, or all."""
    edges = np.stack([outline.start, outline.end], axis=1) * 1e3
    in_view = (outline.normals @ camera.towards > 1e-9).any(axis=1)
    if seen is not None:
        edges = edges[in_view == seen]
    axes.add_collection(LineCollection(camera.project(edges), colors=colour, linewidths=width,
                                       zorder=0 if seen is False else 2), autolim=False)
    if seen is False:
        return
    angles = np.linspace(0, 2 * np.pi, shapes.AROUND + 1)
    circle = np.stack([np.cos(angles), np.sin(angles)], axis=1)
    for center, radius in outline.spheres:
        axes.plot(*(camera.project(center) + radius * circle).T * 1e3, color=colour,
                  linewidth=width)
