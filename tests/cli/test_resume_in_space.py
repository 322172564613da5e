"""A run in three dimensions that is killed and resumed leaves what one never interrupted does."""

import shutil
import unittest

from resume_test import ResumeTest


class SpaceTest(ResumeTest):
    def setUp(self):
        super().setUp()
        self.case.write_text(
            self.case.read_text(encoding="utf-8")
            .replace("dimension = 2", "dimension = 3")
            .replace("center = [0.0, 0.0]", "center = [0.0, 0.0, 0.0]")
            .replace("size = [5e-3, 10e-3]", "size = [3e-3, 6e-3, 2e-3]")
            .replace("speed = -1.0", "speed = -0.1")
            .replace("checkpoint_every = 25", "checkpoint_every = 50")
            .replace("steps = 3000", "steps = 1500"), encoding="utf-8")

    def test_kills_before_and_after_failure_change_no_bit(self):
        self.run_whole("--threads", 1)
        summary = self.summary("whole")
        first_failure = summary["first_failure"]["step"]
        self.assertTrue(100 < first_failure < 900, first_failure)
        for step in (60, 900):
            shutil.rmtree(self.place / "cut", ignore_errors=True)
            self.interrupt_at(step)
            self.assertIn("going on from step", self.resume("--threads", 2).stderr)
            self.check_same_results("cut")


if __name__ == "__main__":
    unittest.main()
