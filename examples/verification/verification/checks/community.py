"""Problems that codes of the particle family are held against, dynamic ones of given motion."""

import math

from .. import table
from ..registry import check
from ..table import Row
from . import community_pictures as pictures

ORDER = 40
PROGRAM = "bin/verification_community"
SECOND_ORDER = "formal order of weights and leapfrog"
VORTEX = "Kamojjala et al. 2015"


def study_of(study, problem, cells, *arguments):
    """A line of the program for each of `cells` a metre."""
    return [study.lines(PROGRAM, problem, "--cells", count, *arguments)[0] for count in cells]


def orders(lines, key):
    """Observed orders between neighbouring resolutions; NaN where a run stopped."""
    errors = [line.get(key, math.nan) for line in lines]
    cells = [line["cells"] for line in lines]
    return [math.log(errors[i] / errors[i + 1]) / math.log(cells[i + 1] / cells[i])
            for i in range(len(lines) - 1)]


def small_strain_orders(case, lines):
    yield Row(case, "order of the displacement", "1", orders(lines, "displacement_error")[-1], 2.0,
              SECOND_ORDER, 0.15, table.ABSOLUTE)
    yield Row(case, "order of the stress", "1", orders(lines, "stress_error")[-1], 1.0,
              "first order of the gradients of linear weights", kind=table.AT_LEAST)


@check("manufactured", title="Manufactured solutions", minutes=1.5, short=True)
def manufactured(study, short):
    """Motions that are given, with the body force that makes them solutions *of our law*, a
    hypoelastic one with the Jaumann rate; errors are root mean squares over the particles, the
    largest of all steps, over the solution's largest displacement. The axis-aligned square and cube
    have no spin, and the law is Hencky's there. The vortex is simple shear of gamma along each radius, where
    the Jaumann rate gives a shear stress of mu sin(gamma): past gamma = pi / 2, at an amplitude of
    0.22 of the classic 1, it softens, and no code can hold that motion with this law. What uGIMP
    cannot do is keep its order at large strains: its particles keep their size, so that they gap
    and overlap where the solid stretches (Wallstedt & Guilkey 2008; Steffen et al. 2008)."""
    small = study_of(study, "axis-aligned", (8, 16, 32) if short else (8, 16, 32, 64),
                     "--amplitude", 0.001)
    yield from small_strain_orders("axis-aligned, A = 0.001", small)
    cube = study_of(study, "axis-aligned", (8, 16) if short else (8, 16, 32), "--amplitude", 0.001,
                    "--dimension", 3)
    yield from small_strain_orders("axis-aligned cube, A = 0.001", cube)
    force = study.lines(PROGRAM, "vortex-force", "--amplitude", 1e-4)[0]
    yield Row("vortex, A = 0.0001", "tangential body force off the published one", "1",
              force["distance"], 1e-6, VORTEX + ", linear there", kind=table.AT_MOST)
    if short:
        return
    large = study_of(study, "axis-aligned", (8, 16, 32, 64), "--amplitude", 0.05)
    usl = study_of(study, "axis-aligned", (8, 16, 32, 64), "--amplitude", 0.05, "--integrator", "usl")
    for name, lines in (("MUSL", large), ("USL", usl)):
        yield Row(f"axis-aligned, A = 0.05, {name}", "order of the displacement, 16 to 32 cells", "1",
                  orders(lines, "displacement_error")[1], 2.0, SECOND_ORDER, 0.15, table.ABSOLUTE)
        yield Row(f"axis-aligned, A = 0.05, {name}", "order of the displacement, 32 to 64 cells", "1",
                  orders(lines, "displacement_error")[2], 2.0, SECOND_ORDER, 0.15, table.ABSOLUTE,
                  "strains reach 17 %")
    curves = {"axis-aligned, A = 0.001": small, "axis-aligned cube, A = 0.001": cube,
              "axis-aligned, A = 0.05": large,
              "axis-aligned, A = 0.05, USL": usl}
    yield from vortices(study, curves)
    pictures.draw_convergence(study.picture(), curves)


def vortices(study, curves):
    for amplitude in (0.01, 0.1, 0.2, 1.0):
        lines = study_of(study, "vortex", (20, 40, 80), "--amplitude", amplitude)
        shear = study.lines(PROGRAM, "vortex-force", "--amplitude", amplitude)[0]["largest_shear"]
        case = f"vortex, A = {amplitude:g}"
        stopped = [line for line in lines if "stopped" in line]
        note = f"shear reaches {shear:.3g}"
        if stopped:
            note += "; " + stopped[-1]["stopped"].split(";")[0]
        yield Row(case, "resolutions that reach t = 1, of 3", "1", len(lines) - len(stopped), 3,
                  VORTEX + " defines it to t = 1", kind=table.EQUAL, note=note)
        if not stopped:
            curves[case] = lines
            yield Row(case, "order of the displacement, 40 to 80 cells", "1",
                      orders(lines, "displacement_error")[-1], 2.0, SECOND_ORDER, 0.15,
                      table.ABSOLUTE)
            yield Row(case, "displacement error, 80 cells", "1", lines[-1]["displacement_error"])


@check("free_blocks", title="Free blocks", minutes=0.8)
def free_blocks(study, short):
    """What a block in free flight must keep. `spin` turns a square once about its centre, its edges
    at 1 % of the wave speed, while it flies; `vibrate` swings a 1 by 2 m block along its length for
    4,000 steps."""
    for name in ("musl", "usl", "usf"):
        spins = study_of(study, "spin", (8, 16, 32), "--integrator", name)
        case = f"one turn, {name.upper()}"
        yield Row(case, "linear momentum, change over sum |m v|", "1",
                  max(line["linear_momentum"] for line in spins), 1e-12, "conservation",
                  kind=table.AT_MOST)
        yield Row(case, "angular momentum, change at 32 cells", "%",
                  100.0 * spins[-1]["angular_momentum"], 0.0, "conservation", 1.0, table.ABSOLUTE)
        yield Row(case, "order of that change", "1", orders([{**line, "angular_momentum": abs(
            line["angular_momentum"])} for line in spins], "angular_momentum")[-1], 2.0,
            "accelerations are linear in x to second order", 0.3, table.ABSOLUTE)
        yield Row(case, "energy, change at 32 cells", "%", 100.0 * spins[-1]["energy"], 0.0,
                  "conservation", 1.0, table.ABSOLUTE)
        for factor in (0.1, 0.4):
            line = study.lines(PROGRAM, "vibrate", "--cells", 16, "--integrator", name,
                               "--step-factor", factor)[0]
            yield Row(f"4,000 steps, alpha {factor:g}, {name.upper()}", "energy, change", "%",
                      100.0 * line["energy"], 0.0, "conservation", 1.0, table.ABSOLUTE)
