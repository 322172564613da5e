"""Unusual files and directories: what is written where, and what is refused."""

import os
import unittest

from command_test import CASE, FILE_TROUBLE, WRONG_REQUEST, CommandTest

SHORT = ("--quiet", "--steps", 3)


class CasePlacesTest(CommandTest):
    def test_any_name_will_do(self):
        for name in ("with blanks .toml", "größe ☃ 岩.toml", "-dash.toml", "a'b\"c$d.toml", ".toml"):
            with self.subTest(name=name):
                case = self.place / name
                case.write_text(CASE, encoding="utf-8")
                self.rgimp("run", f"./{name}", *SHORT, "-o", f"out of {name}")
                self.assertTrue((self.place / f"out of {name}" / "summary.json").exists())

    def test_a_pipe_and_a_link_are_read(self):
        link = self.place / "link.toml"
        link.symlink_to(self.case)
        self.rgimp("run", link, *SHORT)
        self.assertTrue((self.place / "link" / "summary.json").exists())
        ends = os.pipe()
        os.write(ends[1], CASE.encode())
        os.close(ends[1])
        result = self.attempt("run", f"/dev/fd/{ends[0]}", *SHORT, "-o", "piped",
                              pass_fds=[ends[0]])
        os.close(ends[0])
        self.assertEqual(result.returncode, 0, result.stderr)

    def test_what_is_no_case_file_is_refused(self):
        broken, loop = self.place / "broken.toml", self.place / "loop.toml"
        broken.symlink_to("nothing")
        loop.symlink_to("loop.toml")
        for place, code, says in (
                (self.place, FILE_TROUBLE, "Is a directory"),
                (broken, FILE_TROUBLE, "No such file"),
                (loop, FILE_TROUBLE, "Too many levels of symbolic links"),
                (self.case / "below", FILE_TROUBLE, "Not a directory"),
                ("x" * 5000, FILE_TROUBLE, "File name too long"),
                ("", FILE_TROUBLE, "No such file"),
                ("/dev/null", WRONG_REQUEST, "grid: missing"),
                ("/dev/zero", FILE_TROUBLE, "longer than 64 MiB")):
            with self.subTest(place=str(place)[:80]):
                self.fail_with(code, "run", place, *SHORT, "-o", "out", says=[says])
                self.fail_with(code, "check", place, says=[says])
        self.assertFalse((self.place / "out").exists())


class OutputPlacesTest(CommandTest):
    def test_missing_directories_are_made(self):
        self.rgimp("run", self.case, *SHORT, "-o", "deep/er and/ö")
        self.assertTrue((self.place / "deep" / "er and" / "ö" / "summary.json").exists())

    def test_where_nothing_can_be_written(self):
        (self.place / "loop").symlink_to("loop")
        (self.place / "broken").symlink_to("no/where")
        for place in ("block.toml", "block.toml/below", "loop", "broken", "x" * 300, "y/" * 2500,
                      "/dev/null", "/proc/nowhere"):  # none of them even for root
            with self.subTest(place=place[:80]):
                self.fail_with(FILE_TROUBLE, "run", self.case, *SHORT, "-o", place)
                self.fail_with(FILE_TROUBLE, "run", self.case, *SHORT, "--force", "-o", place)
        self.assertEqual(self.case.read_text(encoding="utf-8"), CASE)
        self.assertEqual(sorted(os.listdir(self.place)), ["block.toml", "broken", "loop"])

    @unittest.skipIf(os.geteuid() == 0, "root may write to a directory that is read-only")
    def test_read_only_directory(self):
        place = self.place / "locked"
        place.mkdir(mode=0o555)
        self.fail_with(FILE_TROUBLE, "run", self.case, *SHORT, "-o", place, says=["Permission"])

    def test_a_link_to_a_directory_is_that_directory(self):
        (self.place / "real").mkdir()
        (self.place / "link").symlink_to("real")
        self.rgimp("run", self.case, *SHORT, "-o", "link")
        self.assertTrue((self.place / "real" / "summary.json").exists())


class OutputStaysInsideTest(CommandTest):
    """Nothing outside the output directory is written or removed, whatever lies in it."""

    def setUp(self):
        super().setUp()
        self.outside = self.place / "outside"
        self.outside.mkdir()
        self.treasure = self.outside / "step_000000000.vtkhdf"
        self.treasure.write_bytes(b"treasure")
        (self.outside / "crack.png").write_bytes(b"treasure")
        self.output = self.place / "block"

    def tearDown(self):
        self.assertEqual(sorted(os.listdir(self.outside)), ["crack.png", self.treasure.name])
        self.assertEqual({file.read_bytes() for file in self.outside.iterdir()}, {b"treasure"})

    def test_directories_that_are_links_are_refused(self):
        for name in ("snapshots", "pictures"):
            for option in ("--force", "--resume"):
                with self.subTest(name=name, option=option):
                    self.output.mkdir(exist_ok=True)
                    (self.output / name).symlink_to(self.outside)
                    self.fail_with(FILE_TROUBLE, "run", self.case, *SHORT, option,
                                   says=[f"'{name}' in it is a symbolic link"])
                    (self.output / name).unlink()

    def test_files_that_are_links_are_replaced(self):
        (self.output / "snapshots").mkdir(parents=True)
        for name in ("case.toml", "case.toml.tmp", "history.csv", "summary.json",
                     "checkpoint_a.rgimp", "snapshots/step_000000003.vtkhdf",
                     "snapshots/step_000000003.vtkhdf.tmp", "snapshots/snapshots.hdf.series"):
            (self.output / name).symlink_to(self.treasure)
        self.rgimp("run", self.case, *SHORT, "--force")
        self.assertEqual([path for path in self.output.rglob("*") if path.is_symlink()], [])

    def test_a_run_that_goes_on_follows_no_links(self):
        self.rgimp("run", self.case, *SHORT, "--set", "output.checkpoint_every=1")
        for name in ("history.csv", "case.toml", "checkpoint_b.rgimp"):
            with self.subTest(name=name):
                kept = self.output / f"{name}.kept"
                (self.output / name).rename(kept)
                (self.output / name).symlink_to(self.treasure)
                self.fail_with(FILE_TROUBLE, "run", self.case, "--resume", "--steps", 9,
                               "--set", "output.checkpoint_every=1", says=[f"'{name}' in it"])
                kept.replace(self.output / name)

    def test_no_text_of_a_case_is_a_path(self):
        text = CASE.replace('"pulled block"', '"../outside/x"').replace(
            '"rock"', '"../../outside"').replace("material.rock", 'material."../../outside"')
        self.case.write_text(text, encoding="utf-8")
        self.rgimp("run", self.case, *SHORT)
        self.assertEqual(sorted(os.listdir(self.place)), ["block", "block.toml", "outside"])


class TerminalTest(CommandTest):
    """No byte of a case or file name that a terminal would obey reaches it."""

    HOSTILE = "\\u001b[31m\\u0007\\u009b2J\\r\\nrgimp: error: forged"

    def assert_harmless(self, result):
        for text in (result.stdout, result.stderr):
            self.assertRegex(text, r"\A[\n -~\u00a0-\U0010ffff]*\Z")
            self.assertNotRegex(text, r"(?m)^rgimp: error: forged")

    def test_title(self):
        self.case.write_text(CASE.replace("pulled block", self.HOSTILE), encoding="utf-8")
        result = self.rgimp("check", self.case)
        self.assertIn(r"\x1b[31m\x07\xc2\x9b2J\x0d\x0argimp: error: forged", result.stdout)
        self.assert_harmless(result)
        self.assert_harmless(self.rgimp("run", self.case, "--steps", 3))
        self.assert_harmless(self.rgimp("cracks", "block"))

    def test_errors_and_warnings(self):
        name = f'"{self.HOSTILE}"'
        for text, code in (
                (CASE.replace("cell_size", name), WRONG_REQUEST),
                (CASE.replace('"box"', name), WRONG_REQUEST),
                (CASE.replace('material = "rock"', f"material = {name}"), WRONG_REQUEST),
                (CASE.replace("2600.0", "-1").replace('"rock"', name).replace(
                    "material.rock", f"material.{name}"), WRONG_REQUEST),
                (CASE.replace("0.5e-3", "\x1b[31m"), WRONG_REQUEST)):
            with self.subTest(text=text[:60]):
                self.case.write_text(text, encoding="utf-8")
                self.assert_harmless(self.fail_with(code, "check", self.case))

    def test_names_of_files_and_overrides(self):
        self.assert_harmless(self.fail_with(FILE_TROUBLE, "check", "\x1b[31mred"))
        self.assert_harmless(self.fail_with(
            WRONG_REQUEST, "check", self.case, "--set", "title=\x1b[31m\nrgimp: error: forged"))
        self.assert_harmless(self.fail_with(WRONG_REQUEST, "check", self.case, "--\x1b[31m"))
        self.assert_harmless(self.rgimp("run", self.case, "--steps", 3, "-o", "\x1b[31mred"))


class OverridesTest(CommandTest):
    def test_odd_values(self):
        for override, says in (
                ("", "expected KEY=VALUE"), ("=", "dotted key"), ("=1", "dotted key"),
                ("time.steps=", "not a TOML value"),
                ("time.steps=9223372036854775807", "at most 2147483647"),
                ("time.steps=9223372036854775808", "not a TOML value"),
                ("time.steps=-9223372036854775808", "expected 1 or more"),
                ("grid.cell_size=nan", "expected a finite number"),
                ("grid.cell_size=1e300", "makes steps of"),
                ("grid.cell_size=1e-320", "makes steps of"),
                ("body[99999999999999999999].size=1", "does not exist"),
                ("body[-1].size=1", "body[-1]"), ("größe=1", "dotted key"),
                ("a." * 200 + "a=1", "unknown key"), ("title=" + "[" * 100000, "not a TOML value")):
            with self.subTest(override=override[:40]):
                self.fail_with(WRONG_REQUEST, "check", self.case, "--set", override, says=[says])


if __name__ == "__main__":
    unittest.main()
