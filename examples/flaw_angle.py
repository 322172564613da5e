#!/usr/bin/env python3
"""The angle of a flaw against the stress at which the specimen starts to crack, and the peak.

Usage: flaw_angle.py [--steps N] [--cell M] [--picture FILE]

1. A case from a file, with the flaw's angle, and coarser cells so that it takes a minute.
2. Run until the steps are done, looking at the history every 100 steps.
3. A table, and a picture where one is asked for.
"""

import argparse
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np

import rgimp

ANGLES = [0, 15, 30, 45, 60, 75]  # degrees from +x; the load is along y
MPA = 1e6


def simulate(angle, arguments):
    """Axial stress at first failure and at its peak, MPa; nan where nothing failed."""
    case = rgimp.read_case(Path(__file__).with_name("single_flaw.toml"),
                           [f"flaw[0].angle={angle}", f"grid.cell_size={arguments.cell}",
                            "flaw[0].width=3e-3", f"time.steps={arguments.steps}",
                            "output.snapshot_steps=[]"])
    for platen in case.platens:
        platen.speed *= 10  # faster than the example: this is about the way, not the figures
    case.tuning.threads = 1  # as many cases at once as there are cores
    simulation = rgimp.Simulation(case)
    simulation.run_until(arguments.steps)  # other threads go on meanwhile
    first = simulation.first_failure()
    stress = first.axial_stress if first else np.nan
    return stress / MPA, simulation.peak_axial_stress() / MPA


def draw(results, path):
    import matplotlib
    matplotlib.use("Agg")
    from matplotlib import pyplot
    figure, axes = pyplot.subplots(figsize=(6, 4), layout="constrained")
    axes.plot(ANGLES, results[:, 1], "o-", label="peak")
    axes.plot(ANGLES, results[:, 0], "s--", label="first failure")
    axes.set(xlabel="angle of the flaw from horizontal, degrees", ylabel="axial stress, MPa")
    axes.legend()
    figure.savefig(path, dpi=150)
    print(f"Picture: {path}")


def main():
    parser = argparse.ArgumentParser(description="Flaw angle against cracking and peak stress.")
    parser.add_argument("--steps", type=int, default=20000)
    parser.add_argument("--cell", type=float, default=1e-3, help="m")
    parser.add_argument("--picture", type=Path)
    arguments = parser.parse_args()
    with ThreadPoolExecutor(rgimp.describe_machine().threads) as pool:
        results = np.array(list(pool.map(lambda angle: simulate(angle, arguments), ANGLES)))
    print("angle, degrees   first failure, MPa   peak, MPa")
    for angle, (first, peak) in zip(ANGLES, results):
        print(f"{angle:14}   {first:18.2f}   {peak:9.2f}")
    if arguments.picture:
        draw(results, arguments.picture)


if __name__ == "__main__":
    main()
