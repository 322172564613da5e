"""The table of mutants: mutants/*.toml, checked as it is read.

A file names the tests to try first (`tests`), the source it mutates (`file`), and its mutants. A
mutant has a name, why it matters, and either one edit (`from`, `to`, perhaps a `file` of its own) or
several (`edits`).
"""

import tomllib
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
FOLDER = Path(__file__).resolve().parent / "mutants"


class TableError(Exception):
    """The table does not fit the sources."""


@dataclass(frozen=True)
class Edit:
    file: str  # from the repository's root
    old: str
    new: str


@dataclass(frozen=True)
class Mutant:
    name: str  # FILE/NAME
    why: str
    edits: tuple[Edit, ...]
    tests: tuple[str, ...]  # tried first


def mutant_of(stem, table, entry):
    edits = tuple(Edit(edit.get("file", table.get("file")), edit["from"], edit["to"])
                  for edit in entry.get("edits", [entry]))
    return Mutant(f"{stem}/{entry['name']}", entry["why"], edits, tuple(table["tests"]))


def check(mutants):
    """Every text must be there exactly once, so that the table cannot go stale in silence."""
    problems = []
    names = set()
    for mutant in mutants:
        if mutant.name in names:
            problems.append(f"{mutant.name}: there are two of this name")
        names.add(mutant.name)
        for edit in mutant.edits:
            count = (ROOT / edit.file).read_text(encoding="utf-8").count(edit.old)
            if count != 1:
                problems.append(f"{mutant.name}: found {count} times in {edit.file}: {edit.old!r}")
            if edit.old == edit.new:
                problems.append(f"{mutant.name}: changes nothing in {edit.file}")
    if problems:
        raise TableError("\n".join(problems))


def read():
    """All mutants, in the order of the files."""
    mutants = []
    for path in sorted(FOLDER.glob("*.toml")):
        table = tomllib.loads(path.read_text(encoding="utf-8"))
        mutants += [mutant_of(path.stem, table, entry) for entry in table["mutant"]]
    check(mutants)
    return mutants
