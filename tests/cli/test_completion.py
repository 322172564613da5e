"""Completion in bash, against what --help says."""

import os
import re
import subprocess
import unittest
from pathlib import Path

from command_test import COMMAND, CommandTest

SCRIPT = Path(__file__).resolve().parents[2] / "engine/cli/completion/rgimp.bash"
# What bash does when TAB is pressed behind these words. compopt works only then.
TAB = """
source "$1" && shift
compopt() { :; }
COMP_WORDS=("$@") COMP_CWORD=$(($# - 1))
_rgimp
((${#COMPREPLY[@]} == 0)) || printf '%s\\n' "${COMPREPLY[@]}"
"""


class CompletionTest(CommandTest):
    def offered(self, *words):
        """For the last word; the command is behind a name in PATH, as it is for users."""
        done = subprocess.run(["bash", "-c", TAB, "bash", SCRIPT, "rgimp", *words],
                              cwd=self.place, capture_output=True, text=True, timeout=60,
                              env=os.environ | {"PATH": f"{COMMAND.parent}:{os.environ['PATH']}"})
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return done.stdout.splitlines()

    def section(self, name, *verb):
        text = self.rgimp(*verb, "--help").stdout
        found = re.search(rf"(?m)^{name}:\n((?:  .*\n)+)", text)
        return found[1].splitlines() if found else []

    def options(self, *verb):
        """Name -> what the option takes, of an independent look at the help."""
        options = {}
        for line in self.section("Options", *verb):
            if not line.startswith("   "):
                words = line.split()
                name = words[0].split(",")[-1]
                options[name] = words[1] if re.match(r"[A-Z]+(\.\w+)?$|KEY=", words[1]) else ""
        return options

    def verbs(self):
        return [line.split()[0] for line in self.section("Subcommands")
                if not line.startswith("   ")]

    def test_verbs_and_the_command_s_own_options(self):
        self.assertIn("sweep", self.verbs())
        self.assertEqual(self.offered(""), [*self.verbs(), *self.options()])
        self.assertEqual(self.offered("sw"), ["sweep"])
        self.assertEqual(self.offered("--v"), ["--version"])
        self.assertEqual(self.offered("nonsense", ""), [])

    def test_options_of_every_verb_are_those_of_its_help(self):
        for verb in self.verbs():
            with self.subTest(verb=verb):
                self.assertIn("--help", self.options(verb))
                self.assertEqual(self.offered(verb, "-"), list(self.options(verb)))
        self.assertIn("--resume", self.options("sweep"))
        self.assertEqual(self.offered("run", "block.toml", "--se"), ["--set"])

    def test_what_options_and_positionals_take(self):
        (self.place / "out put").mkdir()
        for name in ("b.png", "c.txt", "d.toml", "e.html"):
            (self.place / name).touch()
        directories = ["out put"]
        files = {"DIR": directories, "FILE.toml": ["block.toml", "d.toml", *directories],
                 "FILE.png": ["b.png", *directories], "FILE.html": ["e.html", *directories],
                 "N": [], "KEY=VALUE": [],
                 "FILE": ["b.png", "block.toml", "c.txt", "d.toml", "e.html", *directories]}
        taken = set()
        for verb in self.verbs():
            for option, kind in self.options(verb).items():
                if kind:
                    self.assertIn(kind, files, f"{verb} {option}: teach rgimp.bash its type")
                    self.assertEqual(sorted(self.offered(verb, option, "")), files[kind])
                    taken.add(kind)
            for line in self.section("Positionals", verb):
                kind = line.split()[1]
                if kind in files:
                    self.assertEqual(sorted(self.offered(verb, "")), files[kind])
        self.assertEqual(taken, set(files))
        self.assertEqual(self.offered("run", "-o", ""), directories)
        self.assertEqual(self.offered("run", "bl"), ["block.toml"])

    def test_templates(self):
        listed = [line.split()[0] for line in self.rgimp("new", "--list").stdout.splitlines()]
        self.assertEqual(self.offered("new", ""), listed)
        self.assertEqual(self.offered("new", "sing"), ["single-flaw"])

    def test_bash_knows_it(self):
        done = subprocess.run(["bash", "-c", 'source "$1" && complete -p rgimp', "bash", SCRIPT],
                              capture_output=True, text=True)
        self.assertEqual(done.stdout, "complete -F _rgimp rgimp\n")


if __name__ == "__main__":
    unittest.main()
