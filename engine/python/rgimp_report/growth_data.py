"""Which particles failed when, for the drawing with the slider. Lengths in mm."""

import base64

import numpy as np
from rgimp_plot import flat_shapes, output, particles, shapes

MOST_FRAMES = 300
MOST_PARTICLES = 150_000  # 20 bytes each on the page; of more an even sample is drawn


def of(result):
    """The last snapshot holds the steps of all failures."""
    first = particles.first_snapshot(result)
    last_step = result.steps()[-1]
    last = result.snapshot(last_step)
    chosen = np.flatnonzero(last.failed != output.INTACT)
    chosen = chosen[np.argsort(last.failure_step[chosen], kind="stable")]
    steps, modes = last.failure_step[chosen], last.failed[chosen]
    drawn = sample(len(chosen))
    places = where_they_were(first, last, chosen[drawn])
    bodies, flaws = outlines(result, first)
    corners = np.concatenate(bodies).reshape(-1, result.dimension())
    return {"dimension": result.dimension(), "frames": frames(result, steps, modes, last_step),
            "size": particles.particle_size(first.position, result.case) * 1e3,
            "drawn": len(drawn), "failed": len(chosen),
            "low": corners.min(axis=0).tolist(), "high": corners.max(axis=0).tolist(),
            "bodies": [rounded(body) for body in bodies], "flaws": [rounded(f) for f in flaws],
            "place": encode(places * 1e3, "<f4"), "step": encode(steps[drawn], "<i4"),
            "mode": encode(modes[drawn], "<u1")}


def sample(count):
    return np.unique(np.linspace(0, count - 1, min(count, MOST_PARTICLES)).astype(int)) \
        if count else np.empty(0, int)


def where_they_were(first, last, rows):
    """At step 0, m: a burst specimen's cracks lie where they came up. Where not known, as now."""
    order = np.argsort(first.id)
    found = np.searchsorted(first.id, last.id[rows], sorter=order)
    found = order[np.minimum(found, len(order) - 1)]
    known = first.id[found] == last.id[rows]
    return np.where(known[:, None], first.position[found], last.position[rows])


def frames(result, steps, modes, last_step):
    """Even ones over the run, half of them from the first failure on, and all snapshots."""
    start = int(steps[0]) if len(steps) else 0
    wanted = np.concatenate([np.linspace(0, last_step, MOST_FRAMES // 3),
                             np.linspace(start, last_step, MOST_FRAMES // 2)]).round()
    chosen = np.unique(np.append(wanted.astype(int), result.steps()[-MOST_FRAMES:]))
    history = result.history
    stress = np.interp(chosen, history["step"], history["axial_stress_Pa"])
    failed = {mode: np.searchsorted(steps[modes == mode], chosen, side="right")
              for mode in (output.TENSION, output.SHEAR)}
    return [{"step": int(step), "closure": finite(result.closure(step)),
             "stress": finite(stress[row]), "tension": int(failed[output.TENSION][row]),
             "shear": int(failed[output.SHEAR][row])} for row, step in enumerate(chosen)]


def finite(value):
    return float(value) if np.isfinite(value) else None


def outlines(result, first):
    """Of bodies and flaws: closed lines in the plane, pairs of ends in space."""
    if result.dimension() == 3:
        return tuple([edges(outline) for outline in group]
                     for group in shapes.read_outlines(result.case))
    try:
        bodies = [outline_of_body(body) for body in result.case["body"]]
        flaws = [flat_shapes.outline_of_flaw(flaw) for flaw in result.case.get("flaw", [])]
    except (ArithmeticError, AttributeError, KeyError, TypeError, ValueError) as error:
        raise output.OutputError("case.toml is damaged: its bodies or flaws cannot be drawn: "
                                 f"{type(error).__name__} {error}") from None
    if not np.isfinite(np.concatenate(bodies + flaws)).all():
        raise output.OutputError("case.toml is damaged: a body or flaw has no finite size")
    return bodies, flaws


def outline_of_body(body):
    """In the plane a disk is as a circle among the flaws."""
    if body["shape"] == "disk":
        body = {"shape": "circle", "center": body["center"], "length": body["size"]}
    return flat_shapes.outline_of_flaw(body)


def edges(outline):
    """(2 n, 3): start, end, start, end, ...; of spheres three great circles."""
    pairs = [np.stack([outline.start, outline.end], axis=1).reshape(-1, 3)]
    angles = np.linspace(0, 2 * np.pi, shapes.AROUND + 1)
    circle = np.stack([np.cos(angles), np.sin(angles), 0 * angles], axis=1)
    ends = np.stack([circle[:-1], circle[1:]], axis=1).reshape(-1, 3)
    for center, radius in outline.spheres:
        pairs += [center + radius * np.roll(ends, turn, axis=1) for turn in range(3)]
    return np.concatenate(pairs) * 1e3


def rounded(points):
    return np.round(points, 4).tolist()


def encode(values, kind):
    return base64.b64encode(np.ascontiguousarray(values, dtype=kind).tobytes()).decode()
