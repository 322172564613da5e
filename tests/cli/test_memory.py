"""The memory that the command announces is what a run takes, and one too large never starts."""

import os
import re
import subprocess
import unittest

from command_test import COMMAND, WRONG_REQUEST, CommandTest

UNITS = {"KiB": 2.0**10, "MiB": 2.0**20, "GiB": 2.0**30}

CUBE = """
dimension = 3
[grid]
cell_size = 1e-3
[[body]]
shape = "box"
center = [0.0, 0.0, 0.0]
size = [44e-3, 44e-3, 44e-3]
material = "rock"
[material.rock]
density = 2600.0
youngs_modulus = 17e9
poisson_ratio = 0.14
[time]
steps = 1
"""
SQUARE = (CUBE.replace("dimension = 3", "dimension = 2").replace("[0.0, 0.0, 0.0]", "[0.0, 0.0]")
          .replace("[44e-3, 44e-3, 44e-3]", "[400e-3, 400e-3]"))


class MemoryTest(CommandTest):
    def peak_of(self, *arguments, code=0):
        """Bytes that the command had resident at most, and what it printed on both streams."""
        with subprocess.Popen([COMMAND, *map(str, arguments)], cwd=self.place, text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT) as process:
            text = process.stdout.read()
            _, status, usage = os.wait4(process.pid, 0)
            process.returncode = os.waitstatus_to_exitcode(status)
        self.assertEqual(process.returncode, code, text)
        return usage.ru_maxrss * 1024.0, text

    def share_of_announced(self, *arguments):
        """The peak over what the command said it would be, and what it printed."""
        peak, text = self.peak_of("run", self.case, *arguments)
        announced, unit = re.search(r"(?m)^memory .* at most ([0-9.]+) (\w+)", text).groups()
        return peak / (float(announced) * UNITS[unit]), text

    # Half of it is columns of whole pages; freed blocks below 4 MiB are kept by the heap.

    def test_a_run_takes_at_its_peak_what_it_said(self):
        for text in (CUBE, SQUARE):
            self.case.write_text(text, encoding="utf-8")
            share, _ = self.share_of_announced("--force")
            self.assertGreater(share, 0.85)
            self.assertLess(share, 1.15)

    def test_a_run_that_goes_on_takes_no_more_than_it_said(self):
        for text in (CUBE, SQUARE):
            self.case.write_text(text, encoding="utf-8")
            every_step = ("--set", "output.checkpoint_every=1")
            self.share_of_announced("--force", "--steps", 2, *every_step)
            share, text = self.share_of_announced("--resume", "--steps", 3, *every_step)
            self.assertIn("going on from step 1", text)
            self.assertLess(share, 1.15)

    def test_a_case_beyond_the_memory_is_refused_before_it_takes_any(self):
        self.case.write_text(CUBE, encoding="utf-8")
        for verb in ("check", "run"):
            peak, text = self.peak_of(verb, self.case, "--set", "grid.cell_size=0.06e-3",
                                      code=WRONG_REQUEST)
            self.assertRegex(text, r"grid.cell_size: makes 4.15e\+08 nodes and 3.15e\+09 particles, "
                                   r"which take about 1003.[0-9] GiB of memory; expected no more "
                                   r"than the [0-9.]+ GiB that are free here")
            self.assertLess(peak, 100e6)


if __name__ == "__main__":
    unittest.main()
