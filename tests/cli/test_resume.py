"""Checkpoints, --resume and signals: a run that is interrupted loses nothing."""

import json
import os
import random
import re
import resource
import shutil
import signal
import subprocess
import time
import unittest

from command_test import CASE, COMMAND, DONE, FILE_TROUBLE, WRONG_REQUEST, CommandTest

STEPS = 3000
CHECKPOINTS = ("checkpoint_a.rgimp", "checkpoint_b.rgimp")
# What may differ between a run and one that was interrupted: what tells of the process.
OF_THE_PROCESS = ("wall_s", "particle_steps_per_second", "threads")


def hear_signals():
    """In the child: a test that runs in the background or under nohup hands down ignored signals,
    which a run would go on to ignore."""
    for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
        signal.signal(number, signal.SIG_DFL)


class ResumeTest(CommandTest):
    def setUp(self):
        super().setUp()
        self.case.write_text(
            CASE.replace("steps = 250", f"steps = {STEPS}")
            .replace("history_every = 100", "history_every = 10\ncheckpoint_every = 25")
            .replace("snapshot_every = 200", "snapshot_every = 300"), encoding="utf-8")

    def results(self, directory):
        """Name and bytes of all that a run leaves, without what tells of the process."""
        directory = self.place / directory
        files = {str(path.relative_to(directory)): path.read_bytes()
                 for path in directory.rglob("*") if path.is_file()}
        summary = json.loads(files.pop("summary.json"))
        files["summary.json"] = {key: value for key, value in summary.items()
                                 if key not in OF_THE_PROCESS}
        files["case.toml"] = re.sub(rb"(?m)^threads = .*$", b"", files["case.toml"])
        for name in CHECKPOINTS:
            files.pop(name, None)
        return files

    def check_same_results(self, directory, reference="whole"):
        ours, theirs = self.results(directory), self.results(reference)
        self.assertEqual(sorted(ours), sorted(theirs))
        for name, content in theirs.items():
            self.assertTrue(ours[name] == content, f"{directory}/{name} differs")

    def start(self, *arguments, **options):
        return subprocess.Popen(
            [COMMAND, "run", str(self.case), "-o", "cut", *map(str, arguments)], cwd=self.place,
            stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, **options)

    def resume(self, *arguments, directory="cut", code=DONE):
        return self.rgimp("run", self.case, "-o", directory, "--quiet", "--resume", *arguments,
                          code=code)

    def run_whole(self, *arguments):
        start = time.monotonic()
        self.rgimp("run", self.case, "-o", "whole", "--quiet", *arguments)
        return time.monotonic() - start

    def interrupt_at(self, step, directory="cut"):
        """Leaves a run that has come to `step` or further and was killed."""
        process = self.start("--quiet") if directory == "cut" else None
        history = self.place / directory / "history.csv"
        while process.poll() is None:
            if history.exists() and history.read_bytes().count(b"\n") > step // 10 + 1:
                process.kill()
                process.wait()
                break
        process.stderr.close()
        self.assertEqual(process.returncode, -signal.SIGKILL)


class KillTest(ResumeTest):
    def test_fifty_kills_at_random_moments_change_no_bit(self):
        seconds = self.run_whole()
        random.seed(20261124)
        kills, runs, least = 0, 0, 50
        while kills < least:  # several runs may come to their end before
            shutil.rmtree(self.place / "cut", ignore_errors=True)
            runs += 1
            while True:
                process = self.start("--resume", "--quiet", "--threads", random.choice((1, 2)))
                try:
                    process.wait(random.uniform(0.0, 0.4 * seconds))
                except subprocess.TimeoutExpired:
                    process.kill()
                    kills += 1
                _, messages = process.communicate()
                if process.returncode != -signal.SIGKILL:
                    break
            self.assertEqual(process.returncode, DONE, messages)
            self.check_same_results("cut")
        print(f"{kills} kills in {runs} runs of {seconds:.2f} s ...", end=" ")

    def test_kills_while_a_checkpoint_is_written(self):
        self.run_whole("--set", "output.checkpoint_every=1", "--steps", 400)
        kills = 0
        while True:
            process = self.start("--resume", "--quiet", "--set", "output.checkpoint_every=1",
                                 "--steps", 400)
            seen = kills
            while process.poll() is None:
                if any((self.place / "cut" / f"{name}.tmp").exists() for name in CHECKPOINTS):
                    process.kill()
                    process.wait()
                    kills += 1
                    break
            messages = process.stderr.read()
            process.stderr.close()
            if process.returncode == DONE:
                break
            self.assertEqual(process.returncode, -signal.SIGKILL, messages)
            if kills > seen and kills >= 10:
                self.resume("--set", "output.checkpoint_every=1", "--steps", 400)
                break
        self.assertGreater(kills, 0)
        self.check_same_results("cut")


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


class RequestTest(ResumeTest):
    def test_resume_without_a_run_starts_it_and_says_so(self):
        self.run_whole("--steps", 100)
        messages = self.resume("--steps", 100).stderr
        self.assertIn("no checkpoint in 'cut': starting at step 0", messages)
        self.check_same_results("cut")

    def test_a_finished_run_is_left_alone(self):
        self.rgimp("run", self.case, "-o", "cut", "--quiet", "--steps", 100)
        before = {path: path.stat().st_mtime_ns for path in (self.place / "cut").rglob("*")}
        self.assertIn("is finished", self.resume("--steps", 100).stderr)
        after = {path: path.stat().st_mtime_ns for path in (self.place / "cut").rglob("*")}
        self.assertEqual(after, before)

    def test_a_finished_run_can_be_taken_further(self):
        self.run_whole("--steps", 500)
        self.rgimp("run", self.case, "-o", "cut", "--quiet", "--steps", 333)
        self.assertIn("going on from step 325", self.resume("--steps", 500).stderr)
        self.check_same_results("cut")

    def test_fewer_steps_than_are_done_are_refused(self):
        self.interrupt_at(200)
        self.fail_with(WRONG_REQUEST, "run", self.case, "-o", "cut", "--resume", "--steps", 50,
                       "--set", "output.snapshot_steps=[]", says=["expected at least"])

    def test_another_case_is_refused(self):
        self.interrupt_at(200)
        self.fail_with(WRONG_REQUEST, "run", self.case, "-o", "cut", "--resume",
                       "--set", "damping.local=0.5", says=["another case", "'local = 0.5'"])

    def test_resume_and_force_exclude_each_other(self):
        self.fail_with(WRONG_REQUEST, "run", self.case, "--resume", "--force", says=["--force"])

    def test_the_run_of_its_own_resolved_case(self):
        self.run_whole()
        self.interrupt_at(200)
        resolved = (self.place / "cut" / "case.toml").read_bytes()
        self.rgimp("run", "cut/case.toml", "-o", "cut", "--resume", "--quiet")
        self.assertEqual((self.place / "cut" / "case.toml").read_bytes(), resolved)
        self.check_same_results("cut")

    def test_two_runs_do_not_share_a_directory(self):
        process = self.start("--quiet", "--set", "time.steps=1000000")
        while not (self.place / "cut" / CHECKPOINTS[1]).exists():
            time.sleep(0.01)
        for way in ("--resume", "--force"):
            self.fail_with(WRONG_REQUEST, "run", self.case, "-o", "cut", way,
                           says=["another run is at work"])
        process.kill()
        process.communicate()


class SignalTest(ResumeTest):
    def test_signals_end_a_run_with_a_checkpoint(self):
        self.run_whole("--set", "output.checkpoint_every=1000000")
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            with self.subTest(signal=number):
                shutil.rmtree(self.place / "cut", ignore_errors=True)
                process = self.start("--set", "output.checkpoint_every=1000000",
                                     preexec_fn=hear_signals)
                while not (self.place / "cut" / "history.csv").exists():
                    time.sleep(0.005)
                process.send_signal(number)
                _, messages = process.communicate()
                self.assertEqual(process.returncode, 128 + number, messages)
                self.assertRegex(messages, r"stopped at step [\d,]+ with a checkpoint in 'cut'")
                self.assertFalse((self.place / "cut" / "summary.json").exists())
                self.resume("--set", "output.checkpoint_every=1000000")
                self.check_same_results("cut")


    def test_a_reader_that_goes_away_ends_a_run_with_a_checkpoint(self):
        process = subprocess.Popen(
            [COMMAND, "run", str(self.case), "-o", "cut", "--set", "time.steps=10000000"],
            cwd=self.place, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        process.stdout.readline()  # the first line of progress, after five seconds
        process.stdout.close()
        messages = process.stderr.read()
        process.stderr.close()
        self.assertEqual(process.wait(), 128 + signal.SIGPIPE, messages)
        self.assertIn("with a checkpoint in 'cut'", messages)


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
