"""What a reader of the page must know before believing it."""

import math

NOTICEABLE = 0.01  # of the largest work; the examples stay below 0.001


def of(result, growth, cracks):
    return [line for line in (
        not_ended(result), energy(result.summary), *lost(result), sampled(growth), damped(result),
        f"Cracks were not measured: {cracks['trouble']}" if "trouble" in cracks else "") if line]


def not_ended(result):
    if result.summary:
        return ""
    return (f"The run has not ended: summary.json is missing. What is shown reaches to step "
            f"{result.steps()[-1]:,}, the last snapshot, and curves to step "
            f"{int(result.history['step'][-1]):,}.")


def energy(summary):
    error = summary.get("energy_error")
    if not isinstance(error, (int, float)) or not math.isfinite(error):
        return "The energy error is not a number: the physics stopped the run." if summary else ""
    if abs(error) > NOTICEABLE:
        return f"The energy error is {error:.2%} of the largest work."
    return ""


def lost(result):
    removed = result.summary.get("removed")
    count = removed.get("particles", 0) if isinstance(removed, dict) else 0
    if count:
        yield (f"{count:,} particles left the grid and were taken out: neither pictures nor "
               "crack growth show them.")
    left_out = result.snapshot(result.steps()[-1]).left_out
    if left_out:
        yield (f"{left_out:,} particles of the last snapshot are left out: their position or "
               "stress is not a finite number.")


def sampled(growth):
    if growth["drawn"] == growth["failed"]:
        return ""
    return (f"Crack growth draws {growth['drawn']:,} of {growth['failed']:,} failed particles; "
            "the counts beside it are of all.")


def damped(result):
    if result.local_damping() == 0:
        return ""
    return (f"Local damping β = {result.local_damping():g}: an addition of RGIMP, not part of the "
            "published method.")
