"""Runs every code block of README.md and engine/docs: test_code_blocks.py RGIMP CMAKE BUILD CXX.

sh and python run, in their order, in a scratch directory laid out like the repository; cpp is
compiled against the installed library and runs; toml goes through `rgimp check`, parts of a case put
into a whole one before. Blocks without a language are what commands print. Nothing is left out but
what a comment in the page asks to, and that is listed with its reason.
"""

import os
import shutil
import subprocess
import sys
import tempfile
import tomllib
import unittest
from pathlib import Path

import code_blocks
import merged_case

ROOT = Path(__file__).resolve().parents[2]
RGIMP, CMAKE, BUILD, CXX = map(Path, (sys.argv.pop(1) for _ in range(4)))
PAGES = [ROOT / "README.md", *sorted((ROOT / "engine/docs").glob("*.md"))]
BASES = {2: "single_flaw.toml", 3: "block_penny_flaw.toml"}
SECONDS = 120  # for one block

# In the place of rgimp: runs of shortened blocks take RGIMP_DOCS_STEPS steps.
SHORT_RGIMP = """#!/bin/bash
words=()
while (($#)); do
  if [[ -n $RGIMP_DOCS_STEPS && $1 == --steps ]]; then shift; else words+=("$1"); fi
  shift
done
case ${{words[0]}} in
  run | sweep) exec {rgimp} "${{words[@]}}" ${{RGIMP_DOCS_STEPS:+--steps "$RGIMP_DOCS_STEPS"}} ;;
  *) exec {rgimp} "${{words[@]}}" ;;
esac
"""
# In the place of cmake: this build is the one that the pages make.
BUILT_CMAKE = """#!/bin/bash
case "$*" in
  "--preset release" | "--build --preset release") echo "built already: cmake $*" ;;
  *) exec {cmake} "$@" ;;
esac
"""
PROJECT = """cmake_minimum_required(VERSION 3.25)
project(blocks CXX)
find_package(rgimp CONFIG REQUIRED)
foreach(block {names})
  add_executable(${{block}} ${{block}}.cpp)
  target_link_libraries(${{block}} PRIVATE rgimp::engine)
endforeach()
"""


class CodeBlocksTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        place = tempfile.TemporaryDirectory(prefix="rgimp_docs_")
        cls.addClassCleanup(place.cleanup)
        cls.place = Path(place.name)
        shutil.copytree(ROOT / "examples", cls.place / "examples",
                        ignore=lambda folder, names: {name for name in names
                                                      if not name.endswith(".toml")})
        for folder in ("engine", "bench", "tests", "kernels"):
            (cls.place / folder).symlink_to(ROOT / folder)
        cls.programs = cls.place / "build/release/bin"
        cls.programs.mkdir(parents=True)
        for name, text in (("rgimp", SHORT_RGIMP), ("cmake", BUILT_CMAKE)):
            (cls.programs / name).write_text(text.format(rgimp=RGIMP, cmake=CMAKE))
            (cls.programs / name).chmod(0o755)
        for name in ("rgimp-plot", "rgimp-report"):
            (cls.programs / name).symlink_to(ROOT / "engine/python" / name)
        cls.blocks = [block for page in PAGES for block in code_blocks.read(page, ROOT)]

    def run_in_place(self, words, steps=""):
        done = subprocess.run(
            ["timeout", str(SECONDS), *words], cwd=self.place, capture_output=True, text=True,
            check=False, stdin=subprocess.DEVNULL,
            env=os.environ | {"RGIMP_DOCS_STEPS": steps, "PYTHONDONTWRITEBYTECODE": "1",
                              "PYTHONPATH": str(BUILD / "python"),
                              "PATH": f"{self.programs}:{os.environ['PATH']}"})
        self.assertEqual(done.returncode, 0, done.stdout[-3000:] + done.stderr[-3000:])

    def chosen(self, *languages):
        return [block for block in self.blocks
                if block.language in languages and not block.skipped]

    def test_every_block_is_of_a_kind_that_is_run(self):
        for block in self.blocks:
            self.assertIn(block.language, ("", "sh", "python", "cpp", "toml"), block.place)
            if block.skipped:
                print(f"{block.place}: not run: {block.skipped}", flush=True)
        for page in PAGES:
            fences = page.read_text(encoding="utf-8").count("\n```")
            self.assertEqual(fences, 2 * len(code_blocks.read(page, ROOT)), page)

    def test_commands_and_scripts(self):
        for block in self.chosen("sh", "python"):
            with self.subTest(block.place):
                words = {"sh": ["bash", "-euo", "pipefail", "-c"],
                         "python": ["/usr/bin/python3", "-c"]}[block.language]
                self.run_in_place([*words, block.text], block.steps)

    def test_cases(self):
        self.assertTrue(self.chosen("toml"))
        for block in self.chosen("toml"):
            with self.subTest(block.place):
                part = tomllib.loads(block.text)
                text = block.text
                if "material" not in part or "body" not in part:
                    name = BASES[part.get("dimension", 2)]
                    base = tomllib.loads((ROOT / "examples" / name).read_text(encoding="utf-8"))
                    text = merged_case.case_text(merged_case.merge(base, part))
                (self.place / "block.toml").write_text(text, encoding="utf-8")
                self.run_in_place([RGIMP, "check", "block.toml"])

    def test_programs(self):
        blocks = self.chosen("cpp")
        self.assertTrue(blocks)
        names = [f"block_{number}" for number in range(len(blocks))]
        project = self.place / "project"
        project.mkdir()
        for name, block in zip(names, blocks):
            (project / f"{name}.cpp").write_text(block.text, encoding="utf-8")
        (project / "CMakeLists.txt").write_text(PROJECT.format(names=" ".join(names)))
        self.run_in_place([CMAKE, "--install", BUILD, "--prefix", self.place / "prefix"])
        self.run_in_place([CMAKE, "-S", project, "-B", project / "build", "-G", "Ninja",
                           f"-DCMAKE_CXX_COMPILER={CXX}",
                           f"-DCMAKE_PREFIX_PATH={self.place / 'prefix'}"])
        self.run_in_place([CMAKE, "--build", project / "build"])
        for name, block in zip(names, blocks):
            with self.subTest(block.place):
                self.run_in_place([project / "build" / name])


if __name__ == "__main__":
    unittest.main()
