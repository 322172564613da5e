"""The page's tables, in Markdown."""

import math

from report_data import ratio

ISAS = ("reference", "baseline", "avx2", "avx512")
INTEGRATORS = ("musl", "usl", "usf")
KERNELS = ("scatter_all", "scatter_mass_momentum", "accelerate", "strain_and_move",
           "accelerate_strain_and_move", "strain", "accelerate_and_move", "update_nodes",
           "divide_by_mass", "weights", "G2P", "stress", "failure")
NOT_MEASURED = "–"
FAILED = "failed"

PEAKS_TEXT = """\
Double precision. Multiply-adds in registers; the baseline has no fused one. The triad, a = b + 3 c
with each array four times the last-level cache, counts 24 bytes an element, two reads and a write.
A machine that reads what it is about to overwrite (write-allocate) moves a third more. Multiply-adds that do not scale with threads tell of a machine that was not left
alone."""
STEPS_TEXT = """\
Everything on: failure check, local damping, bulk viscosity, platens. M/s are million particle-steps
per second, `ratio` is to the scalar reference on one thread of this run, `scaling` the most threads
over one. The last three columns are those of the most threads: nanoseconds times cores, the traffic
of particle columns by the model in `bench/traffic.hpp`, and its share of the triad's. In cache that
share may exceed 1; out of it, updates in place cost no write-allocate, so the machine is saturated
at 1.33 where the triad pays for it. `random` has a Poisson number of particles in each bin, which
costs lanes that stay empty."""
CUBES_TEXT = """\
The same for a cube with a penny flaw at 45 degrees between two platens: eight particles a cell,
27 nodes a particle."""
KERNELS_TEXT = """\
Nanoseconds per particle on one thread, in cache, over all rows of the grid; `ratio` is to the
scalar twin. What an engine calls comes first: `scatter` is P2G, the others are passes, which
gather, update and scatter, or go over the nodes. Then the parts that passes are made of, alone:
weights, a gathered vector field with the places it is gathered at, the elastic stress, the test for
failure."""
SIZES_TEXT = """\
MUSL on the widest instructions. Nanoseconds of a particle-step by the clock on the wall; start-up,
from the case to the first step, in seconds per million particles."""


def show(number, scale, digits):
    if number is None:
        return NOT_MEASURED
    return FAILED if math.isnan(number) else f"{number * scale:,.{digits}f}"


def table(header, rows):
    lines = [header, ["---"] + ["---:"] * (len(header) - 1), *rows]
    return "\n".join("| " + " | ".join(line) + " |" for line in lines)


def on(threads):
    return f"{threads} thread" + ("" if threads == "1" else "s")


def machine(context, repetitions):
    caches = ", ".join(f"L{cache['level']} {cache['type']} {cache['size'] // 1024} KiB"
                       for cache in context.get("caches", []))
    load = context.get("load_avg") or [math.nan]
    rows = [("processor", context.get("cpu")),
            ("cores", f"{context.get('num_cpus')} at {context.get('mhz_per_cpu')} MHz nominal"),
            ("caches", caches),
            ("memory", context.get("memory")),
            ("instruction sets", context.get("isas")),
            ("compiler", context.get("compiler")),
            ("flags", f"`{str(context.get('flags')).strip()}`"),
            ("AVX2 units", f"`{context.get('avx2_flags')}`"),
            ("AVX-512 units", f"`{context.get('avx512_flags')}`"),
            ("version", f"{context.get('version')}, commit {context.get('commit', 'unknown')}"),
            ("date", str(context.get("date"))[:10]),
            ("load average before", f"{load[0]:.2f}"),
            ("repetitions", f"{repetitions}, of all benchmarks in random order; medians are shown")]
    return "\n".join(["| | |", "|---|---|", *(f"| {key} | {value} |" for key, value in rows)])


def peaks(results):
    threads = results.values("threads", "fma", "triad")
    rows = [peak_row(f"multiply-add, {isa}, GFLOP/s",
                     [results.number("flops", "fma", isa=isa, threads=n) for n in threads])
            for isa in ISAS if results.of("fma", isa=isa)]
    rows.append(peak_row("triad, GB/s", [triad(results, n) for n in threads]))
    return table(["", *map(on, threads), "scaling"], rows)


def peak_row(name, rates):
    return [name, *(show(rate, 1e-9, 1) for rate in rates), show(ratio(rates[-1], rates[0]), 1, 2)]


def triad(results, threads):
    return results.number("bytes_per_second", "triad", threads=threads)


def steps(results, kind):
    """A table for each size and arrangement of particles; `kind` is that of the benchmarks."""
    for cells in results.values("cells", kind):
        for particles in results.values("particles", kind):
            if results.of(kind, cells=cells, particles=particles):
                yield from step_table(results, kind, {"cells": cells, "particles": particles})


def step_table(results, kind, case):
    """Title, table, spread."""
    whole = [result for result in results.of(kind, **case) if not result.error]
    yield f"### {case['particles'].capitalize()}" + (
        ", {particles:,.0f} particles, {lanes_per_particle:.2f} lanes each".format(
            **whole[0].counters) if whole else "")
    threads = results.values("threads", kind)
    header = ["integrator, instructions", *(f"M/s, {on(n)}" for n in threads),
              *(f"ratio, {on(n)}" for n in threads), "scaling", "ns per core", "GB/s", "of triad"]
    yield table(header, [step_row(results, kind, threads,
                                  case | {"integrator": integrator, "isa": isa})
                         for integrator in INTEGRATORS for isa in ISAS
                         if results.of(kind, **case, integrator=integrator, isa=isa)])
    spreads = [result.spread for result in whole if result.spread is not None]
    if spreads:
        yield f"Coefficients of variation up to {max(spreads):.1%}."


def step_row(results, kind, threads, setting):
    def number(counter, **other):
        return results.number(counter, kind, **setting | other)

    speeds = {n: number("particle_steps_per_second", threads=n) for n in threads}
    reference = number("particle_steps_per_second", isa="reference", threads="1")
    most = [n for n in threads if speeds[n] is not None][-1]
    traffic = number("model_bytes_per_second", threads=most)
    return [f"{setting['integrator']}, {setting['isa']}",
            *(show(speed, 1e-6, 1) for speed in speeds.values()),
            *(show(ratio(speed, reference), 1, 2) for speed in speeds.values()),
            show(ratio(speeds[most], speeds.get("1")) if most != "1" else None, 1, 2),
            show(number("ns_per_particle_step_and_core", threads=most), 1, 1),
            show(traffic, 1e-9, 1),
            show(ratio(traffic, triad(results, most)), 1, 2)]


def kernels(results):
    measured = [isa for isa in ISAS if results.of("kernel", isa=isa)]
    rivals = [isa for isa in measured if isa != "reference"]
    names = dict.fromkeys([*KERNELS, *results.values("name", "kernel")])
    header = ["kernel", *(f"ns, {isa}" for isa in measured), *(f"ratio, {isa}" for isa in rivals)]
    return table(header, [kernel_row(results, name, measured, rivals) for name in names
                          if results.of("kernel", name=name)])


def kernel_row(results, name, measured, rivals):
    def number(counter, isa):
        return results.number(counter, "kernel", name=name, isa=isa)

    reference = number("particles_per_second", "reference")
    return [name, *(show(number("ns_per_particle", isa), 1, 2) for isa in measured),
            *(show(ratio(number("particles_per_second", isa), reference), 1, 2) for isa in rivals)]


def sizes(results):
    threads = results.values("threads", "size")
    header = ["particles", *(f"ns, {on(n)}" for n in threads),
              *(f"start-up, {on(n)}" for n in threads), "bytes per particle"]
    return table(header, [size_row(results, threads, cells)
                          for cells in results.values("cells", "size")])


def size_row(results, threads, cells):
    of_threads = [{"cells": cells, "threads": n} for n in threads]
    return [show(results.number("particles", "size", cells=cells), 1, 0),
            *(show(results.nanoseconds("size", **one), 1, 2) for one in of_threads),
            *(show(results.startup_per_million("size", **one), 1, 3) for one in of_threads),
            show(results.number("bytes_per_particle", "size", cells=cells), 1, 0)]
