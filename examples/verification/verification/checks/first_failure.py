"""Where and under which load the first particle fails, against finite elements."""

import numpy as np

from .. import table
from ..finite_elements import CELL, FAILURE, Loading, Reference
from ..registry import check
from ..table import Row

ORDER = 21

SIZE = 0.25e-3  # m, four cells across the slots
SPECIMENS = (("example 1", "1_single45_w10_free", Loading()),
             ("example 2", "2_double30_b120_w10_free", Loading(ramp=2.8e-4, duration=4.9e-4)),
             ("example 3", "3_disk_2vert_w10_free", Loading()))


@check("first_failure", title="First failure against finite elements", minutes=1.0)
def first_failure(study, short):
    """Slots of 1 mm with round ends, as the reference has them, at four cells across. The reference
    averages stress over cells of 0.5 mm; where their grid lies moves its load, hence a range. The
    distance is that to the centre of its first cell or of a mirror image, allowed: 1.5 cells.
    A particle is tested here, 0.125 mm wide, and one at a slot's wall carries far more than the mean
    over 0.5 mm: the load lies between the reference's for such means and for its point of largest
    stress on the wall. By the reference's own rule, on the elastic field, the load agrees; those
    rows are with examples 1 and 2."""
    for label, name, loading in SPECIMENS:
        reference = Reference(name)
        expected = reference.meta["first_failure"]
        run = study.run(name, reference.case(SIZE, loading, FAILURE))
        found = run.summary["first_failure"]
        case = f"{label}, L = {SIZE * 1e3:g} mm"
        source = reference.source
        first = expected["clear_of_platens"]["tension"]
        yield Row(case, "mode", "", found["mode"], expected["clear_of_platens"]["first_mode"],
                  source, kind=table.EQUAL)
        yield Row(case, "distance from the reference's first cell", "mm",
                  distance(found["position_m"], first, reference) * 1e3, 1.5 * CELL * 1e3, source,
                  kind=table.AT_MOST, note=place(found["position_m"], first))
        yield Row(case, "nominal stress", "MPa",
                  reference.nominal(found["axial_stress_Pa"] * reference.size[0]) * 1e-6,
                  tuple(expected["tension_range_over_4_grid_offsets_MPa"]), source,
                  kind=table.INSIDE,
                  note=f"at the reference's largest stress on a wall: {wall_load(reference):.3f} MPa")


def distance(position, first, reference):
    """m, to the nearest of the cells that symmetry makes equal."""
    cell = 1e-3 * np.array([first["x_mm"], first["y_mm"]])
    images = [cell, -cell]
    if reference.is_disk:
        images += [cell * (-1.0, 1.0), cell * (1.0, -1.0)]
    return min(float(np.hypot(*(np.asarray(position[:2]) - image))) for image in images)


def wall_load(reference):
    """Nominal stress, MPa, at which the reference's largest s1 on a slot's wall is 2 MPa."""
    peaks = reference.meta["tip_peaks"]["values"].values()
    return 2.0 / max(peak["surface_max_sigma1"]["value_norm"] for peak in peaks)


def place(position, first):
    return (f"at ({position[0] * 1e3:.2f}, {position[1] * 1e3:.2f}) mm; the reference's cell is at "
            f"({first['x_mm']:g}, {first['y_mm']:g}) mm")
