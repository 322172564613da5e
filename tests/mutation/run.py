#!/usr/bin/env python3
"""Do the tests notice errors? Builds every mutant of mutants/*.toml in a copy of the sources, runs
the tests on it, and writes outcomes.json and RESULTS.md. All of it takes some four hours on a
core."""

import argparse
import sys
import time
from pathlib import Path

import report
import scratch
import table


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("names", nargs="*", metavar="NAME",
                        help="mutants or files of the table, such as p2g/carry-not-cleared or p2g, in "
                             "the order to run them")
    parser.add_argument("--list", action="store_true", help="print the mutants and stop")
    parser.add_argument("--missing", action="store_true",
                        help="only those not killed when they last ran")
    parser.add_argument("--jobs", type=int, default=1, help="compilers at a time (default 1)")
    parser.add_argument("--folder", type=Path, default=table.ROOT / "build/mutation",
                        help="where the copy is built (default build/mutation)")
    return parser.parse_args()


def chosen(mutants, names):
    if not names:
        return mutants
    for name in names:
        if not any(name in (mutant.name, mutant.name.split("/")[0]) for mutant in mutants):
            sys.exit(f"error: no mutant {name}; --list prints them")
    return [mutant for name in names for mutant in mutants
            if name in (mutant.name, mutant.name.split("/")[0])]


def try_mutant(place, mutant):
    """Its state and what killed it."""
    later = [program for program in scratch.PROGRAMS if program not in mutant.tests]
    try:
        failure = place.first_failure(mutant.edits, [*mutant.tests, *later])
    except scratch.BrokenBuild as error:
        return "invalid", str(error)
    return ("killed", f"{failure[0]}: {failure[1]}") if failure else ("survived", "")


def run(mutants, place, kept):
    place.copy_sources()
    place.configure()
    for number, mutant in enumerate(mutants, 1):
        start = time.monotonic()
        state, by = try_mutant(place, mutant)
        seconds = time.monotonic() - start
        kept.add(mutant, state, by)
        print(f"[{number}/{len(mutants)}] {mutant.name}: {state} {by} ({seconds:.1f} s)",
              flush=True)
    place.patch(())


def main():
    arguments = parse_arguments()
    try:
        every = table.read()
    except table.TableError as error:
        sys.exit("error: the table does not fit the sources; where a line has changed, change the "
                 f"text in tests/mutation/mutants:\n{error}")
    mutants = chosen(every, arguments.names)
    kept = report.Outcomes()
    if arguments.missing:
        mutants = [m for m in mutants if (kept.of(m) or {}).get("state") != "killed"]
    if arguments.list:
        print("\n".join(f"{mutant.name}: {mutant.why}" for mutant in mutants))
        return 0
    run(mutants, scratch.Scratch(arguments.folder, arguments.jobs), kept)
    print(report.write(every, kept))
    survivors = [m for m in mutants if kept.of(m)["state"] != "killed"]
    return 1 if survivors else 0


if __name__ == "__main__":
    sys.exit(main())
