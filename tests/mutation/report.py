"""What became of the mutants: kept as JSON, written as Markdown. Both are kept with the sources, so
that a run of some mutants elsewhere does not forget the others."""

import hashlib
import json
from pathlib import Path

FOLDER = Path(__file__).resolve().parent
PAGE = FOLDER / "RESULTS.md"
HEAD = """# Mutants

A mutant is one deliberate error in the sources, of a kind that people make: a flipped sign, a node
off by one, a swapped component, a skipped treatment. The tests must fail for each: then it is
killed. `mutants/*.toml` holds them as text to replace, `run.py` patches a copy of the sources,
builds it and runs the test programs until one fails. The golden hashes are left out: any change
of a bit fails them, which says nothing of what is right. Each row is of the mutant's last run.

"""


def digest(mutant):
    return hashlib.sha256(repr(mutant.edits).encode()).hexdigest()[:16]


class Outcomes:
    """By mutant: `killed`, `survived` or `invalid` (it does not compile), and by what."""

    def __init__(self, path=FOLDER / "outcomes.json"):
        self.path = path
        self.by_name = json.loads(path.read_text()) if path.is_file() else {}

    def of(self, mutant):
        outcome = self.by_name.get(mutant.name)
        return outcome if outcome and outcome["digest"] == digest(mutant) else None

    def add(self, mutant, state, by):
        self.by_name[mutant.name] = {"digest": digest(mutant), "state": state, "by": by}
        self.path.write_text(json.dumps(self.by_name, indent=1, sort_keys=True) + "\n",
                             encoding="utf-8")


def counts(outcomes):
    """How many of each state, those never run left out."""
    states = [outcome["state"] for outcome in outcomes if outcome]
    return {state: states.count(state) for state in ("killed", "survived", "invalid")}


def summary(outcomes):
    number = counts(outcomes)
    valid = number["killed"] + number["survived"]
    share = f"{100.0 * number['killed'] / valid:.1f} %" if valid else "none"
    return (f"{len(outcomes)} mutants: {number['killed']} killed ({share} of those that compile), "
            f"{number['survived']} survived, {number['invalid']} invalid, "
            f"{outcomes.count(None)} not run")


def cell(text):
    return " ".join(text.replace("|", "\\|").split())


def row(mutant, outcome):
    if outcome is None:
        verdict = "not run"
    elif outcome["state"] == "killed":
        verdict = outcome["by"]
    else:
        verdict = f"**{outcome['state'].upper()}** {outcome['by']}"
    return f"| {mutant.name} | {cell(mutant.why)} | {cell(verdict)} |"


def write(mutants, kept, page=PAGE):
    outcomes = [kept.of(mutant) for mutant in mutants]
    rows = [row(mutant, outcome) for mutant, outcome in zip(mutants, outcomes)]
    page.write_text(HEAD + summary(outcomes) + ".\n\n| mutant | what is wrong | killed by |\n"
                    "|---|---|---|\n" + "\n".join(rows) + "\n", encoding="utf-8")
    return summary(outcomes)
