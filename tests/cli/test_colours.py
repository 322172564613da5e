"""Colours: on a terminal alone, and not where NO_COLOR or a dumb one says no."""

import os
import pty
import subprocess
import unittest

from command_test import COMMAND, CommandTest

RED, YELLOW, BOLD, PLAIN = "\x1b[1;31m", "\x1b[1;33m", "\x1b[1m", "\x1b[0m"


class ColoursTest(CommandTest):
    def on_terminal(self, *arguments, **environment):
        """What the command shows on a terminal that is its stderr; stdout is none."""
        ours, its = pty.openpty()
        self.addCleanup(os.close, ours)
        with subprocess.Popen([COMMAND, *map(str, arguments)], cwd=self.place, stderr=its,
                              stdout=subprocess.PIPE,
                              env=os.environ | {"TERM": "xterm"} | environment) as process:
            os.close(its)
            shown = b""
            try:
                while piece := os.read(ours, 65536):
                    shown += piece
            except OSError:  # the other end is closed
                pass
            stdout = process.stdout.read()
        self.assertNotIn(b"\x1b", stdout)
        return shown.decode()

    def test_an_error_is_red_on_a_terminal(self):
        self.assertIn(f"rgimp: {RED}error:{PLAIN} ", self.on_terminal("run", "missing.toml"))

    def test_a_warning_is_yellow(self):
        shown = self.on_terminal("check", self.case, "--set", "output.snapshot_steps=[999]")
        self.assertIn(f"rgimp: {YELLOW}warning:{PLAIN} ", shown)

    def test_progress(self):
        shown = self.on_terminal("run", self.case, "--json")
        self.assertIn(f"\r{BOLD}100 %{PLAIN} [###", shown)

    def test_not_where_it_is_not_wanted(self):
        for environment in ({"NO_COLOR": "1"}, {"TERM": "dumb"}):
            shown = self.on_terminal("run", "missing.toml", **environment)
            self.assertIn("rgimp: error: ", shown)
            self.assertNotIn("\x1b", shown)
        self.assertIn(RED, self.on_terminal("run", "missing.toml", NO_COLOR=""))

    def test_not_in_a_file(self):
        self.assertTrue(self.attempt("run", "missing.toml", TERM="xterm").stderr.startswith(
            "rgimp: error: "))


if __name__ == "__main__":
    unittest.main()
