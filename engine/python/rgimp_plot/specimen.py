"""The specimen before anything is computed: particles, flaws, platens, grid."""

import json
import tomllib
from dataclasses import dataclass

import numpy as np
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch, Polygon

from . import flat_shapes, output, particles, slices, style
from .specimen_views import FLAW, GRID, PLATEN, Panel, View, colour

LEGEND_ROW = 0.22  # inches
LEGEND_COLUMNS = 4
LONGEST_NAME = 24  # letters of a material's name; there is no room for more


@dataclass
class Specimen:
    """What `rgimp check --picture` writes; lengths in mm."""
    case: dict
    snapshot: output.Snapshot  # in three dimensions of the three layers in the middle
    particles: int
    grid_low: np.ndarray
    grid_high: np.ndarray
    flaws: list  # of outlines, in the plane alone
    low: np.ndarray  # the bodies' corners
    high: np.ndarray
    body: np.ndarray  # the index of each particle's

    def dimension(self):
        return len(self.low)

    def position(self):
        return self.snapshot.position * 1e3

    def size(self):
        return particles.pitch(self.case) * 1e3

    def materials(self):
        """Names, in the order in which bodies use them."""
        return list(dict.fromkeys(body["material"] for body in self.case["body"]))


def read(directory):
    case = output.read_text(directory / "case.toml", tomllib.loads)
    facts = output.read_text(directory / "specimen.json", json.loads)
    dimension = 3 if case.get("dimension", 2) == 3 else 2
    snapshot = output.read_snapshot(directory / "particles.vtkhdf", 0, dimension)
    try:
        bodies = [flat_shapes.of_body(body, dimension) for body in case["body"]]
        low = np.min([body.low for body in bodies], axis=0)
        high = np.max([body.high for body in bodies], axis=0)
        outside = np.array([body.distance(snapshot.position * 1e3) for body in bodies])
        flaws = [flat_shapes.outline_of_flaw(flaw) for flaw in case.get("flaw", [])
                 if dimension == 2]
        return Specimen(case, snapshot, int(facts["particles"]),
                        np.array(facts["grid_min_m"])[:dimension] * 1e3,
                        np.array(facts["grid_max_m"])[:dimension] * 1e3,
                        flaws, low, high, outside.argmin(axis=0))
    except (ArithmeticError, AttributeError, KeyError, TypeError, ValueError) as error:
        raise output.OutputError(f"{directory} is damaged: {type(error).__name__} {error}") \
            from None


def draw(specimen):
    return (draw_space if specimen.dimension() == 3 else draw_plane)(specimen)


def draw_plane(specimen):
    title, caption = titles(specimen)
    panel = Panel(specimen, 0, 1)
    scale = min(6.0 / panel.extent[1], 8.0 / panel.extent[0])  # inches per mm
    below = style.caption_height(caption) + legend_height(specimen) + particles.AXIS_LABEL
    left, right = 0.8, 0.3
    wide = left + right + scale * panel.extent[0]
    width = max(wide, 5.4)
    height = below + scale * panel.extent[1] + style.title_height(title, width)
    figure = new_figure(width, height, title, caption)
    start = left + (width - wide) / 2
    axes = figure.add_axes([start / width, below / height, scale * panel.extent[0] / width,
                            scale * panel.extent[1] / height])
    panel.prepare(axes)
    panel.draw(axes, np.ones(len(specimen.body), bool), scale)
    for outline in specimen.flaws:
        axes.add_patch(Polygon(outline, closed=True, edgecolor=FLAW, facecolor="none",
                               linewidth=1.2, zorder=4))
    add_legend(figure, specimen, caption)
    return figure


def draw_space(specimen):
    """A view of the outlines, and the three layers in the middle."""
    title, caption = titles(specimen)
    caption.append("A layer is one particle thick.")
    panels = [(Panel(specimen, right, up), normal, seen)
              for normal, right, up, seen in slices.PLANES]
    view = View(specimen)
    widths = [view.extent[0]] + [panel.extent[0] for panel, _, _ in panels]
    heights = [view.extent[1]] + [panel.extent[1] for panel, _, _ in panels]
    scale = min(4.2 / max(heights), 10.5 / sum(widths))
    gap, left, right = 0.65, 0.25, 0.25
    below = style.caption_height(caption) + legend_height(specimen) + particles.AXIS_LABEL
    width = left + right + scale * sum(widths) + gap * (len(widths) - 1)
    height = below + scale * max(heights) + 0.35 + style.title_height(title, width)
    figure = new_figure(width, height, title, caption)
    start = left
    for index, (wide, tall) in enumerate(zip(widths, heights)):
        axes = figure.add_axes([start / width, below / height, scale * wide / width,
                                scale * tall / height])
        if index == 0:
            view.draw(axes)
        else:
            panel, normal, seen = panels[index - 1]
            panel.prepare(axes)
            panel.draw(axes, layer(specimen, normal), scale)
            axes.set_title(f"middle layer, {seen}", fontsize=9)
        start += scale * wide + gap
    add_legend(figure, specimen, caption)
    return figure


def layer(specimen, axis):
    """The particles nearest to the middle."""
    coordinate = specimen.position()[:, axis]
    middle = (coordinate.min() + coordinate.max()) / 2
    nearest = coordinate[np.argmin(np.abs(coordinate - middle))]
    return np.abs(coordinate - nearest) < specimen.size() / 2


def new_figure(width, height, title, caption):
    figure = Figure(figsize=(width, height))
    style.add_title(figure, title)
    style.add_caption(figure, caption)
    return figure


def titles(specimen):
    cells = np.round((specimen.grid_high - specimen.grid_low) /
                     (specimen.case["grid"]["cell_size"] * 1e3)).astype(int)
    per_cell = specimen.case["body"][0].get("particles_per_cell", 2)
    title = str(specimen.case.get("title") or "untitled case")[:output.LONGEST_TITLE]
    return f"{title}\nThe specimen at the start", [
        f"{specimen.particles:,} particles, {per_cell} per cell and axis; grid "
        f"{' x '.join(map(str, cells))} cells of {specimen.case['grid']['cell_size'] * 1e3:.3g} mm."]


def legend_height(specimen):
    return LEGEND_ROW * (1 + (len(legend(specimen)) - 1) // LEGEND_COLUMNS) + 0.1


def legend(specimen):
    # A label that starts with "_" would be left out.
    handles = [Patch(color=colour(index), label=f" {name}"[:LONGEST_NAME])
               for index, name in enumerate(specimen.materials())]
    if specimen.case.get("flaw"):
        handles.append(Line2D([], [], color=FLAW, linewidth=1.2, label="flaw"))
    if specimen.case.get("platen"):
        handles.append(Patch(color=PLATEN, label="platen"))
    return [*handles, Line2D([], [], color=GRID, linewidth=0.8, linestyle="--", label="grid")]


def add_legend(figure, specimen, caption):
    drawn = figure.legend(
        handles=legend(specimen), loc="lower center", ncol=LEGEND_COLUMNS, fontsize=9,
        columnspacing=1.2, borderpad=0,
        bbox_to_anchor=(0.5, style.caption_height(caption) / figure.get_figheight()))
    for text in drawn.get_texts():
        text.set_parse_math(False)  # names of materials are no formulas
