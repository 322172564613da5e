"""Help, wrong command lines, wrong cases and places that cannot be written."""

import os
import unittest

from command_test import CASE, FILE_TROUBLE, WRONG_REQUEST, CommandTest

SLOT = """
[[flaw]]
shape = "slot"
center = [{x}, 0.0]
length = {length}
width = {width}
"""


class HelpTest(CommandTest):
    def test_help_names_the_subcommands_and_shows_examples(self):
        text = self.rgimp("--help").stdout
        for word in ("run", "check", "info", "Examples:", "Exit codes:"):
            self.assertIn(word, text)

    def test_help_of_run_shows_its_options(self):
        text = self.rgimp("run", "--help").stdout
        for option in ("--output", "--threads", "--steps", "--set", "--force", "--quiet",
                       "Examples:"):
            self.assertIn(option, text)

    def test_bare_command_prints_help_and_fails(self):
        self.assertIn("Usage: rgimp", self.rgimp(code=WRONG_REQUEST).stderr)

    def test_version_and_info_agree(self):
        version = self.rgimp("--version").stdout.split()[1]
        info = self.rgimp("info").stdout
        self.assertIn(version, info)
        self.assertIn("reference", info)


class WrongRequestTest(CommandTest):
    def test_wrong_command_lines(self):
        for arguments, says in (
                (("walk",), "walk"),
                (("run",), "CASE"),
                (("run", self.case, "--fast"), "--fast"),
                (("run", self.case, "--steps", "0"), "--steps"),
                (("run", self.case, "--steps", "1.5"), "--steps"),
                (("run", self.case, "--threads", "-1"), "--threads"),
                (("run", self.case, "other.toml"), "other.toml"),
                (("check", self.case, "--force"), "--force")):
            with self.subTest(arguments=arguments):
                self.fail_with(WRONG_REQUEST, *arguments, says=[says])
        self.assertEqual(os.listdir(self.place), ["block.toml"])

    def test_wrong_key_is_named_with_its_line(self):
        self.case.write_text(CASE.replace("cell_size", "cel_size"), encoding="utf-8")
        self.fail_with(WRONG_REQUEST, "run", self.case, "--quiet",
                       says=["block.toml:5", "cel_size", "cell_size"])
        self.fail_with(WRONG_REQUEST, "check", self.case, says=["cel_size"])
        self.assertEqual(os.listdir(self.place), ["block.toml"])

    def test_wrong_cases_are_refused_and_leave_nothing_behind(self):
        second_body = CASE[CASE.index("[[body]]"):CASE.index("[material.rock]")]
        for name, text, says in (
                ("wrong type", CASE.replace("0.5e-3", "true"), "grid.cell_size"),
                ("missing key", CASE.replace("density = 2600.0", ""), "density: missing"),
                ("unknown key", CASE.replace("ratio", "ration"), "poisson_ratio"),
                ("negative size", CASE.replace("5e-3, 10e-3", "-5e-3, 10e-3"), "body[0].size"),
                ("no such material", CASE.replace('"rock"', '"rook"'), '"rock"'),
                ("flaw outside", CASE + SLOT.format(x=0.1, length=3e-3, width=1e-3), "flaw[0]"),
                ("narrow slot", CASE + SLOT.format(x=0.0, length=3e-3, width=0.6e-3), "flaw[0]"),
                ("overlap", CASE + second_body, "body[1]"),
                ("empty", CASE + SLOT.format(x=0.0, length=1.0, width=1.0), "no particle"),
                ("no TOML", "title = ", "block.toml:1")):
            with self.subTest(name=name):
                self.case.write_text(text, encoding="utf-8")
                self.fail_with(WRONG_REQUEST, "run", self.case, says=["block.toml", says])
                self.assertEqual(os.listdir(self.place), ["block.toml"])

    def test_wrong_override(self):
        self.fail_with(WRONG_REQUEST, "run", self.case, "--set", "time.pace=3", says=["pace"])
        self.fail_with(WRONG_REQUEST, "run", self.case, "--set", "nonsense", says=["nonsense"])

    def test_unknown_instruction_set(self):
        for command in (("run", self.case), ("check", self.case), ("info",)):
            with self.subTest(command=command):
                self.fail_with(WRONG_REQUEST, *command, says=["RGIMP_ISA", "mmx"], RGIMP_ISA="mmx")
        self.assertEqual(os.listdir(self.place), ["block.toml"])

    def test_existing_output_needs_force(self):
        output = self.place / "block"
        output.mkdir()
        (output / "notes.txt").write_text("mine", encoding="utf-8")
        self.fail_with(WRONG_REQUEST, "run", self.case, says=["'block'", "--force"])
        self.assertEqual(os.listdir(output), ["notes.txt"])
        (output / "snapshots").mkdir()
        stale = output / "snapshots" / "step_000099999.vtkhdf"
        stale.write_bytes(b"old")
        self.rgimp("run", self.case, "--force", "--steps", 20)
        self.assertTrue((output / "notes.txt").exists())
        self.assertFalse(stale.exists())
        self.assertEqual(self.summary()["steps"], 20)

    def test_the_case_file_itself_is_never_overwritten(self):
        case = self.place / "case.toml"
        case.write_text(CASE, encoding="utf-8")
        self.fail_with(WRONG_REQUEST, "run", case, "-o", ".", "--force", says=["case.toml"])
        self.assertEqual(case.read_text(encoding="utf-8"), CASE)


class FileTroubleTest(CommandTest):
    def test_unreadable_case(self):
        self.fail_with(FILE_TROUBLE, "run", "missing.toml", says=["missing.toml"])
        self.fail_with(FILE_TROUBLE, "check", "missing.toml", says=["missing.toml"])

    def test_unwritable_output(self):
        for place in ("block.toml", "block.toml/below"):  # even root cannot write there
            with self.subTest(place=place):
                self.fail_with(FILE_TROUBLE, "run", self.case, "-o", place, says=[place])
        self.assertEqual(self.case.read_text(encoding="utf-8"), CASE)


if __name__ == "__main__":
    unittest.main()
