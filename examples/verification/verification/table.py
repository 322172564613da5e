"""A row of the table: what was found beside what was expected, and the verdict on it."""

import math
from dataclasses import dataclass

# kind -> how error and verdict come from result, reference and tolerance
RELATIVE = "relative"  # |result / reference - 1| <= tolerance
ABSOLUTE = "absolute"  # |result - reference| <= tolerance, in the row's unit
AT_MOST = "at most"    # result <= reference
AT_LEAST = "at least"  # result >= reference
INSIDE = "inside"      # reference = (low, high): low <= result <= high
EQUAL = "equal"        # result == reference, text or whole numbers
REPORT = "report"      # nothing to hold it against: shown only
KINDS = (RELATIVE, ABSOLUTE, AT_MOST, AT_LEAST, INSIDE, EQUAL, REPORT)


@dataclass(frozen=True)
class Row:
    """`result` and `reference` in `unit`; `source` says whose number the reference is. A result
    of None, what never happened, misses."""
    case: str
    quantity: str
    unit: str
    result: object
    reference: object = None
    source: str = ""
    tolerance: float = 0.0
    kind: str = REPORT
    note: str = ""

    def __post_init__(self):
        if self.kind not in KINDS:
            raise ValueError(f"{self.case}, {self.quantity}: no kind of row is {self.kind}")
        if self.kind != REPORT and (self.reference is None or not self.source):
            raise ValueError(f"{self.case}, {self.quantity}: a row that is judged needs a "
                             "reference and its source")
        if self.kind == RELATIVE and self.reference == 0:
            raise ValueError(f"{self.case}, {self.quantity}: no error is relative to 0")

    @property
    def error(self):
        """Relative for `relative` rows, else a difference in the row's unit; None without one."""
        if self.result is None:
            return None
        if self.kind == RELATIVE:
            return self.result / self.reference - 1.0
        if self.kind == ABSOLUTE:
            return self.result - self.reference
        return None

    @property
    def verdict(self):
        """"met", "missed", or "reported" where there is no target."""
        if self.kind == REPORT:
            return "reported"
        return "met" if self._holds() else "missed"

    def _holds(self):
        if self.kind == EQUAL:
            return self.result == self.reference
        if self.result is None or not math.isfinite(self.result):
            return False
        if self.kind == AT_MOST:
            return self.result <= self.reference
        if self.kind == AT_LEAST:
            return self.result >= self.reference
        if self.kind == INSIDE:
            return self.reference[0] <= self.result <= self.reference[1]
        return abs(self.error) <= self.tolerance
