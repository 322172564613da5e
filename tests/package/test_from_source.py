"""RGIMP's sources in another program's build: test_from_source.py CMAKE [unittest's options]

Each way builds the library, which takes minutes; test_package.py has the installed ones.
"""

import sys
import tempfile
import unittest
from pathlib import Path

from outside_command import output_of

CMAKE = sys.argv.pop(1)
HERE = Path(__file__).resolve().parent
SOURCE = HERE.parent.parent
CASE = SOURCE / "tests/support/breaking_block.toml"


class FromSource(unittest.TestCase):
    def build_and_run(self, project, *definitions):
        with tempfile.TemporaryDirectory(prefix="rgimp_package_") as build:
            output_of(CMAKE, "-S", HERE / project, "-B", build, "-G", "Ninja",
                      "-DCMAKE_BUILD_TYPE=Release", *definitions)
            targets = output_of(CMAKE, "--build", build, "--target", "help")
            for name in ("rgimp_test_main", "bench_step", "rgimp_python", "01_one_particle"):
                self.assertNotIn(name, targets)
            output_of(CMAKE, "--build", build, "--target", "outside")
            return output_of(Path(build) / "outside", CASE).strip()

    def test_both_ways_compute_the_same(self):
        commit = output_of("git", "-C", SOURCE, "rev-parse", "HEAD").strip()
        subdirectory = self.build_and_run("add_subdirectory", f"-DRGIMP_SOURCE={SOURCE}")
        fetched = self.build_and_run("fetch_content", f"-DRGIMP_REPOSITORY=file://{SOURCE}",
                                     f"-DRGIMP_COMMIT={commit}")
        self.assertRegex(subdirectory, r"^[0-9a-f]{16}$")
        self.assertEqual(fetched, subdirectory)


if __name__ == "__main__":
    unittest.main()
