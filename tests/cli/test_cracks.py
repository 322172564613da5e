"""rgimp cracks: the cracks of an output directory, in a table and as JSON."""

import json
import unittest

from command_test import CASE, FILE_TROUBLE, WRONG_REQUEST, CommandTest

SLOT = """
[[flaw]]
shape = "slot"
center = [0.0, 0.0]
length = 2e-3
width = 1e-3
"""

IN_SPACE = CASE.replace("dimension = 2", "dimension = 3").replace(
    "center = [0.0, 0.0]", "center = [0.0, 0.0, 0.0]").replace(
    "size = [5e-3, 10e-3]", "size = [5e-3, 10e-3, 5e-3]") + """
[[flaw]]
shape = "penny"
center = [0.0, 0.0, 0.0]
length = 3e-3
width = 1e-3
normal = [0.0, 1.0, 0.0]
"""


class CracksTest(CommandTest):
    def setUp(self):
        super().setUp()
        self.case.write_text(CASE + SLOT, encoding="utf-8")
        self.rgimp("run", self.case, "--quiet")

    def test_table_and_json_agree_with_the_summary(self):
        text = self.rgimp("cracks", "block", "--json", "cracks.json").stdout
        cracks = json.loads((self.place / "cracks.json").read_text(encoding="utf-8"))
        failed = self.summary()["failed_tension"] + self.summary()["failed_shear"]
        self.assertIn(f"{failed} failed: ", text)
        self.assertEqual(cracks["failed"], failed)
        self.assertEqual(failed, cracks["outline"] + cracks["elsewhere"]
                         + sum(wing["failed"] for wing in cracks["wings"]))
        names = [wing["name"] for wing in cracks["wings"]]
        self.assertEqual([name for name in names if name in "AB"], ["A", "B"])
        for event in cracks["events"]:
            self.assertIn(event["event"], text)
        steps = [event["step"] for event in cracks["events"]]
        self.assertEqual(steps, sorted(steps))

    def test_state_at_a_step(self):
        first = self.summary()["first_failure"]["step"]
        text = self.rgimp("cracks", "block", "--step", first - 1).stdout
        self.assertIn("0 failed", text)
        self.assertIn("no crack", text)
        self.assertNotIn("0 failed", self.rgimp("cracks", "block", "--step", first).stdout)

    def test_three_dimensions(self):
        self.case.write_text(IN_SPACE, encoding="utf-8")
        self.rgimp("run", self.case, "-o", "space", "--quiet")
        text = self.rgimp("cracks", "space", "--json", "cracks.json").stdout
        cracks = json.loads((self.place / "cracks.json").read_text(encoding="utf-8"))
        failed = self.summary("space")["failed_tension"] + self.summary("space")["failed_shear"]
        self.assertEqual(cracks["failed"], failed)
        self.assertEqual(failed, cracks["outline"] + cracks["elsewhere"]
                         + sum(crack["failed"] for crack in cracks["cracks"]))
        first = self.summary("space")["first_failure"]
        self.assertEqual(cracks["first_failure"]["step"], first["step"])
        self.assertIn(f"First failure: step {first['step']} at ", text)
        self.assertIn("near no flaw", text)  # the first wave breaks the block at the platen
        self.assertEqual([crack["flaws"] for crack in cracks["cracks"]], [[]])
        for event in cracks["events"]:
            self.assertIn(event["event"], text)
        before = self.rgimp("cracks", "space", "--step", first["step"] - 1).stdout
        self.assertTrue(before.startswith("0 failed"))
        self.assertNotIn("First failure", before)

    def test_wrong_requests(self):
        self.fail_with(WRONG_REQUEST, "cracks", "nowhere", says=["nowhere", "rgimp run"])
        self.fail_with(WRONG_REQUEST, "cracks", "block", "--step", "251", says=["251", "250"])
        self.fail_with(WRONG_REQUEST, "cracks", "block", "--step", "-1", says=["--step"])
        self.fail_with(FILE_TROUBLE, "cracks", "block", "--json", "no/where.json",
                       says=["no/where.json"])
        (self.place / "block" / "snapshots" / "step_000000250.vtkhdf").write_bytes(b"damaged")
        self.fail_with(FILE_TROUBLE, "cracks", "block", says=["step_000000250.vtkhdf"])

    def test_help_shows_an_example(self):
        self.assertIn("rgimp cracks single_flaw", self.rgimp("cracks", "--help").stdout)


if __name__ == "__main__":
    unittest.main()
