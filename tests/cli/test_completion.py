"""Completion in bash, against what --help says; zsh and fish, which ask bash's file, in themselves."""

import os
import pty
import re
import subprocess
import unittest
from pathlib import Path

from command_test import COMMAND, CommandTest

SCRIPTS = Path(__file__).resolve().parents[2] / "engine/cli/completion"
BASH = SCRIPTS / "bash-completion/completions/rgimp"
# The command is behind a name in PATH, as it is for users.
ENVIRONMENT = os.environ | {"PATH": f"{COMMAND.parent}:{os.environ['PATH']}", "TERM": "dumb"}
# What bash does when TAB is pressed behind these words. compopt works only then.
TAB = """
source "$1" && shift
compopt() { :; }
COMP_WORDS=("$@") COMP_CWORD=$(($# - 1))
_rgimp
((${#COMPREPLY[@]} == 0)) || printf '%s\\n' "${COMPREPLY[@]}"
"""
# An interactive zsh in which Control-X writes the line that is being edited to the file `line`.
ZSH = """
fpath=($1 $fpath) && autoload -Uz compinit && compinit -D -u
write_line() { print -r -- "$BUFFER" >line.new && mv line.new line && zle kill-buffer }
zle -N write_line && bindkey '^X' write_line
"""


class CompletionTest(CommandTest):
    def setUp(self):
        super().setUp()
        (self.place / "out put").mkdir()
        for name in ("b.png", "c.txt", "d.toml", "e.html"):
            (self.place / name).touch()

    def output_of(self, *command):
        done = subprocess.run(command, cwd=self.place, capture_output=True, text=True, timeout=60,
                              env=ENVIRONMENT)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return done.stdout.splitlines()

    def offered(self, *words):
        """For the last word."""
        return self.output_of("bash", "-c", TAB, "bash", BASH, "rgimp", *words)

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

    def templates(self):
        return [line.split()[0] for line in self.rgimp("new", "--list").stdout.splitlines()]

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
        directories = ["out put"]
        files = {"DIR": directories, "FILE.toml": ["block.toml", "d.toml", *directories],
                 "FILE.png": ["b.png", *directories], "FILE.html": ["e.html", *directories],
                 "N": [], "KEY=VALUE": [],
                 "FILE": ["b.png", "block.toml", "c.txt", "d.toml", "e.html", *directories]}
        taken = set()
        for verb in self.verbs():
            for option, kind in self.options(verb).items():
                if kind:
                    self.assertIn(kind, files, f"{verb} {option}: teach {BASH} its type")
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
        self.assertEqual(self.offered("new", ""), self.templates())
        self.assertEqual(self.offered("new", "sing"), ["single-flaw"])

    def test_bash_knows_it(self):
        self.assertEqual(self.output_of("bash", "-c", 'source "$1" && complete -p rgimp', "bash", BASH),
                         ["complete -F _rgimp rgimp"])

    def test_fish(self):
        def offered(line):
            script = SCRIPTS / "fish/vendor_completions.d/rgimp.fish"
            lines = self.output_of("fish", "--no-config", "-c", "source $argv[1]; complete -C $argv[2]",
                                   str(script), line)
            return [line.split("\t")[0] for line in lines]

        self.assertEqual(offered("rgimp "), [*sorted(self.verbs()), *self.options()])
        self.assertEqual(sorted(offered("rgimp run -")), sorted(self.options("run")))
        self.assertEqual(offered("rgimp new "), sorted(self.templates()))
        self.assertEqual(offered("rgimp run "), ["block.toml", "d.toml", "out put/"])
        self.assertEqual(offered("rgimp check --picture "), ["b.png", "out put/"])
        self.assertEqual(offered("rgimp run block.toml -o "), ["out put/"])
        self.assertEqual(offered("rgimp run --steps "), [])
        self.assertIn("c.txt", offered("rgimp cracks --json "))

    def completed_in_zsh(self, *lines):
        """What TAB makes of each line."""
        (self.place / "setup").write_text(ZSH)
        process, terminal = pty.fork()
        if process == 0:
            os.chdir(self.place)
            os.execvpe("zsh", ["zsh", "-f", "-i"], ENVIRONMENT)
        self.addCleanup(os.waitpid, process, 0)
        self.addCleanup(os.close, terminal)
        os.write(terminal, f"source ./setup {SCRIPTS}/zsh/vendor-completions\n".encode())
        return [self.completed(terminal, line) for line in lines]

    def completed(self, terminal, line):
        saved = self.place / "line"
        os.write(terminal, line.encode() + b"\t\x18")
        while not saved.exists():  # reading what zsh shows keeps it going; a hang ends the test
            os.read(terminal, 4096)
        text = saved.read_text()
        saved.unlink()
        return text.rstrip("\n")

    def test_zsh(self):
        pairs = {"rgimp sw": "rgimp sweep ", "rgimp run bl": "rgimp run block.toml ",
                 "rgimp new dou": "rgimp new double-flaw ",
                 "rgimp run block.toml --fo": "rgimp run block.toml --force ",
                 "rgimp run block.toml -o o": "rgimp run block.toml -o out\\ put/",
                 "rgimp check --picture b": "rgimp check --picture b.png ",
                 "rgimp cracks --json c": "rgimp cracks --json c.txt "}
        self.assertEqual(dict(zip(pairs, self.completed_in_zsh(*pairs))), pairs)


if __name__ == "__main__":
    unittest.main()
