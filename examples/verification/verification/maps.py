"""Pictures of fields side by side."""

import numpy as np
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator


def draw_fields(path, x, y, fields, title, unit):
    """Panels of `fields` (title -> values at cell centres x, y in m; nan: nothing there), all on
    one scale but the last, the difference, which has its own."""
    aspect = np.ptp(y) / np.ptp(x)
    figure = Figure(figsize=(10.5, min(7.5, 3.0 * aspect + 1.3)), layout="constrained")
    panels = figure.subplots(1, len(fields), sharey=True)
    names = list(fields)
    scale = np.nanquantile(np.abs(fields[names[0]]), 0.995)
    for axes, name in zip(panels, names):
        limit = scale if name != names[-1] else np.nanquantile(np.abs(fields[name]), 0.995)
        image = axes.imshow(raster(x, y, fields[name]), origin="lower", cmap="coolwarm",
                            vmin=-limit, vmax=limit, interpolation="nearest",
                            extent=1e3 * np.array([x.min(), x.max(), y.min(), y.max()]))
        axes.set(title=name, xlabel="mm")
        figure.colorbar(image, ax=axes, orientation="horizontal", shrink=0.8, label=unit,
                        extend="both", ticks=MaxNLocator(4))
    figure.suptitle(title)
    figure.savefig(path, dpi=80)


def raster(x, y, values):
    """Values at the centres of square cells as an image, nan elsewhere."""
    size = np.diff(np.unique(np.round(x, 9))).min()
    column = np.round((x - x.min()) / size).astype(int)
    row = np.round((y - y.min()) / size).astype(int)
    image = np.full((row.max() + 1, column.max() + 1), np.nan)
    image[row, column] = values
    return image
