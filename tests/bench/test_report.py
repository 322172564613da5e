"""bench/report.py on made-up results."""

import json
import unittest

from report_test import ReportTest

CONTEXT = {
    "date": "2026-11-24T10:11:12+00:00", "host_name": "somewhere", "executable": "/some/where",
    "num_cpus": 2, "mhz_per_cpu": 2600, "load_avg": [0.25, 0.5, 0.5],
    "caches": [{"type": "Unified", "level": 3, "size": 33554432, "num_sharing": 1}],
    "cpu": "Processor X", "memory": "24 GiB", "isas": "reference, avx2", "compiler": "GNU 12.2.0",
    "flags": "-O3", "avx2_flags": "-mavx2", "avx512_flags": "-mavx512f", "version": "0.1.0",
    "commit": "abc1234"}


def medians(name, **counters):
    """As Google Benchmark writes five repetitions of which it reports aggregates."""
    common = {"name": name, "run_name": name, "run_type": "aggregate", "repetitions": 5}
    return [common | counters | {"aggregate_name": "median", "real_time": 12.5},
            common | {key: 0.01 for key in counters} | {"aggregate_name": "cv", "real_time": 0.02}]


def step_name(isa="reference", threads=1, integrator="musl", particles="lattice", cells=100):
    return (f"step/cells:{cells}/particles:{particles}/integrator:{integrator}/isa:{isa}/"
            f"threads:{threads}/real_time")


def step(speed, **setting):
    return medians(step_name(**setting), particles=79618.0, lanes_per_particle=1.125,
                   particle_steps_per_second=speed, model_bytes_per_second=speed * 200,
                   ns_per_particle_step_and_core=1e9 * setting.get("threads", 1) / speed)


def failed(name, message):
    return [{"name": name, "run_name": name, "run_type": "iteration", "repetitions": 5,
             "error_occurred": True, "error_message": message, "real_time": 0.0}] * 5


def size(cells, threads, speed):
    return medians(f"size/cells:{cells}/particles:lattice/integrator:musl/isa:avx2/"
                   f"threads:{threads}/real_time",
                   particles=8.0 * cells**2, particle_steps_per_second=speed,
                   startup_seconds=1e-6 * cells**2, bytes_per_particle=120.4)


def kernel(name, isa, nanoseconds):
    return medians(f"kernel/name:{name}/isa:{isa}/real_time", ns_per_particle=nanoseconds,
                   particles_per_second=1e9 / nanoseconds)


TRIAD = (medians("triad/threads:1/real_time", bytes_per_second=20e9) +
         medians("triad/threads:2/real_time", bytes_per_second=32e9))


class SyntheticTest(ReportTest):
    def write(self, rows, name="bench.json", **context):
        path = self.place / name
        path.write_text(json.dumps({"context": CONTEXT | context, "benchmarks": rows}),
                        encoding="utf-8")
        return path

    def test_machine(self):
        page = self.report(self.write(step(10e6)))
        self.assertEqual(self.row(page, "processor"), ["Processor X"])
        self.assertEqual(self.row(page, "version"), ["0.1.0, commit abc1234"])
        self.assertEqual(self.row(page, "date"), ["2026-11-24"])
        self.assertEqual(self.row(page, "load average before"), ["0.25"])
        self.assertIn("L3 Unified 32768 KiB", page)
        self.assertNotIn("somewhere", page + self.data.read_text())

    def test_ratios(self):
        page = self.report(self.write(
            TRIAD + step(10e6) + step(40e6, isa="avx2") + step(72e6, isa="avx2", threads=2)))
        self.assertIn("### Lattice, 79,618 particles, 1.12 lanes each", page)
        self.assertEqual(self.row(page, "musl, reference"),
                         ["10.0", "–", "1.00", "–", "–", "100.0", "2.0", "0.10"])
        self.assertEqual(self.row(page, "musl, avx2"),
                         ["40.0", "72.0", "4.00", "7.20", "1.80", "27.8", "14.4", "0.45"])
        self.assertIn("Coefficients of variation up to 2.0%.", page)

    def test_a_ratio_is_to_the_reference_of_the_same_case(self):
        page = self.report(self.write(
            step(10e6) + step(30e6, isa="avx2") + step(5e6, integrator="usl") +
            step(30e6, isa="avx2", integrator="usl")))
        self.assertEqual(self.row(page, "musl, avx2")[1], "3.00")
        self.assertEqual(self.row(page, "usl, avx2")[1], "6.00")

    def test_a_section_for_each_size_and_arrangement(self):
        page = self.report(self.write(step(10e6, cells=1000) + step(10e6, particles="random") +
                                      step(10e6)))
        titles = [line.split(",")[0] for line in page.splitlines() if line.startswith("### ")]
        self.assertEqual(titles, ["### Lattice", "### Random", "### Lattice"])

    def test_missing_reference(self):
        page = self.report(self.write(step(40e6, isa="avx2")))
        self.assertEqual(self.row(page, "musl, avx2"), ["40.0", "–", "–", "25.0", "8.0", "–"])

    def test_failed_verification(self):
        name = step_name(isa="avx2")
        page = self.report(self.write(step(10e6) + failed(name, "differs by 0.5") +
                                      step(60e6, isa="avx2", threads=2)))
        self.assertIn(f"## Failed\n\n- `{name}`: differs by 0.5\n", page)
        self.assertEqual(self.row(page, "musl, avx2")[:5], ["failed", "60.0", "failed", "6.00", "–"])

    def test_failed_reference(self):
        page = self.report(self.write(failed(step_name(), "left the grid") + step(40e6, isa="avx2")))
        self.assertEqual(self.row(page, "musl, reference")[:2], ["failed", "–"])
        self.assertEqual(self.row(page, "musl, avx2")[:2], ["40.0", "–"])

    def test_everything_failed(self):
        page = self.report(self.write(failed(step_name(), "left the grid") +
                                      failed("size/cells:11/threads:1", "left the grid")))
        self.assertEqual(self.row(page, "musl, reference")[0], "failed")
        self.assertTrue(self.picture.exists())

    def test_peaks(self):
        rows = [row for n in (1, 2) for row in medians(f"fma/isa:avx2/threads:{n}/real_time",
                                                       flops=50e9 * n)]
        page = self.report(self.write(TRIAD + rows))
        self.assertEqual(self.row(page, "multiply-add, avx2, GFLOP/s"), ["50.0", "100.0", "2.00"])
        self.assertEqual(self.row(page, "triad, GB/s"), ["20.0", "32.0", "1.60"])

    def test_kernels(self):
        page = self.report(self.write(
            kernel("a new one", "avx2", 1.0) + kernel("G2P", "avx2", 2.5) +
            kernel("G2P", "avx512", 1.25) + kernel("strain", "reference", 60.0) +
            kernel("strain", "avx2", 12.0)))
        self.assertIn("| ns, reference | ns, avx2 | ns, avx512 | ratio, avx2 | ratio, avx512 |\n",
                      page)
        self.assertEqual(self.row(page, "strain"), ["60.00", "12.00", "–", "5.00", "–"])
        self.assertEqual(self.row(page, "G2P"), ["–", "2.50", "1.25", "–", "–"])
        order = [page.index(f"| {name} |") for name in ("strain", "G2P", "a new one")]
        self.assertEqual(order, sorted(order))

    def test_failed_kernels(self):
        page = self.report(self.write(
            kernel("strain", "reference", 60.0) +
            failed("kernel/name:strain/isa:avx2/real_time", "differs by 0.5") +
            failed("kernel/name:G2P/isa:reference/real_time", "differs by 0.5") +
            kernel("G2P", "avx2", 2.5)))
        self.assertEqual(self.row(page, "strain"), ["60.00", "failed", "failed"])
        self.assertEqual(self.row(page, "G2P"), ["failed", "2.50", "–"])

    def test_sizes(self):
        rows = [row for cells in (100, 11) for n in (1, 2) for row in size(cells, n, 50e6 * n)]
        page = self.report(self.write(step(10e6), "step.json"), self.write(rows, "size.json"))
        self.assertEqual(self.row(page, "968"), ["20.00", "10.00", "0.125", "0.125", "120"])
        self.assertLess(page.index("| 968 |"), page.index("| 80,000 |"))
        self.assertIn("(size.png)", page)
        self.assertEqual(self.picture.read_bytes()[:4], b"\x89PNG")

    def test_no_sizes(self):
        self.assertNotIn("size.png", self.report(self.write(step(10e6))))
        self.assertFalse(self.picture.exists())

    def test_one_repetition(self):
        row = step(10e6)[0]
        del row["aggregate_name"]
        page = self.report(self.write([row | {"run_type": "iteration", "repetitions": 1}]))
        self.assertEqual(self.row(page, "musl, reference")[0], "10.0")
        self.assertNotIn("Coefficients of variation", page)

    def test_what_was_kept_is_reported_again(self):
        page = self.report(self.write(TRIAD + step(10e6) + size(11, 1, 50e6)))
        self.assertEqual(self.report(self.data), page)

    def test_errors(self):
        def refuse(message, *inputs):
            done = self.run_report(*inputs)
            self.assertEqual(done.returncode, 4, done.stderr)
            self.assertIn(message, done.stderr)
            self.assertNotIn("Traceback", done.stderr)

        one = self.write(step(10e6))
        refuse("differs from", one, self.write([], "other.json", cpu="Processor Y"))
        refuse("holds no benchmark results", self.place / "missing.json")
        one.write_text("{")
        refuse("holds no benchmark results", one)


if __name__ == "__main__":
    unittest.main()
