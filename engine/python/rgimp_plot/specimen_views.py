"""A specimen from one side, flat, and its outlines in space."""

import numpy as np
from matplotlib.collections import PolyCollection
from matplotlib.patches import Rectangle

from . import particles, shapes, slices, solids, style
from .camera import Camera

# Light, and told apart by those who see no red or green.
MATERIALS = ("#a9cce8", "#f5cf8e", "#c9c3e6", "#bfe3cf", "#d9d9d9", "#f2c4cf")
PLATEN, FLAW, GRID = "#4d4d4d", "#c00d1e", "#8a8a8a"
# Axis and direction outwards.
SIDES = {"left": (0, -1), "right": (0, 1), "bottom": (1, -1), "top": (1, 1), "back": (2, -1),
         "front": (2, 1)}
ROOM = {2: 6.5, 3: 9.0}  # of a platen's arrow and speed, in widths of its bar


def colour(index):
    return MATERIALS[index % len(MATERIALS)]


def speed_text(speed):
    return f"{abs(speed):.4g} m/s" if speed else "held"


class Panel:
    """The specimen seen along one axis: `right` and `up` are those of the picture."""

    def __init__(self, specimen, right, up):
        self.specimen = specimen
        self.axes = [right, up]
        box = specimen.grid_high - specimen.grid_low
        self.thickness = 0.02 * box[self.axes].max()
        self.below, self.above = np.full(2, self.thickness), np.full(2, self.thickness)
        for platen in self.platens():
            axis, outwards = SIDES[platen["side"]]
            room = self.below if outwards < 0 else self.above
            room[self.axes.index(axis)] = ROOM[specimen.dimension()] * self.thickness
        self.low = specimen.grid_low[self.axes] - self.below
        self.high = specimen.grid_high[self.axes] + self.above
        self.extent = self.high - self.low

    def platens(self):
        """Those that are seen from the side."""
        return [platen for platen in self.specimen.case.get("platen", [])
                if SIDES[platen["side"]][0] in self.axes]

    def prepare(self, axes):
        right, up = self.axes
        axes.set_xlim(self.low[0], self.high[0])
        axes.set_ylim(*((self.high[1], self.low[1]) if up == 2 else (self.low[1], self.high[1])))
        axes.set_xlabel(f"{slices.NAMES[right]} (mm)")
        axes.set_ylabel(f"{slices.NAMES[up]} (mm)", labelpad=1)

    def draw(self, axes, chosen, scale):
        size = self.specimen.size()
        # Particles with gaps between them, where there are enough pixels to show some.
        has_gaps = scale * size * 200 > 4
        names = self.specimen.materials()
        for index, body in enumerate(self.specimen.case["body"]):
            flat = self.specimen.position()[chosen & (self.specimen.body == index)][:, self.axes]
            axes.add_collection(PolyCollection(
                particles.squares(flat, 0.8 * size if has_gaps else size), edgecolor="none",
                antialiased=has_gaps,
                facecolor=colour(names.index(body["material"]))), autolim=False)
        corner = self.specimen.grid_low[self.axes]
        axes.add_patch(Rectangle(corner, *(self.specimen.grid_high[self.axes] - corner),
                                 fill=False, edgecolor=GRID, linestyle="--", linewidth=0.8))
        for platen in self.platens():
            self.draw_platen(axes, platen)
        for body in self.specimen.case["body"]:
            self.draw_velocity(axes, body)

    def draw_platen(self, axes, platen):
        """A bar along the specimen's end, an arrow the way it moves, its speed."""
        axis, outwards = SIDES[platen["side"]]
        along, across = self.axes.index(axis), 1 - self.axes.index(axis)
        low, high = self.contact(platen, self.axes[across])
        end = (self.specimen.high if outwards > 0 else self.specimen.low)[axis]
        corner, size = np.zeros(2), np.zeros(2)
        corner[along] = end if outwards > 0 else end - self.thickness
        corner[across], size[along], size[across] = low, self.thickness, high - low
        axes.add_patch(Rectangle(corner, *size, color=PLATEN, linewidth=0, zorder=3))
        edge = (self.specimen.grid_high if outwards > 0 else self.specimen.grid_low)[axis]
        near, far = edge + outwards * self.thickness / 2, edge + outwards * 3 * self.thickness
        point = np.array([[(low + high) / 2] * 2] * 2)
        point[:, along] = (far, near) if platen["speed"] >= 0 else (near, far)
        if platen["speed"]:
            axes.annotate("", xy=point[1], xytext=point[0], zorder=5,
                          arrowprops={"arrowstyle": "-|>", "color": PLATEN, "linewidth": 1.6})
        text = np.array([(low + high) / 2] * 2)
        text[along] = far + outwards * self.thickness / 2 if platen["speed"] else near
        # On the picture; from above the front is at the bottom.
        down = outwards < 0 if self.axes[along] != 2 else outwards > 0
        axes.text(*text, speed_text(platen["speed"]), fontsize=9, color=style.MARK, zorder=5,
                  ha="center", rotation=0 if along == 1 else 90,
                  va=("top" if down else "bottom") if along == 1 else "center")

    def contact(self, platen, across):
        """From where to where a platen touches, along an axis; half widths are along x, for left
        and right along y."""
        if "half_width" in platen and across == (1 if SIDES[platen["side"]][0] == 0 else 0):
            middle = (self.specimen.low[across] + self.specimen.high[across]) / 2
            return middle - platen["half_width"] * 1e3, middle + platen["half_width"] * 1e3
        return self.specimen.low[across], self.specimen.high[across]

    def draw_velocity(self, axes, body):
        velocity = np.array(body.get("velocity", np.zeros(self.specimen.dimension())))[self.axes]
        speed = np.linalg.norm(velocity)
        if speed == 0:
            return
        start = np.array(body["center"])[self.axes] * 1e3
        axes.annotate(speed_text(speed), xytext=start, zorder=5, fontsize=9, color=style.MARK,
                      xy=start + velocity / speed * 6 * self.thickness, ha="center", va="center",
                      arrowprops={"arrowstyle": "-|>", "color": style.MARK, "linewidth": 1.6})


class View:
    """The outlines of a specimen in space, its platens and its grid."""

    def __init__(self, specimen):
        self.specimen = specimen
        self.camera = Camera(*solids.VIEWS[0][:2])
        self.bodies, self.flaws = shapes.read_outlines(specimen.case)
        self.reach = 0.12 * (specimen.grid_high - specimen.grid_low).max()  # of an arrow
        corners = np.where(shapes.corner_signs() > 0, specimen.grid_high, specimen.grid_low)
        places = [self.camera.project(corners)]
        for platen in specimen.case.get("platen", []):
            places.append(self.camera.project(self.arrow(platen)[:1] * 1.02))
        places = np.concatenate(places)
        room = 0.3 * self.reach
        self.low, self.high = places.min(axis=0) - room, places.max(axis=0) + room
        self.extent = self.high - self.low

    def arrow(self, platen):
        """From outside to the platen."""
        axis, outwards = SIDES[platen["side"]]
        near = (self.specimen.low + self.specimen.high) / 2
        near[axis] = (self.specimen.high if outwards > 0 else self.specimen.low)[axis]
        far = near.copy()
        far[axis] += outwards * self.reach
        return np.array([far, near])

    def plate(self, platen):
        """Its corners, (4, 3)."""
        axis, outwards = SIDES[platen["side"]]
        low, high = self.specimen.low.copy(), self.specimen.high.copy()
        low[axis] = high[axis] = (high if outwards > 0 else low)[axis]
        if "half_width" in platen:
            across = 1 if axis == 0 else 0
            middle = (low[across] + high[across]) / 2
            low[across] = middle - platen["half_width"] * 1e3
            high[across] = middle + platen["half_width"] * 1e3
        one, two = [other for other in range(3) if other != axis]
        corners = np.array([low] * 4)
        corners[[1, 2], one] = high[one]
        corners[[2, 3], two] = high[two]
        return corners

    def draw(self, axes):
        axes.set_xlim(self.low[0], self.high[0])
        axes.set_ylim(self.low[1], self.high[1])
        axes.axis("off")
        axes.set_title(solids.VIEWS[0][2], fontsize=9)
        for outline in self.bodies:
            solids.add_outline(axes, self.camera, outline, solids.HIDDEN, seen=False)
        for outline in self.flaws:
            solids.add_outline(axes, self.camera, outline, FLAW, width=0.7)
        for platen in self.specimen.case.get("platen", []):
            self.draw_platen(axes, platen)
        for outline in self.bodies:
            solids.add_outline(axes, self.camera, outline, solids.OUTLINE, seen=True)
        solids.add_measures(axes, self.camera, self.specimen.low, self.specimen.high)

    def draw_platen(self, axes, platen):
        axes.add_collection(PolyCollection([self.camera.project(self.plate(platen))],
                                           facecolor=PLATEN, alpha=0.35, zorder=3), autolim=False)
        ends = self.camera.project(self.arrow(platen))
        if platen["speed"]:
            tip, tail = (1, 0) if platen["speed"] > 0 else (0, 1)
            axes.annotate("", xy=ends[tip], xytext=ends[tail], zorder=5,
                          arrowprops={"arrowstyle": "-|>", "color": PLATEN, "linewidth": 1.4})
        axes.text(*(ends[0] + (0.1 * self.reach, 0)), speed_text(platen["speed"]), fontsize=8,
                  color=style.MARK, ha="left", va="center", zorder=5)
