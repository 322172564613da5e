"""Checkpoints, --resume and signals: a run that is interrupted loses nothing."""

import random
import shutil
import signal
import subprocess
import time
import unittest

from command_test import COMMAND, DONE, WRONG_REQUEST
from resume_test import CHECKPOINTS, ResumeTest, hear_signals


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


if __name__ == "__main__":
    unittest.main()
