"""Curves over the history: stress against closure, energies over time."""

import numpy as np
from matplotlib.figure import Figure

from . import style

ENERGIES = (("external_work_J", "work of platens and body force", "#000000", "-"),
            ("strain_energy_J", "strain energy", "#0072b2", "-"),
            ("kinetic_energy_J", "kinetic energy", "#009e73", "-"),
            ("damping_work_J", "taken by local damping", "#cc79a7", "--"),
            ("viscous_work_J", "taken by bulk viscosity", "#56b4e9", "-."),
            ("released_energy_J", "released by failure", "#c00d1e", ":"))


def draw_stress_closure(result):
    history = result.history
    wide = np.abs(history["closure_m"]).max() >= 1e-3
    scale, unit = (1e3, "mm") if wide else (1e6, "µm")
    closure = history["closure_m"] * scale
    stress = history["axial_stress_Pa"] * 1e-6
    figure, (upper, lower) = two_panels(result, style.caption(result))

    upper.plot(closure, stress, color=style.INTACT, marker=marker(closure))
    first = result.first_failure_step()
    if first is not None:
        x = result.closure(first) * scale
        y = np.interp(first, history["step"], stress)
        upper.plot(x, y, "v", color=style.TENSION, markersize=8,
                   label=f"first failure: {y:.3g} MPa at {x:.4g} {unit}, step {first:,}")
        for axes in (upper, lower):
            axes.axvline(x, color=style.MARK, linewidth=0.7, linestyle=":")
    peak = int(np.argmax(np.where(np.isfinite(stress), stress, -np.inf)))
    upper.plot(closure[peak], stress[peak], "^", color=style.MARK, markersize=8,
               label=f"peak: {stress[peak]:.3g} MPa, {format_reaction(result, peak)}, at "
                     f"{closure[peak]:.4g} {unit}, step {int(history['step'][peak]):,}")
    upper.set_ylabel("axial stress (MPa),\ncompression positive")
    upper.legend(fontsize=8.5)

    for column, colour, name, dash in (
            ("failed_tension", style.TENSION, "in tension", "-"),
            ("failed_shear", style.SHEAR, "in shear", "--")):
        lower.plot(closure, history[column], dash, color=colour, marker=marker(closure),
                   label=f"{name}: {int(history[column][-1]):,}")
    lower.set_ylabel("failed particles")
    lower.set_ylim(bottom=0, top=None if history["failed_tension"][-1] +
                   history["failed_shear"][-1] else 1)
    lower.set_xlabel(f"closure of the platens ({unit})")
    lower.legend(fontsize=8.5, loc="upper left")
    return figure


def format_reaction(result, row):
    """Of the platens, in two dimensions for a metre of thickness."""
    newtons = result.history["reaction_N"][row]
    return f"{newtons * 1e-3:.3g} " + ("kN/m" if result.dimension() == 2 else "kN")


def draw_energy(result):
    history = result.history
    time = history["time_s"] * 1e3
    error, reference = energy_error(history)
    first = result.first_failure_step()
    figure, (upper, lower) = two_panels(result, style.caption(
        result,
        f"Energy error: (work − all other energies, less its value at the start) / {reference}.",
        f"Dotted: first failure, step {first:,}." if first is not None else ""))
    for column, name, colour, dash in ENERGIES:
        upper.plot(time, history[column], dash, color=colour, label=name, marker=marker(time))
    upper.set_ylabel("energy (J per m of thickness)" if result.dimension() == 2 else "energy (J)")
    upper.legend(fontsize=8.5)

    lower.plot(time, error * 100, color=style.MARK, marker=marker(time),
               label=f"at the end: {error[-1] * 100:.2g} %")
    lower.axhline(0, color="#999999", linewidth=0.7)
    lower.set_ylabel("energy error (%)")
    lower.set_xlabel("time (ms)")
    lower.legend(fontsize=8.5)
    if first is not None:
        at = np.interp(first, history["step"], time)
        for axes in (upper, lower):
            axes.axvline(at, color=style.MARK, linewidth=0.7, linestyle=":")
    return figure


def energy_error(history):
    work = np.abs(history["external_work_J"])
    reference, name = work[np.isfinite(work)].max(initial=0.0), "largest work"
    start = max(history[column][0] for column, *_ in ENERGIES[1:])
    if start > reference:
        reference, name = start, "largest energy at the start"
    if reference == 0:
        reference, name = 1.0, "1 (all energies are zero)"
    with np.errstate(invalid="ignore"):  # the last row of a run that the physics stopped
        residual = history["external_work_J"] - sum(history[column] for column, *_ in ENERGIES[1:])
    return (residual - residual[0]) / reference, name


def two_panels(result, caption):
    width, height = 7.0, 6.2
    figure = Figure(figsize=(width, height))
    panels = figure.subplots(2, 1, sharex=True, gridspec_kw={
        "height_ratios": [2, 1], "left": 0.14, "right": 0.97, "hspace": 0.08,
        "bottom": (style.caption_height(caption) + 0.5) / height,
        "top": 1 - style.title_height(result.title(), width) / height})
    style.add_title(figure, result.title())
    style.add_caption(figure, caption)
    for axes in panels:
        axes.grid(color="#dddddd", linewidth=0.6)
        axes.set_axisbelow(True)
    return figure, panels


def marker(values):
    """A curve of one point is invisible without."""
    return "o" if len(values) == 1 else None
