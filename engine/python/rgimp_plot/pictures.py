"""Which pictures an output directory gets."""

from . import curves, output, particles, slices, solids


def of(result, step, planes):
    """Name -> function that draws the figure. `step` and `planes` (mm) are None where not given."""
    return (of_space if result.dimension() == 3 else of_plane)(result, step, planes) | {
        "stress_closure.png": lambda: curves.draw_stress_closure(result),
        "energy.png": lambda: curves.draw_energy(result),
    }


def of_plane(result, step, planes):
    if planes:
        raise output.OutputError("--slices is for three-dimensional runs", output.USAGE)
    return {
        "crack.png": lambda: particles.draw_crack(result, step),
        "stress.png": lambda: particles.draw_stress(result, step),
        "growth.png": lambda: particles.draw_growth(result),
    }


def of_space(result, step, planes):
    return {
        "crack.png": lambda: solids.draw_crack(result, step),
        "slices.png": lambda: slices.draw_modes(result, step, planes),
        "stress.png": lambda: slices.draw_stress(result, step, planes),
        "growth.png": lambda: solids.draw_growth(result),
    }
