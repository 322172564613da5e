"""What the benchmark programs measured, read from their JSON."""

import json
import math
from collections import namedtuple
from pathlib import Path

# What results must share to stand on one page.
IDENTITY = ("cpu", "memory", "isas", "compiler", "flags", "version", "commit")
PRIVATE = ("host_name", "executable")  # say where, not how fast

# One benchmark: its full name, what it measures, its settings, counters by name, the coefficient of
# variation of its time (None for one repetition) and what went wrong ("" for nothing).
Result = namedtuple("Result", "name kind settings counters spread error")


class ReportError(Exception):
    """The input cannot be reported."""


def read(paths):
    """The context that all files share, and their benchmarks."""
    context, rows = None, []
    for path in paths:
        try:
            document = json.loads(Path(path).read_text(encoding="utf-8"))
            one, more = document["context"], document["benchmarks"]
        except (OSError, ValueError, KeyError, TypeError) as error:
            raise ReportError(f"{path} holds no benchmark results: {error!r}") from error
        context = context or one
        for key in IDENTITY:
            if one.get(key) != context.get(key):
                raise ReportError(f"{path} differs from {paths[0]} in {key}: {one.get(key)}, not "
                                  f"{context.get(key)}")
        rows += more
    return {key: value for key, value in context.items() if key not in PRIVATE}, rows


def result_of(name, rows):
    """From a name like "step/cells:100/isa:avx2/threads:1/real_time" and its rows."""
    kind, *parts = name.split("/")
    settings = dict(part.split(":", 1) for part in parts if ":" in part)
    errors = [row["error_message"] for row in rows if row.get("error_occurred")]
    if errors:
        return Result(name, kind, settings, {}, None, errors[0])
    aggregates = {row["aggregate_name"]: row for row in rows if "aggregate_name" in row}
    spread = aggregates["cv"]["real_time"] if "cv" in aggregates else None
    return Result(name, kind, settings, aggregates.get("median", rows[0]), spread, "")


class Results:
    """The benchmarks of a run, found by what they measure."""

    def __init__(self, rows):
        by_name = {}
        for row in rows:
            by_name.setdefault(row["run_name"], []).append(row)
        self.all = [result_of(name, repetitions) for name, repetitions in by_name.items()]
        self.repetitions = max((row.get("repetitions", 1) for row in rows), default=0)

    def of(self, kind, **settings):
        return [result for result in self.all
                if result.kind == kind and settings.items() <= result.settings.items()]

    def values(self, key, *kinds):
        """Of a setting, ascending."""
        found = {result.settings[key] for kind in kinds for result in self.of(kind)
                 if key in result.settings}
        return sorted(found, key=lambda value: int(value) if value.isdigit() else value)

    def number(self, counter, kind, **settings):
        """A counter's median; None where it was not measured, NaN where the benchmark failed."""
        found = self.of(kind, **settings)
        if not found:
            return None
        return math.nan if found[0].error else found[0].counters.get(counter)

    def nanoseconds(self, kind, **settings):
        """Of a particle-step, by the clock on the wall."""
        speed = self.number("particle_steps_per_second", kind, **settings)
        return None if speed is None else 1e9 / speed

    def startup_per_million(self, kind, **settings):
        """Seconds from the case to the first step, per million particles."""
        seconds = self.number("startup_seconds", kind, **settings)
        return None if seconds is None else (
            1e6 * seconds / self.number("particles", kind, **settings))


def ratio(one, other):
    """None where `other` is missing or failed, else as `one` where that did."""
    if one is None or other is None or math.isnan(other):
        return None
    return one / other
