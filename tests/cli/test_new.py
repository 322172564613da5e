"""rgimp new: case files to start from, which are those of examples/."""

import os
import re
import tomllib
import unittest
from pathlib import Path

from command_test import CASE, FILE_TROUBLE, WRONG_REQUEST, CommandTest

EXAMPLES = Path(__file__).resolve().parents[2] / "examples"
TEMPLATES = {"single-flaw": "single_flaw", "double-flaw": "double_flaw",
             "brazilian-disk": "brazilian_disk", "uniaxial": "uniaxial",
             "penny-flaw": "block_penny_flaw", "brazilian-cylinder": "brazilian_cylinder"}
# Millions of particles as they stand; the checks of memory and values are the same.
COARSE = {"penny-flaw": ("--set", "grid.cell_size=3.125e-3", "--set", "flaw[0].width=9.375e-3"),
          "brazilian-cylinder": ("--set", "grid.cell_size=1.6e-3")}


class NewTest(CommandTest):
    def test_list_has_a_line_for_each_template(self):
        lines = self.rgimp("new", "--list").stdout.splitlines()
        self.assertEqual([line.split()[0] for line in lines], list(TEMPLATES))
        for line, example in zip(lines, TEMPLATES.values()):
            case = tomllib.loads((EXAMPLES / f"{example}.toml").read_text(encoding="utf-8"))
            self.assertEqual(line.split(maxsplit=1)[1], case["title"])

    def test_every_template_is_the_example_and_passes_the_check(self):
        for name, example in TEMPLATES.items():
            with self.subTest(name=name):
                file = name.replace("-", "_") + ".toml"
                self.assertIn(f"rgimp check {file}", self.rgimp("new", name).stdout)
                self.assertEqual((self.place / file).read_bytes(),
                                 (EXAMPLES / f"{example}.toml").read_bytes())
                result = self.rgimp("check", file, *COARSE.get(name, ()))
                self.assertEqual(result.stderr, "")

    def test_numbers_have_units_in_the_comments(self):
        for example in TEMPLATES.values():
            for line in (EXAMPLES / f"{example}.toml").read_text(encoding="utf-8").splitlines():
                if re.match(r"#?[a-z_]+ = [-0-9.\[]", line):
                    self.assertRegex(line, r".*  # ", f"{example}: {line}")

    def test_what_the_first_template_leaves_out_may_be_put_in(self):
        """Its lines "#key = value" are no mere text."""
        text = (EXAMPLES / "single_flaw.toml").read_text(encoding="utf-8")
        self.assertGreater(len(re.findall(r"(?m)^#(?=[a-z_\[])", text)), 15)
        self.case.write_text(re.sub(r"(?m)^#(?=[a-z_\[])", "", text), encoding="utf-8")
        self.rgimp("check", self.case)

    def test_nothing_is_overwritten_without_force(self):
        self.fail_with(WRONG_REQUEST, "new", "single-flaw", "-o", "block.toml",
                       says=["'block.toml' exists", "--force"])
        self.assertEqual(self.case.read_text(encoding="utf-8"), CASE)
        self.rgimp("new", "single-flaw", "-o", "block.toml", "--force")
        self.assertEqual(self.case.read_bytes(), (EXAMPLES / "single_flaw.toml").read_bytes())
        self.rgimp("new", "single-flaw", "-o", "other.toml", "--force")
        self.assertEqual(sorted(os.listdir(self.place)), ["block.toml", "other.toml"])

    def test_wrong_requests(self):
        self.fail_with(WRONG_REQUEST, "new", "triple-flaw", says=["triple-flaw", "double-flaw"])
        self.fail_with(WRONG_REQUEST, "new", says=["TEMPLATE", "--list"])
        self.fail_with(WRONG_REQUEST, "new", "uniaxial", "--list", says=["--list"])
        self.assertEqual(os.listdir(self.place), ["block.toml"])

    def test_where_nothing_can_be_written(self):
        for place in ("no/where.toml", "block.toml/below.toml", "x" * 300):
            for force in ((), ("--force",)):
                self.fail_with(FILE_TROUBLE, "new", "uniaxial", "-o", place, *force,
                               says=[f"'{place}"])
        (self.place / "directory").mkdir()
        self.fail_with(FILE_TROUBLE, "new", "uniaxial", "-o", "directory", "--force",
                       says=["directory"])
        self.assertEqual(sorted(os.listdir(self.place)), ["block.toml", "directory"])


if __name__ == "__main__":
    unittest.main()
