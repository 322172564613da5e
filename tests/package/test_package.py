"""RGIMP as other programs get it: installed, through find_package, or as a subdirectory.

Usage: test_package.py CMAKE GENERATOR CXX_COMPILER BUILD_DIRECTORY [unittest's options]
"""

import json
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from outside_command import output_of

CMAKE, GENERATOR, COMPILER, BUILD = (sys.argv.pop(1) for _ in range(4))
HERE = Path(__file__).resolve().parent
SOURCE = HERE.parent.parent
STEPS = 20


def configure(source, build, *definitions):
    output_of(CMAKE, "-S", source, "-B", build, "-G", GENERATOR, f"-DCMAKE_CXX_COMPILER={COMPILER}",
              "-DCMAKE_BUILD_TYPE=Release", *definitions)


def compile_by_pkg_config(source, prefix, program):
    """In a tree that was moved, so that no path of the build can help."""
    moved = prefix.with_name("moved")
    prefix.rename(moved)
    try:
        directory = next(moved.glob("lib/**/pkgconfig"))
        flags = output_of("env", f"PKG_CONFIG_PATH={directory}", "pkg-config", "--cflags", "--libs",
                          "rgimp").split()
        output_of(COMPILER, "-std=c++20", source, "-o", program, *flags)
    finally:
        moved.rename(prefix)


class Package(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory(prefix="rgimp_package_")
        cls.addClassCleanup(folder.cleanup)
        cls.folder = Path(folder.name)
        cls.prefix = cls.folder / "prefix"
        output_of(CMAKE, "--install", BUILD, "--prefix", cls.prefix)

    def test_installed_library_computes_what_the_installed_command_does(self):
        output = self.folder / "output"
        case = self.prefix / "share/rgimp/examples/single_flaw.toml"
        output_of(self.prefix / "bin/rgimp", "run", case, "-o", output,
                  "--set", f"time.steps={STEPS}", "--set", "output.snapshot_steps=[]")
        summary = json.loads((output / "summary.json").read_text())

        self.assertEqual(summary["steps"], STEPS)

        build = self.folder / "find_package"
        configure(HERE / "find_package", build, f"-DCMAKE_PREFIX_PATH={self.prefix}")
        output_of(CMAKE, "--build", build)
        program = self.folder / "by_pkg_config"
        compile_by_pkg_config(HERE / "find_package/main.cpp", self.prefix, program)
        for outside in (build / "outside", program):
            with self.subTest(outside):
                self.assertEqual(output_of(outside, output / "case.toml").strip(),
                                 summary["state_hash"])

    def test_installed_programs_in_python_find_their_modules(self):
        nothing = self.folder / "nothing"
        for words in (["rgimp-plot"], ["rgimp-report"], ["rgimp", "report"]):
            with self.subTest(words):
                done = subprocess.run([self.prefix / "bin" / words[0], *words[1:], nothing],
                                      capture_output=True, text=True)
                self.assertEqual(done.returncode, 2, done.stderr)
                self.assertIn(f"no such directory: {nothing}", done.stderr)

    def test_installed_python_package_is_found_under_the_prefix(self):
        printed = output_of("env", f"PYTHONPATH={self.prefix}/lib/python3/dist-packages",
                            "/usr/bin/python3", "-c", "import rgimp; print(rgimp.__version__)")
        self.assertEqual(printed, output_of(self.prefix / "bin/rgimp", "--version").split()[-1]
                         + "\n")

    def test_man_page_and_completion_are_where_they_are_looked_for(self):
        share = self.prefix / "share"
        self.assertTrue((share / "man/man1/rgimp.1.gz").is_file())
        for name in ("bash-completion/completions/rgimp", "zsh/vendor-completions/_rgimp",
                     "fish/vendor_completions.d/rgimp.fish"):
            self.assertTrue((share / name).is_file(), name)

    def test_subdirectory_brings_no_tests_and_installs_nothing(self):
        build = self.folder / "add_subdirectory"
        configure(HERE / "add_subdirectory", build, f"-DRGIMP_SOURCE={SOURCE}")
        parts = {path.parent.name for path in build.glob("rgimp/*/cmake_install.cmake")}
        self.assertEqual(parts, {"kernels", "engine"})
        prefix = self.folder / "subdirectory_prefix"
        output_of(CMAKE, "--install", build, "--prefix", prefix)
        self.assertFalse(prefix.exists())


if __name__ == "__main__":
    unittest.main()
