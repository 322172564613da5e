#!/usr/bin/python3
"""Runs checks of RGIMP against references and writes RESULTS.md."""

import argparse
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]


def parse_arguments(names):
    parser = argparse.ArgumentParser(
        prog="verify.py", description="Runs checks of RGIMP against references and writes "
        "RESULTS.md, with results/ and pictures/ beside it. Exit code 1 where a row misses.",
        epilog="Example: verify.py analytic finite_elements")
    parser.add_argument("check", nargs="*", choices=[*names, []], metavar="CHECK",
                        help="checks to run (default: all); --list names them")
    parser.add_argument("--list", action="store_true", help="list the checks and stop")
    parser.add_argument("--short", action="store_true",
                        help="only the parts that take seconds, as the tests do")
    parser.add_argument("--threads", type=int, default=0, metavar="N",
                        help="threads of a run (default: all)")
    parser.add_argument("--build", type=Path, default=ROOT / "build/release", metavar="DIR",
                        help="where rgimp was built (default: build/release)")
    parser.add_argument("--runs", type=Path, default=ROOT / "out/verification", metavar="DIR",
                        help="where runs go (default: out/verification)")
    parser.add_argument("--output", type=Path, metavar="DIR",
                        help="where RESULTS.md goes (default: beside this program; with --short "
                             "to the runs, as half a table must not replace the whole one)")
    arguments = parser.parse_args()
    arguments.output = arguments.output or (arguments.runs if arguments.short else HERE)
    return arguments


def main():
    try:
        from verification import registry, report, study
    except ImportError as error:
        print(f"verify.py: error: {error}; Debian's packages are python3-numpy, python3-h5py and "
              "python3-matplotlib", file=sys.stderr)
        return 2
    checks = registry.load()
    arguments = parse_arguments(checks)
    if arguments.list:
        print(registry.listing(checks))
        return 0
    chosen = [checks[name] for name in arguments.check or checks]
    if arguments.short:
        chosen = [check for check in chosen if check.short]
    missed, broken = 0, []
    for check in chosen:
        print(f"== {check.name}: {check.title}", flush=True)
        place = study.Study(check.name, arguments.build, arguments.runs, arguments.output,
                            arguments.threads)
        try:
            rows = check.run(place, arguments.short)
        except study.StudyError as error:
            print(f"verify.py: error: {check.name}: {error}", file=sys.stderr)
            broken.append(check.name)
            continue
        report.save(arguments.output, check, rows, place)
        missed += sum(row.verdict == "missed" for row in rows)
        print(report.text_table(rows), flush=True)
    report.write_page(arguments.output, checks)
    print(f"{arguments.output / 'RESULTS.md'}: {missed} rows of these checks missed")
    if broken:
        print(f"verify.py: error: not finished: {', '.join(broken)}", file=sys.stderr)
    return 1 if missed or broken else 0


if __name__ == "__main__":
    sys.exit(main())
