"""rgimp cracks on output directories that somebody else prepared."""

import os
import shutil
import unittest

from command_test import CASE, FILE_TROUBLE, WRONG_REQUEST, CommandTest
from hostile_snapshots import POINTS, HostileSnapshots, h5py

FLIPS = 100


class HostileSnapshotsTest(HostileSnapshots, CommandTest):
    def setUp(self):
        super().setUp()
        self.rgimp("run", self.case, "--quiet", "--steps", 60)
        self.snapshot = self.place / "block" / "snapshots" / "step_000000060.vtkhdf"

    def test_what_cannot_be_a_snapshot_is_refused(self):
        self.rgimp("cracks", "block")

        def check():
            result = self.fail_with(FILE_TROUBLE, "cracks", "block", says=[self.snapshot.name])
            self.assertNotIn("nobody may read", result.stdout + result.stderr)

        self.for_each_hostile(check)

    def test_numbers_that_no_run_writes_are_refused(self):
        whole = self.snapshot.read_bytes()
        for name, row, number in (("id", 0, 1), ("id", 0, 4294967295), ("failed", 0, 7),
                                  ("failed", 0, 1), ("failure_step", 0, 2147483647)):
            with self.subTest(name=name, number=number):
                self.snapshot.write_bytes(whole)
                with h5py.File(self.snapshot, "r+") as file:
                    file["VTKHDF/PointData"][name][row] = number
                self.fail_with(FILE_TROUBLE, "cracks", "block", says=[self.snapshot.name])

    def test_a_turned_bit_never_crashes(self):
        def check():
            result = self.attempt("cracks", "block")
            self.assertIn(result.returncode, (0, FILE_TROUBLE), result.stderr)

        self.for_each_turned_bit(FLIPS, check)

    def test_files_that_are_none_are_not_waited_for(self):
        self.snapshot.unlink()
        os.mkfifo(self.snapshot)
        self.fail_with(FILE_TROUBLE, "cracks", "block", says=["not a regular file"])
        self.snapshot.unlink()
        self.snapshot.mkdir()
        self.fail_with(FILE_TROUBLE, "cracks", "block", says=["not a regular file"])
        self.snapshot.rmdir()
        self.snapshot.symlink_to("nothing")
        self.fail_with(FILE_TROUBLE, "cracks", "block", says=["No such file"])

    def test_the_case_of_the_directory_is_read_with_the_same_care(self):
        case = self.place / "block" / "case.toml"
        deep = "a." * 1000000 + "a = 1\n"
        for name, text, code in (
                ("empty", "", WRONG_REQUEST), ("noise", "\x01\x02", WRONG_REQUEST),
                ("escape", '"\\u001b]0;x\\u0007" = 1\n', WRONG_REQUEST),
                ("deep keys", deep, WRONG_REQUEST), ("deep values", "a = " + "[" * 1000000,
                                                     WRONG_REQUEST),
                ("too large", CASE.replace("0.5e-3", "1e-30"), WRONG_REQUEST),
                ("another case", CASE.replace("5e-3, 10e-3", "6e-3, 10e-3"), FILE_TROUBLE)):
            with self.subTest(name=name):
                case.write_text(text, encoding="utf-8")
                result = self.fail_with(code, "cracks", "block")
                self.assertNotIn("\x1b", result.stderr)
        case.unlink()
        os.mkfifo(case)
        self.fail_with(FILE_TROUBLE, "cracks", "block", says=["not a regular file"])
        case.unlink()
        case.symlink_to("case.toml")
        self.fail_with(FILE_TROUBLE, "cracks", "block", says=["case.toml"])

    def test_a_good_snapshot_of_another_program_is_taken(self):
        with h5py.File(self.snapshot) as file:
            points = file[POINTS][()]
        shutil.copy(self.snapshot, self.place / "copy.h5")
        with h5py.File(self.snapshot, "r+") as file:
            del file[POINTS]
            file[POINTS] = points.astype("f4")
        self.rgimp("cracks", "block")


if __name__ == "__main__":
    unittest.main()
