"""Verdicts follow from the numbers of a row, and the page shows them."""

import json
import sys
import tempfile
import unittest
from pathlib import Path
from types import SimpleNamespace

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "examples/verification"))

from verification import registry, report, table  # noqa: E402
from verification.table import Row  # noqa: E402


def row(result, reference, kind, tolerance=0.0):
    return Row("case", "quantity", "Pa", result, reference, "source", tolerance, kind)


class VerdictTest(unittest.TestCase):
    def test_each_kind_at_both_sides_of_its_limit(self):
        for kind, reference, tolerance, inside, outside in (
                (table.RELATIVE, 200.0, 0.25, (150.0, 250.0), (149.9, 250.1)),
                (table.ABSOLUTE, 0.0, 0.5, (-0.5, 0.5), (-0.51, 0.51)),
                (table.AT_MOST, 3.0, 0.0, (3.0, -9.0), (3.01,)),
                (table.AT_LEAST, 3.0, 0.0, (3.0, 9.0), (2.99,)),
                (table.INSIDE, (1.0, 2.0), 0.0, (1.0, 2.0), (0.99, 2.01)),
                (table.EQUAL, "tension", 0.0, ("tension",), ("shear",))):
            for result in inside:
                self.assertEqual(row(result, reference, kind, tolerance).verdict, "met",
                                 f"{kind}: {result}")
            for result in outside:
                self.assertEqual(row(result, reference, kind, tolerance).verdict, "missed",
                                 f"{kind}: {result}")

    def test_what_is_not_a_number_misses(self):
        for kind in (table.RELATIVE, table.ABSOLUTE, table.AT_MOST, table.AT_LEAST):
            for result in (float("nan"), float("inf"), float("-inf")):
                self.assertEqual(row(result, 1.0, kind, 0.1).verdict, "missed", f"{kind}: {result}")

    def test_what_never_happened_misses_and_nothing_is_relative_to_zero(self):
        for kind in (table.RELATIVE, table.ABSOLUTE, table.AT_MOST, table.INSIDE, table.EQUAL):
            reference = (1.0, 2.0) if kind == table.INSIDE else 1.0
            never = row(None, reference, kind, 0.1)
            self.assertEqual((never.verdict, never.error), ("missed", None))
        with self.assertRaises(ValueError):
            row(1.0, 0.0, table.RELATIVE, 0.1)

    def test_a_row_without_a_reference_is_reported_and_one_that_is_judged_needs_its_source(self):
        self.assertEqual(Row("case", "quantity", "1", 3.0).verdict, "reported")
        with self.assertRaises(ValueError):
            Row("case", "quantity", "1", 3.0, 3.0, "", 0.1, table.RELATIVE)
        with self.assertRaises(ValueError):
            Row("case", "quantity", "1", 3.0, None, "theory", 0.1, table.RELATIVE)
        with self.assertRaises(ValueError):
            row(1.0, 1.0, "roughly")


class PageTest(unittest.TestCase):
    def test_rows_that_were_kept_come_back_with_their_verdicts(self):
        check = registry.Check("one", "First check", 1.0, True, None, "What it does.")
        rows = [row(1.0, 1.001, table.RELATIVE, 0.01), row(9.0, 3.0, table.AT_MOST),
                Row("other", "shown", "1", 4.0)]
        place = SimpleNamespace(used=[{"version": "0.1.0", "isa": "avx2"}])
        with tempfile.TemporaryDirectory() as folder:
            report.save(Path(folder), check, rows, place)
            report.write_page(Path(folder), {"one": check})
            page = (Path(folder) / "RESULTS.md").read_text(encoding="utf-8")
            kept = json.loads((Path(folder) / "results/one.json").read_text(encoding="utf-8"))
        self.assertIn("| [First check](#one) | 1 | 1 | 1 |", page)
        self.assertIn("| **all** | 1 | 1 | 1 |", page)
        self.assertIn("| case | quantity, Pa | ≤ 3 | source | 9 |  |  | **missed** |", page)
        self.assertNotIn("verdict", kept["rows"][0])  # never typed, never kept


if __name__ == "__main__":
    unittest.main()
