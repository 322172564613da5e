"""The benchmark programs: what they offer, and that a benchmark is verified, runs and is reported.

Usage: test_programs.py BENCH_STEP BENCH_KERNELS BENCH_SIZE [unittest's options]
"""

import json
import subprocess
import sys
import unittest

from report_test import ReportTest

BENCH_STEP, BENCH_KERNELS, BENCH_SIZE = (sys.argv.pop(1) for _ in range(3))
SHORT = ("--benchmark_min_time=0.001", "--benchmark_repetitions=2")


def output_of(*command):
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise AssertionError(f"{command} exits {done.returncode}\n{done.stdout}{done.stderr}")
    return done.stdout


class Programs(ReportTest):
    def measure(self, program, benchmark):
        """The document of the one benchmark whose name matches."""
        path = self.place / f"{len(list(self.place.iterdir()))}.json"
        output_of(program, *SHORT, f"--benchmark_filter=^{benchmark}/real_time$",
                  f"--benchmark_out={path}")
        document = json.loads(path.read_text(encoding="utf-8"))
        self.assertEqual(len({row["run_name"] for row in document["benchmarks"]}), 1, benchmark)
        return path, document

    def test_what_is_measured(self):
        steps = output_of(BENCH_STEP, "--benchmark_list_tests").split()
        for name in ("triad/threads:2", "fma/isa:baseline/threads:1",
                     "step/cells:100/particles:lattice/integrator:musl/isa:reference/threads:1",
                     "step/cells:100/particles:random/integrator:usf/isa:baseline/threads:2",
                     "step/cells:1000/particles:lattice/integrator:usl/isa:reference/threads:1",
                     "cube/cells:64/particles:lattice/integrator:musl/isa:reference/threads:1"):
            self.assertIn(name + "/real_time", steps)
        kernels = output_of(BENCH_KERNELS, "--benchmark_list_tests").split()
        for name in ("scatter_all", "accelerate_strain_and_move", "divide_by_mass", "weights",
                     "G2P", "stress", "failure"):
            for isa in ("reference", "baseline"):
                self.assertIn(f"kernel/name:{name}/isa:{isa}/real_time", kernels)
        self.assertEqual(len(output_of(BENCH_SIZE, "--benchmark_list_tests").split()), 20)

    def test_a_size_is_verified_and_reported(self):
        path, document = self.measure(BENCH_SIZE, "size/cells:11/.*/threads:2")
        row = document["benchmarks"][0]
        self.assertNotIn("error_occurred", row)
        self.assertEqual(row["particles"], 928)
        self.assertGreater(row["bytes_per_particle"], 8 * 12)
        for key in ("cpu", "memory", "isas", "compiler", "flags", "version"):
            self.assertNotIn(document["context"][key], ("", "unknown"), key)
        self.assertEqual(len(self.row(self.report(path), "928")), 5 - 2)

    def test_a_cube_is_verified_and_reported(self):
        path, document = self.measure(
            BENCH_STEP, "cube/cells:24/particles:lattice/integrator:musl/isa:baseline/threads:2")
        row = document["benchmarks"][0]
        self.assertNotIn("error_occurred", row)
        self.assertGreater(row["particles"], 24**3 * 7)
        self.assertLess(row["bytes_per_particle"], 230)
        self.assertIn("## Steps in three dimensions", self.report(path))

    def test_random_particles_are_verified(self):
        _, document = self.measure(
            BENCH_STEP, "step/cells:100/particles:random/integrator:musl/isa:baseline/threads:2")
        row = document["benchmarks"][0]
        self.assertNotIn("error_occurred", row)
        self.assertEqual(row["particles"], 79618)
        self.assertGreater(row["lanes_per_particle"], 1.5)

    def test_kernels_are_verified_and_reported(self):
        for name in ("strain_and_move", "failure"):
            path, document = self.measure(BENCH_KERNELS, f"kernel/name:{name}/isa:baseline")
            row = document["benchmarks"][0]
            self.assertNotIn("error_occurred", row)
            self.assertEqual(row["particles"], 79618)
            self.assertGreater(row["model_bytes_per_second"], 0)
            self.assertEqual(self.row(self.report(path), name)[1:], ["–"])

    def test_peak(self):
        _, document = self.measure(BENCH_STEP, "fma/isa:baseline/threads:1")
        self.assertGreater(document["benchmarks"][0]["flops"], 0)


if __name__ == "__main__":
    unittest.main()
