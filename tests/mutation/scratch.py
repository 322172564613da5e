"""A copy of the sources with a build folder that stays warm, and the tests run there."""

import html
import re
import resource
import shutil
import subprocess
import sys
from dataclasses import dataclass

from table import ROOT

# The test programs, from the fastest to the slowest.
PROGRAMS = ("binning", "guards", "parallel", "failure", "geometry", "case_file", "output", "shape",
            "conservation", "kernels", "platens", "cracking", "elastic", "determinism",
            "checkpoint")
# Slow tests of the command, for mutants that name them.
SCRIPTS = {"resume": "tests/cli/test_resume.py",
           "resume_damage": "tests/cli/test_resume_damage.py"}
# What the build reads, but for the sources of other programs.
COPIED = ("CMakeLists.txt", "engine/**/*", "kernels/**/*", "tests/**/*", "examples/*.toml")
# Compiling the kernels takes most of a mutant's time, so it is done once: the units of the other
# instruction sets hand out AVX2's table. Two batches a group there, so parts of a group count.
UNIT = """#include "rgimp/kernels/isa_tables.hpp"
namespace rgimp::kernels {{
const KernelTable<2> k{isa}Kernels2 = kAvx2Kernels2;
const KernelTable<3> k{isa}Kernels3 = kAvx2Kernels3;
}}
"""
STAND_INS = {"kernels/src/isa_baseline.cpp": UNIT.format(isa="Baseline"),
             "kernels/src/isa_avx512.cpp": UNIT.format(isa="Avx512")}


class BrokenBuild(Exception):
    """The sources do not compile."""


# What hangs without computing.
WALL_LIMIT = 1800.0  # s


@dataclass(frozen=True)
class Result:
    """What a test program said: `failed` names its first failing case, empty if all passed."""
    failed: str
    seconds: float  # of computing


def write_if_changed(path, content):
    """Leaves what is the same alone, so that it is not built again."""
    if not path.is_file() or path.read_bytes() != content:
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content)


class Scratch:
    def __init__(self, folder, jobs):
        self.source = folder / "source"
        self.build = folder / "build"
        self.jobs = jobs
        self.limit = {}  # seconds a program may compute; on a busy machine it may wait for longer
        self.patched = {}  # file -> what it was

    def copy_sources(self):
        wanted = {str(path.relative_to(ROOT)) for pattern in COPIED for path in ROOT.glob(pattern)
                  if path.is_file() and "__pycache__" not in path.parts}
        for name in wanted:
            content = STAND_INS.get(name, "").encode() or (ROOT / name).read_bytes()
            write_if_changed(self.source / name, content)
        for path in self.source.rglob("*"):
            if path.is_file() and str(path.relative_to(self.source)) not in wanted:
                path.unlink()

    def configure(self):
        generator = ["-G", "Ninja"] if shutil.which("ninja") else []
        subprocess.run(["cmake", *generator, "-S", self.source, "-B", self.build,
                        "-DCMAKE_BUILD_TYPE=Release", "-DRGIMP_BUILD_BENCH=OFF",
                        "-DRGIMP_BUILD_EXAMPLES=OFF", "-DRGIMP_INSTALL=OFF"],
                       check=True, stdout=subprocess.DEVNULL)

    def patch(self, edits):
        """The sources with these edits and no others."""
        content = dict(self.patched)
        self.patched = {}
        for edit in edits:
            if edit.file not in content:
                content[edit.file] = (self.source / edit.file).read_text(encoding="utf-8")
            self.patched.setdefault(edit.file, content[edit.file])
            content[edit.file] = content[edit.file].replace(edit.old, edit.new)
        for name, text in content.items():
            write_if_changed(self.source / name, text.encode("utf-8"))

    def compile(self, program):
        target = "rgimp" if program in SCRIPTS else f"test_{program}"
        done = subprocess.run(["cmake", "--build", self.build, "-j", str(self.jobs), "--target",
                               target], capture_output=True, text=True, check=False)
        if done.returncode != 0:
            raise BrokenBuild("\n".join(line for line in done.stdout.split("\n")
                                        if "error" in line.lower())[:400] or done.stdout[-400:])

    def run(self, program):
        limit = self.limit.get(program, 300)
        before = computed_seconds()
        try:
            done = subprocess.run(self.command(program), cwd=self.build, stdout=subprocess.PIPE,
                                  stderr=subprocess.STDOUT, check=False, timeout=WALL_LIMIT,
                                  preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU,
                                                                        (limit, limit)))
        except subprocess.TimeoutExpired as late:
            return Result(f"{last_case(late.stdout or b'')} (hangs)", WALL_LIMIT)
        seconds = computed_seconds() - before
        if done.returncode == 0:
            return Result("", seconds)
        late = f" (over {limit} s)" if seconds >= limit else ""
        return Result(last_case(done.stdout) + late, seconds)

    def command(self, program):
        if program in SCRIPTS:
            return [sys.executable, "-B", self.source / SCRIPTS[program],
                    self.build / "bin/rgimp", "-f", "-v"]
        return [self.build / f"tests/test_{program}", "--abort", "-r", "xml"]

    def first_failure(self, edits, programs):
        """The program and case that fail first with these edits; None if all pass."""
        for program in programs:
            if program not in self.limit:
                self.check_unchanged(program)
            self.patch(edits)
            self.compile(program)
            result = self.run(program)
            if result.failed:
                return program, result.failed
        return None

    def check_unchanged(self, program):
        """It passes as things are; sets what a mutant may compute, a hang's limit."""
        self.patch(())
        self.compile(program)
        result = self.run(program)
        if result.failed:
            sys.exit(f"error: without a mutant test_{program} fails: {result.failed}")
        self.limit[program] = 20 + round(10.0 * result.seconds)


def computed_seconds():
    """Of all that has been run to its end."""
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def last_case(output):
    """The case that ran when a program stopped at its first failure, of Catch2 or unittest."""
    text = output.decode("utf-8", "replace")
    names = re.findall(r'<TestCase name="([^"]*)"|^(test_\w+) \(', text, re.MULTILINE)
    return html.unescape(names[-1][0] or names[-1][1]) if names else "before the first case"
