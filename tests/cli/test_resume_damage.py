"""--resume where files of the run are damaged or the disk is full."""

import os
import random
import resource
import shutil
import unittest

from command_test import FILE_TROUBLE
from resume_test import CHECKPOINTS, ResumeTest


class DamageTest(ResumeTest):
    def setUp(self):
        super().setUp()
        self.run_whole()
        self.interrupt_at(1000)
        os.rename(self.place / "cut", self.place / "killed")

    def newest(self, directory):
        return max((self.place / directory / name for name in CHECKPOINTS),
                   key=lambda path: int.from_bytes(path.read_bytes()[24:32], "little"))

    def fresh_copy(self):
        shutil.rmtree(self.place / "cut", ignore_errors=True)
        shutil.copytree(self.place / "killed", self.place / "cut")

    def test_a_cut_or_changed_checkpoint_is_named_and_the_older_one_used(self):
        random.seed(7)
        whole = self.newest("killed").read_bytes()
        damages = [whole[:size] for size in (0, 1, 15, 40, len(whole) // 2, len(whole) - 1)]
        for _ in range(14):
            place, bit = random.randrange(len(whole)), 1 << random.randrange(8)
            damages.append(whole[:place] + bytes([whole[place] ^ bit]) + whole[place + 1:])
        for damage in damages:
            self.fresh_copy()
            newest = self.newest("cut")
            newest.write_bytes(damage)
            messages = self.resume().stderr
            self.assertIn(f"checkpoint 'cut/{newest.name}': ", messages)
            other = next(name for name in CHECKPOINTS if name != newest.name)
            self.assertRegex(messages, rf"going on from step \d+ of 'cut/{other}'")
            self.check_same_results("cut")

    def test_without_a_whole_checkpoint_nothing_is_touched(self):
        self.fresh_copy()
        for name in CHECKPOINTS:
            (self.place / "cut" / name).write_bytes(b"RGIMPcheckpoint\nand no more")
        before = sorted(path.name for path in (self.place / "cut").rglob("*"))
        self.fail_with(FILE_TROUBLE, "run", self.case, "-o", "cut", "--resume",
                       says=[*CHECKPOINTS, "--force"])
        self.assertEqual(sorted(path.name for path in (self.place / "cut").rglob("*")), before)

    def test_a_history_that_was_changed_is_not_gone_on_with(self):
        self.fresh_copy()
        history = self.place / "cut" / "history.csv"
        history.write_bytes(history.read_bytes().replace(b"\n10,", b"\n11,", 1))
        changed = history.read_bytes()
        self.fail_with(FILE_TROUBLE, "run", self.case, "-o", "cut", "--resume",
                       says=["history.csv", "no longer what it was"])
        self.assertEqual(history.read_bytes(), changed)

    def test_what_cannot_be_read_is_not_called_damaged(self):
        self.fresh_copy()
        os.remove(self.place / "cut" / "history.csv")
        result = self.fail_with(FILE_TROUBLE, "run", self.case, "-o", "cut", "--resume",
                                says=["history.csv"])
        self.assertNotIn("--force", result.stderr)
        self.assertNotIn("checkpoint_", result.stderr)

    def test_the_checkpoint_gone_on_from_is_kept_while_the_next_is_written(self):
        self.fresh_copy()
        newest = self.newest("cut")
        before = newest.read_bytes()
        step = int.from_bytes(before[24:32], "little")
        self.resume("--steps", step + 26)  # one more checkpoint, after 25 steps
        self.assertEqual(newest.read_bytes(), before)
        self.assertEqual(int.from_bytes(self.newest("cut").read_bytes()[24:32], "little"), step + 25)

    def test_pipes_and_giants_are_damaged_checkpoints(self):
        for name in ("pipe", "giant"):
            self.fresh_copy()
            newest = self.newest("cut")
            if name == "pipe":
                newest.unlink()
                os.mkfifo(newest)
            else:
                os.truncate(newest, 2 ** 42)
            messages = self.resume().stderr
            self.assertIn(newest.name, messages)
            self.assertIn("going on from step", messages)
            self.check_same_results("cut")

    def test_a_pipe_for_another_file_of_the_run_is_not_waited_for(self):
        for name in ("case.toml", "history.csv", "summary.json"):
            with self.subTest(name=name):
                self.fresh_copy()
                file = self.place / "cut" / name
                file.unlink(missing_ok=True)
                os.mkfifo(file)
                self.fail_with(FILE_TROUBLE, "run", self.case, "-o", "cut", "--resume",
                               says=[name, "not a regular file"])

    def test_rows_and_snapshots_after_the_checkpoint_go(self):
        self.fresh_copy()
        with open(self.place / "cut" / "history.csv", "a", encoding="utf-8") as history:
            history.write("2990,half a ro")
        (self.place / "cut" / "snapshots" / "step_000002999.vtkhdf").write_bytes(b"later")
        (self.place / "cut" / "summary.json.tmp").write_bytes(b"half")
        self.resume()
        self.check_same_results("cut")


class FullDiskTest(ResumeTest):
    def test_a_full_disk_ends_the_run_and_leaves_the_last_checkpoint(self):
        self.case.write_text(self.case.read_text().replace("history_every = 10", "history_every = 1"))
        self.run_whole()
        # The history outgrows it, and nothing before.
        limit = (self.place / "whole" / "history.csv").stat().st_size * 2 // 3
        self.assertLess((self.place / "whole" / CHECKPOINTS[0]).stat().st_size, limit)
        process = self.start("--quiet", preexec_fn=lambda: resource.setrlimit(
            resource.RLIMIT_FSIZE, (limit, resource.RLIM_INFINITY)))
        _, messages = process.communicate()
        self.assertEqual(process.returncode, FILE_TROUBLE, messages)
        self.assertIn("history.csv", messages)
        self.resume()
        self.check_same_results("cut")

    def test_a_checkpoint_that_does_not_fit_leaves_those_before(self):
        self.run_whole()
        self.interrupt_at(500)
        limit = (self.place / "cut" / CHECKPOINTS[0]).stat().st_size // 2
        before = {name: (self.place / "cut" / name).read_bytes() for name in CHECKPOINTS}
        process = self.start("--quiet", "--resume", preexec_fn=lambda: resource.setrlimit(
            resource.RLIMIT_FSIZE, (limit, resource.RLIM_INFINITY)))
        _, messages = process.communicate()
        self.assertEqual(process.returncode, FILE_TROUBLE, messages)
        for name in CHECKPOINTS:
            self.assertEqual((self.place / "cut" / name).read_bytes(), before[name])
            self.assertFalse((self.place / "cut" / f"{name}.tmp").exists())
        self.resume()
        self.check_same_results("cut")


if __name__ == "__main__":
    unittest.main()
