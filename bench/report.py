#!/usr/bin/python3
"""Turns the JSON of the benchmark programs into a page of tables and a picture."""

import argparse
import json
import os
import sys
from pathlib import Path

import report_tables as tables
from report_data import ReportError, Results, read

PROGRAM = "report.py"


def parse_arguments():
    parser = argparse.ArgumentParser(prog=PROGRAM, description=__doc__)
    parser.add_argument("inputs", type=Path, nargs="+", metavar="JSON",
                        help="written by --benchmark_out, or by --data; of one machine and build")
    parser.add_argument("--page", type=Path, required=True, help="the tables, Markdown")
    parser.add_argument("--picture", type=Path, required=True,
                        help="time over particles, if sizes were measured")
    parser.add_argument("--data", type=Path, required=True, help="all inputs in one JSON")
    return parser.parse_args()


def page(context, results, picture):
    """`picture` is its address on the page, or None."""
    parts = ["# Benchmark results", tables.machine(context, results.repetitions)]
    failures = [f"- `{result.name}`: {result.error}" for result in results.all if result.error]
    if failures:
        parts += ["## Failed", "\n".join(failures)]
    if results.of("fma") or results.of("triad"):
        parts += ["## Peaks", tables.PEAKS_TEXT, tables.peaks(results)]
    if results.of("step"):
        parts += ["## Steps of example 1", tables.STEPS_TEXT, *tables.steps(results, "step")]
    if results.of("cube"):
        parts += ["## Steps in three dimensions", tables.CUBES_TEXT, *tables.steps(results, "cube")]
    if results.of("kernel"):
        parts += ["## Kernels", tables.KERNELS_TEXT, tables.kernels(results)]
    if results.of("size"):
        parts += ["## Size", tables.SIZES_TEXT, tables.sizes(results)]
    if picture:
        parts.append(f"![Time per particle-step and start-up over particles]({picture})")
    return "\n\n".join(parts) + "\n"


def write(path, text):
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text, encoding="utf-8")


def report(arguments):
    context, rows = read(arguments.inputs)
    results = Results(rows)
    write(arguments.data, json.dumps({"context": context, "benchmarks": rows}, indent=1) + "\n")
    picture = None
    if results.of("size"):
        from report_picture import draw_sizes  # only here: matplotlib takes a second to load
        arguments.picture.parent.mkdir(parents=True, exist_ok=True)
        draw_sizes(results).savefig(arguments.picture, dpi=120)
        picture = os.path.relpath(arguments.picture, arguments.page.parent)
    write(arguments.page, page(context, results, picture))


def main():
    arguments = parse_arguments()
    try:
        report(arguments)
    except (ReportError, OSError) as error:
        print(f"{PROGRAM}: error: {error}", file=sys.stderr)
        return 4
    return 0


if __name__ == "__main__":
    sys.exit(main())
