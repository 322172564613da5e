"""The man page is what make_page.py makes of the help, and groff has nothing to complain of."""

import re
import subprocess
import sys
import unittest
from pathlib import Path

from command_test import COMMAND, CommandTest

MAN = Path(__file__).resolve().parents[2] / "engine/cli/man"


class ManPageTest(CommandTest):
    def test_it_is_up_to_date(self):
        made = subprocess.run([sys.executable, "-B", MAN / "make_page.py", COMMAND],
                              capture_output=True, text=True, check=True).stdout
        self.assertEqual((MAN / "rgimp.1").read_text(encoding="utf-8"), made,
                         "the help has changed: run engine/cli/man/make_page.py build/release/"
                         "bin/rgimp > engine/cli/man/rgimp.1")

    def test_it_renders_without_warnings(self):
        done = subprocess.run(["groff", "-man", "-Tutf8", "-ww", MAN / "rgimp.1"],
                              capture_output=True, text=True)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        shown = re.sub(".\b", "", done.stdout)  # bold is struck twice
        for word in ("EXIT STATUS", "--resume", "single_flaw.toml", "closure_at_peak_m"):
            self.assertIn(word, shown)


if __name__ == "__main__":
    unittest.main()
