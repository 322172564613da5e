"""Pictures of the particles: cracks, stress, growth."""

import numpy as np
from matplotlib.collections import PolyCollection
from matplotlib.figure import Figure
from matplotlib.patches import Patch

from . import output, style

MODES = ((output.INTACT, style.INTACT, "intact"),
         (output.TENSION, style.TENSION, "failed in tension"),
         (output.SHEAR, style.SHEAR, "failed in shear"))
MAX_PANELS = 6
SCALED = 0.998  # of the particles; a few at crack tips must not wash out the rest
AXIS_LABEL, LEGEND = 0.5, 0.3  # inches under the axes


def draw_crack(result, step=None):
    snapshot = result.snapshot(result.steps()[-1] if step is None else step)
    window = Window(result, [snapshot])
    caption = style.caption(result, *window.remark(snapshot))
    figure, axes = window.figure(f"{result.title()}\n{describe(result, snapshot)}", caption,
                                 legend=LEGEND)
    add_modes(axes, window, snapshot)
    add_legend(figure, snapshot, caption)
    return figure


def draw_stress(result, step=None):
    first_failure = result.first_failure_step()
    snapshot = result.snapshot(eve_step(result, first_failure) if step is None else step)
    intact = snapshot.failed == output.INTACT
    stress = snapshot.max_principal_stress * 1e-6
    limit = stress_limit(stress[intact])

    window = Window(result, [snapshot])
    caption = style.caption(result, *window.remark(snapshot),
                            *stress_caption(stress[intact], not intact.all()))
    figure, axes = window.figure(stress_title(result, snapshot, first_failure), caption,
                                 right=1.25)
    cloud = window.add_squares(axes, snapshot, intact, array=stress[intact], cmap="coolwarm",
                               clim=(-limit, limit))
    window.add_squares(axes, snapshot, ~intact, facecolor=style.FAILED)
    add_stress_bar(figure, axes, cloud, axes.get_position().height)
    return figure


def stress_limit(stress):
    """The end of the colours' scale, of the stress of intact particles."""
    return (float(np.quantile(np.abs(stress), SCALED)) if stress.size else 0.0) or 1.0


def stress_title(result, snapshot, first_failure):
    return (f"{result.title()}\nMaximum principal stress, {describe(result, snapshot)}\n"
            f"{relate_to_failure(snapshot.step, first_failure)}")


def stress_caption(stress, some_failed):
    return (f"Largest value {stress.max():.3g} MPa, smallest {stress.min():.3g} MPa; the scale "
            f"holds {SCALED:.1%} of the intact particles." if stress.size else "",
            "Dark grey: failed." if some_failed else "")


def add_stress_bar(figure, axes, cloud, height):
    """To the right of these axes, as high as a fraction of the figure."""
    box, width = axes.get_position(), figure.get_figwidth()
    bar = figure.colorbar(cloud, extend="both", cax=figure.add_axes(
        [box.x1 + 0.2 / width, box.y0, 0.18 / width, height]))
    bar.set_label("maximum principal stress (MPa), tension positive")


def draw_growth(result):
    snapshots = [result.snapshot(step) for step in growth_steps(result)]
    window = Window(result, snapshots)
    caption = style.caption(result, *window.remark(*snapshots))
    height = min(5.0, 2.6 / window.aspect)
    width = height * window.aspect
    pitch, left, right = max(width, 1.55) + 0.2, 0.75, 0.15
    # A strip of one or two narrow panels still has to hold the legend.
    spare = max(0.0, 6.0 - (left + pitch * len(snapshots) + right))
    total_width = left + pitch * len(snapshots) + right + spare
    below = style.caption_height(caption) + LEGEND + AXIS_LABEL
    total_height = below + height + 0.4 + style.title_height(result.title(), total_width)
    figure = Figure(figsize=(total_width, total_height))
    style.add_title(figure, result.title())
    style.add_caption(figure, caption)
    for index, snapshot in enumerate(snapshots):
        start = left + spare / 2 + index * pitch + (pitch - 0.2 - width) / 2
        axes = figure.add_axes([start / total_width, below / total_height,
                                width / total_width, height / total_height])
        window.prepare(axes, labels=index == 0)
        add_modes(axes, window, snapshot)
        axes.set_title(f"{style.format_step(snapshot.step)}\n"
                       f"closure {style.format_length(result.closure(snapshot.step))}",
                       fontsize=9)
    add_legend(figure, snapshots[-1], caption, " at the end" if len(snapshots) > 1 else "")
    return figure


def growth_steps(result):
    """At most six: the first, the last, between them those the case lists, else even ones."""
    steps = result.steps()
    between = [step for step in steps[1:-1] if step in result.wanted_steps()]
    if not between:
        first_failure = result.first_failure_step() or 0
        between = [step for step in steps[1:-1] if step >= first_failure]
    room = MAX_PANELS - 2
    if len(between) > room:
        picks = np.linspace(0, len(between) - 1, room + 2)[1:-1].round().astype(int)
        between = [between[pick] for pick in picks]
    return sorted({steps[0], *between, steps[-1]})


def eve_step(result, first_failure):
    """The last snapshot before or at the first failure, else the last one."""
    steps = result.steps()
    if first_failure is None:
        return steps[-1]
    before = [step for step in steps if step <= first_failure]
    # A specimen at rest shows nothing: the next one then, and the title says so.
    if before and result.snapshot(before[-1]).max_principal_stress.any():
        return before[-1]
    after = [step for step in steps if step > first_failure]
    return after[0] if after else before[-1]


def relate_to_failure(step, first_failure):
    if first_failure is None:
        return "nothing failed"
    if step == first_failure:
        return "the step of the first failure"
    if step < first_failure:
        return f"{first_failure - step:,} steps before the first failure (step {first_failure:,})"
    return f"{step - first_failure:,} steps after the first failure (step {first_failure:,})"


def describe(result, snapshot):
    return (f"{style.format_step(snapshot.step)}, "
            f"closure {style.format_length(result.closure(snapshot.step))}")


def add_modes(axes, window, snapshot):
    for mode, colour, _ in MODES:
        window.add_squares(axes, snapshot, snapshot.failed == mode, facecolor=colour)


def add_legend(figure, snapshot, caption, when=""):
    """The modes that occur, with counts, above the small print."""
    counts = {mode: int(np.count_nonzero(snapshot.failed == mode)) for mode, _, _ in MODES}
    handles = [Patch(color=colour, label=f"{counts[mode]:,} {name}{when}")
               for mode, colour, name in MODES if counts[mode]]
    if counts[output.INTACT] == len(snapshot.failed) > 0:
        handles.append(Patch(color="none", label=f"0 failed{when}"))
    figure.legend(handles=handles, loc="lower center", ncol=3, fontsize=9, columnspacing=1.2,
                  borderpad=0,
                  bbox_to_anchor=(0.5, style.caption_height(caption) / figure.get_figheight()))


class Window:
    """The part of the plane a picture shows, in mm, and the size of a particle."""

    def __init__(self, result, snapshots):
        first = first_snapshot(result)
        self.size = particle_size(first.position, result.case) * 1e3
        self.particles = first.count()
        low, high = first.position.min(axis=0), first.position.max(axis=0)
        for snapshot in snapshots:
            if snapshot.position.size == 0:
                continue
            # A few fragments that fly off must not shrink the specimen.
            low = np.minimum(low, np.quantile(snapshot.position, 0.002, axis=0))
            high = np.maximum(high, np.quantile(snapshot.position, 0.998, axis=0))
        low, high = low * 1e3 - self.size / 2, high * 1e3 + self.size / 2
        margin = 0.02 * (high - low).max() + self.size / 2
        self.low, self.high = low - margin, high + margin
        width, height = self.high - self.low
        self.aspect = float(width / height)

    def figure(self, title, caption, legend=0.0, right=0.25):
        """One picture, with title and small print, and its axes."""
        height = min(6.5, 8.5 / self.aspect)
        width = height * self.aspect
        left = 0.8
        total_width = max(left + width + right, 5.4)
        below = style.caption_height(caption) + legend + AXIS_LABEL
        total_height = below + height + style.title_height(title, total_width)
        figure = Figure(figsize=(total_width, total_height))
        start = left + (total_width - left - width - right) / 2
        axes = figure.add_axes([start / total_width, below / total_height,
                                width / total_width, height / total_height])
        self.prepare(axes)
        style.add_title(figure, title)
        style.add_caption(figure, caption)
        return figure, axes

    def prepare(self, axes, labels=True):
        axes.set_xlim(self.low[0], self.high[0])
        axes.set_ylim(self.low[1], self.high[1])
        axes.set_aspect("equal")
        if labels:
            axes.set_xlabel("x (mm)")
            axes.set_ylabel("y (mm)")
        else:
            axes.tick_params(labelleft=False, labelbottom=False)

    def add_squares(self, axes, snapshot, chosen, **options):
        collection = PolyCollection(squares(snapshot.position[chosen] * 1e3, self.size),
                                    edgecolor="none", antialiased=False, **options)
        axes.add_collection(collection, autolim=False)
        return collection

    def remark(self, *snapshots):
        """Says how many particles the picture leaves out and why, where it does."""
        outside = max(int(((snapshot.position * 1e3 < self.low) |
                           (snapshot.position * 1e3 > self.high)).any(axis=1).sum())
                      for snapshot in snapshots)
        lost = max(snapshot.left_out for snapshot in snapshots)
        removed = max(self.particles - snapshot.count() for snapshot in snapshots)
        return remarks(outside, lost, removed)


def remarks(outside, lost, removed):
    lines = []
    if outside:
        lines.append(f"{outside:,} particles lie outside the picture.")
    if lost:
        lines.append(f"{lost:,} particles are left out: their position or stress is not a finite "
                     "number.")
    if removed > 0:
        lines.append(f"{removed:,} particles left the grid and were taken out.")
    return lines


def squares(position, size):
    """Corners of squares around (n, 2) positions, (n, 4, 2)."""
    # Three per cent larger than a particle: else rounding to pixels leaves white specks.
    corners = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]]) * (1.03 * size / 2)
    return position[:, None, :] + corners


def first_snapshot(result):
    """That of step 0, which must have something to draw."""
    first = result.snapshot(result.steps()[0])
    if first.position.size == 0:
        raise output.OutputError(f"no particle of the first snapshot, step {first.step}, has a "
                                 "finite position and stress")
    return first


def particle_size(position, case):
    """The pitch, m: the median distance to the nearest neighbour, over a sample."""
    sample = position[np.linspace(0, len(position) - 1, min(len(position), 101)).astype(int)]
    distances = []
    for point in sample:
        squared = ((position - point) ** 2).sum(axis=1)
        others = squared[squared > 0]
        if others.size:
            distances.append(np.sqrt(others.min()))
    return float(np.median(distances)) if distances else pitch(case)


def pitch(case):
    """The same, m, of the case's lattice."""
    try:
        return case["grid"]["cell_size"] / case["body"][0].get("particles_per_cell", 2)
    except (KeyError, IndexError, TypeError):
        raise output.OutputError("case.toml does not give grid.cell_size") from None
