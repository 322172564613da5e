"""The history as the page's curves want it."""

import numpy as np
from rgimp_plot import curves

MOST_ROWS = 1500  # more than a screen shows; 0.2 MB of text


def of(result):
    history = result.history
    rows = thinned(history)
    columns = {name: numbers(history[name][rows]) for name in
               ("step", "time_s", "closure_m", "axial_stress_Pa", "failed_tension", "failed_shear")}
    energies = [{"name": name, "colour": colour, "dash": dash,
                 "values": numbers(history[column][rows])}
                for column, name, colour, dash in curves.ENERGIES]
    return {"columns": columns, "energies": energies,
            "energy_unit": "J per m" if result.dimension() == 2 else "J"}


def thinned(history):
    """Evenly, and the peak of the stress whatever happens."""
    count = len(history["step"])
    rows = np.linspace(0, count - 1, min(count, MOST_ROWS)).round().astype(int)
    stress = history["axial_stress_Pa"]
    peak = int(np.argmax(np.where(np.isfinite(stress), stress, -np.inf)))
    return np.unique(np.append(rows, peak))


def numbers(values):
    """For JSON, which knows no NaN: a run that the physics stopped may end with one."""
    return [float(f"{value:.6g}") if np.isfinite(value) else None for value in values]
