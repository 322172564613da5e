#!/usr/bin/python3
"""Holds the results of the program beside golden_hashes.toml, and the changelog beside both.

golden_hashes.py PROGRAM           fails where a hash differs, or the changelog does not name the table
golden_hashes.py PROGRAM --update  writes the hashes of this build into the table

PROGRAM is build/release/tests/golden_states. The table holds, for each case and class of
instruction sets, a hash of the particles and one of the last row of history.csv. A class is a set
of instruction sets with the same bits: AVX2 and AVX-512 are one, fma.
"""

import hashlib
import subprocess
import sys
import tomllib
from pathlib import Path

TABLE = Path(__file__).with_suffix(".toml")
CHANGELOG = TABLE.parents[2] / "CHANGELOG.md"
CLASSES = {"reference": "reference", "baseline": "baseline", "avx2": "fma", "avx512": "fma"}
HEAD = """\
# Hashes of results, which golden_hashes.py compares and writes; never edit them by hand.
# fma: AVX2 and AVX-512, which have the same bits.
"""
ADVICE = """\
Results are not those of tests/physics/golden_hashes.toml:
{}
Where that is no mistake, it is a change of results: run
  tests/physics/golden_hashes.py build/release/tests/golden_states --update
and declare it in CHANGELOG.md as that says. Compilers and C libraries other than Debian 12's may
differ too: see engine/docs/promises.md.
"""


def short_hash(text):
    return hashlib.sha256(text.encode()).hexdigest()[:16]


def present_results(program):
    """{(case, class): {"state": hash, "history": hash}}; fails where two of a class differ."""
    output = subprocess.run([program], check=True, capture_output=True, text=True).stdout
    results = {}
    for line in output.splitlines():
        case, isa, state, row = line.split(" ")
        hashes = {"state": state, "history": short_hash(row)}
        if results.setdefault((case, CLASSES[isa]), hashes) != hashes:
            sys.exit(f"{case}: {isa} gives other bits than the rest of its class, {CLASSES[isa]}")
    return results


def committed_results():
    table = tomllib.loads(TABLE.read_text(encoding="utf-8"))
    return {(case, kind): hashes for case, kinds in table.items() for kind, hashes in kinds.items()}


def write_table(results):
    if "fma" not in {kind for _, kind in results}:
        sys.exit("the table needs a machine with AVX2 and FMA")
    text = HEAD
    for case in dict.fromkeys(case for case, _ in results):
        text += f"\n[{case}]\n"
        for kind in dict.fromkeys(CLASSES.values()):
            hashes = results[case, kind]
            text += f'{kind} = {{state = "{hashes["state"]}", history = "{hashes["history"]}"}}\n'
    TABLE.write_text(text, encoding="utf-8")


def fingerprint(results):
    """Of the whole table: it changes with any hash."""
    return short_hash(repr(sorted((key, sorted(value.items())) for key, value in results.items())))[:8]


def complaint_about_results(present, committed):
    cases = {case for case, _ in present}
    lines = []
    for (case, kind), found in present.items():
        held = committed.get((case, kind), {})
        if differing := [what for what in found if found[what] != held.get(what)]:
            lines.append(f"  {case}, {kind}: {' and '.join(differing)}")
    lines += [f"  {case}, {kind}: not computed" for case, kind in committed if case not in cases]
    return ADVICE.format("\n".join(lines)) if lines else ""


def complaint_about_changelog(committed):
    mark = f"(results {fingerprint(committed)})"
    entries = CHANGELOG.read_text(encoding="utf-8").split("\n- ")
    if any("**Results change**" in entry and mark in " ".join(entry.split()) for entry in entries):
        return ""
    return (f"CHANGELOG.md has no entry for these results. Where results changed, add one:\n"
            f"  - **Results change** {mark}: what changed, why, and by how much.\n"
            f"Where a case was only added to the table, put {mark} in place of the last such mark.\n")


def main():
    program, *options = sys.argv[1:]
    if options == ["--update"]:
        present = present_results(program)
        write_table(present)
        complaint = complaint_about_changelog(present)
    else:
        committed = committed_results()
        complaint = (complaint_about_results(present_results(program), committed)
                     + complaint_about_changelog(committed))
    sys.exit(complaint or None)


if __name__ == "__main__":
    main()
