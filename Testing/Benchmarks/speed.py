#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Measures everything that was aimed at in speed, beside CGAL, and prints tables and, last, one line
a target:   ok|short  name  value  target

Ratios are of numbers measured in one run, in turns. Runs of one thread are pinned to one processor
and timed by its CPU time. Warm: a later call in a process, the fastest of several. Cold: the first
call of a process, page faults included, the median of several processes. Nothing is asserted: time
depends on the machine and on what else it does. speed.sh builds the programs and calls this.

  speed.py --engine <build>/EngineBenchmark --counts <build>/EngineCounts
           [--constraints <build>/ConstraintBenchmark] [--filter <build>/FilterBenchmark]
           [--quick] [--scaling] [--check]
"""

import argparse
import json
import os
import subprocess
import sys
import time
from statistics import median

PAPER = ["Uniform", "Line", "Cross", "Circle", "Spiral", "Mixed"]
ROUNDED = ["Lattice", "DecimalLattice", "Utm", "UtmRaster"]
CROWDED = ["KuzminDisc", "NestedClusters", "CrowdedBox"]
DEGENERATE = [
    "OnCircle", "OnParabola", "Collinear", "NearlyCollinear", "RepeatedDraws", "Slivers",
]


class Plan:
    """Numbers of points and repetitions: what `--quick` makes smaller."""

    def __init__(self, quick):
        self.small, self.middle, self.large = (
            (10000, 30000, 100000) if quick else (100000, 1000000, 10000000)
        )
        self.few = [3000, 10000] if quick else [10000, 30000, 100000]  # for threads
        self.repeat = {self.small: 1 if quick else 5, self.middle: 1 if quick else 5, self.large: 3}
        self.cold = {self.middle: 1 if quick else 5, self.large: 1 if quick else 3}
        self.patience = 3 if quick else 60  # seconds for a call on degenerate input


def parse_arguments():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--engine", required=True, help="the EngineBenchmark to run")
    parser.add_argument("--counts", required=True, help="the EngineCounts to run")
    parser.add_argument("--constraints", help="the ConstraintBenchmark to run")
    parser.add_argument("--filter", help="the FilterBenchmark to run")
    parser.add_argument("--quick", action="store_true", help="few points: seconds, rough numbers")
    parser.add_argument("--scaling", action="store_true", help="count for 2 to 64 threads, no more")
    parser.add_argument("--check", action="store_true", help="fail if a target was not measured")
    return parser.parse_args()


# --- Running ---------------------------------------------------------------------------------------

BEGIN = time.monotonic()
PROCESSORS = sorted(os.sched_getaffinity(0))


def say(text):
    print(f"[{time.monotonic() - BEGIN:4.0f} s] {text}", file=sys.stderr, flush=True)


def output_of(command, pinned, seconds=None):
    """What the command prints; None if it takes longer. It ends everything if it fails."""
    processors = PROCESSORS[-1:] if pinned else PROCESSORS
    try:
        run = subprocess.run(
            command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True, timeout=seconds,
            preexec_fn=lambda: os.sched_setaffinity(0, processors),
        )
    except subprocess.TimeoutExpired:
        return None
    if run.returncode != 0:
        sys.exit(f"speed.py: {' '.join(command)} failed ({run.returncode}):\n{run.stdout}")
    return run.stdout


class Times:
    """ns per point by engine, distribution and number of points."""

    def __init__(self, program):
        self.program = program
        self.all = {}
        self.triangles = {}

    def measure(self, sizes, distributions, engines, repeat, cold=False, seconds=None):
        """All of these in one process, in random turns. False if it took too long."""
        pinned = not any(engine.startswith("threads") for engine in engines)
        text = output_of(
            [
                self.program, "--sizes=" + ",".join(map(str, sizes)),
                "--distributions=" + ",".join(distributions), "--engines=" + ",".join(engines),
                f"--repeat={repeat}", "--benchmark_format=json",
                "--benchmark_enable_random_interleaving=true",
            ] + (["--cold"] if cold else []),
            pinned, seconds,
        )
        if text is None:
            return False
        for benchmark in json.loads(text)["benchmarks"]:
            if benchmark["run_type"] == "iteration" and "nsPerPoint" in benchmark:
                engine, distribution, size = benchmark["name"].split("/")[:3]
                key = (engine, distribution, int(size))
                self.all.setdefault(key, []).append(benchmark["nsPerPoint"])
                self.compare_triangles(engine, (distribution, int(size)), benchmark["triangles"])
        return True

    def compare_triangles(self, engine, points, triangles):
        """All engines triangulate the same points: if they differ, one of them is wrong."""
        if engine == "float":
            return
        has_some = triangles > 0 or points[0] == "Collinear"
        if not has_some or self.triangles.setdefault(points, triangles) != triangles:
            sys.exit(f"speed.py: {engine}: {triangles:.0f} triangles of {points}, which is wrong")

    def best(self, engine, distribution, size):
        values = self.all.get((engine, distribution, size))
        return min(values) if values else None

    def middle(self, engine, distribution, size):
        values = self.all.get((engine, distribution, size))
        return median(values) if values else None


def counts_of(program, sizes, distributions, threads):
    text = output_of(
        [
            program, "--sizes=" + ",".join(map(str, sizes)),
            "--distributions=" + ",".join(distributions), "--threads=" + ",".join(map(str, threads)),
        ], pinned=False,
    )
    return [json.loads(line) for line in text.splitlines()]


# --- Targets ---------------------------------------------------------------------------------------


def ratio(a, b):
    """a / b, or None where one of them was not measured."""
    return a / b if a and b else None


def powered(size):
    """1e6 for 1000000."""
    return f"{size:.0e}".replace("e+0", "e").replace("e+", "e")


class Targets:
    """The lines to be printed last."""

    def __init__(self):
        self.lines = []
        self.missing = []

    def add(self, name, value, sense, limit, note="", at_least=False):
        """`at_least`: the true value is larger."""
        if value is None:
            shown, verdict = "-", "short"
            note = "not measured" + (f": {note}" if note else "")
            self.missing.append(name)
        else:
            good = {">=": value >= limit, "<=": value <= limit, "<": value < limit}
            verdict = "ok" if good[sense] else "short"
            shown = (">" if at_least else "") + f"{value:.3f}"
        self.lines.append(
            f"{verdict:5}  {name:44}  {shown:>8}  {sense} {limit:g}{'   ' + note if note else ''}"
        )

    def add_worst(self, name, values, sense, limit):
        """The worst of {of what: value}."""
        known = {of: value for of, value in values.items() if value is not None}
        if len(known) < len(values):
            missing = [of for of in values if of not in known]
            self.add(name, None, sense, limit, ", ".join(missing))
            return
        choose = min if sense == ">=" else max
        worst = choose(known, key=known.get)
        self.add(name, known[worst], sense, limit, worst)


def shown(value, form):
    return "-".rjust(int(form.split(".")[0])) if value is None else format(value, form + "f")


def print_table(title, times, distributions, size, choose):
    print(f"\n{title}, {powered(size)} points: CPU ns per point")
    print(f"{'':16}{'here':>8}{'CGAL':>9}{'CGAL/here':>11}{'here/uniform':>14}")
    uniform = choose(times, "ours", "Uniform", size)
    for name in distributions:
        ours, cgal = (choose(times, engine, name, size) for engine in ("ours", "cgal"))
        print(
            f"{name:16}{shown(ours, '8.1')}{shown(cgal, '9.1')}{shown(ratio(cgal, ours), '11.2')}"
            f"{shown(ratio(ours, uniform), '14.2')}"
        )
    sys.stdout.flush()


# --- What is measured ------------------------------------------------------------------------------


def measure_warm(program, plan, targets):
    everything = PAPER + ROUNDED + CROWDED
    middle = Times(program)
    say(f"warm, {powered(plan.middle)} points, beside CGAL")
    middle.measure([plan.middle], everything, ["ours", "cgal"], plan.repeat[plan.middle])
    print_table("Warm", middle, everything, plan.middle, Times.best)
    large = Times(program)
    say(f"warm, {powered(plan.large)} points, beside CGAL")
    large.measure([plan.large], PAPER, ["ours", "cgal"], plan.repeat[plan.large])
    print_table("Warm", large, PAPER, plan.large, Times.best)

    for times, size in ((middle, plan.middle), (large, plan.large)):
        against_cgal = {
            name: ratio(times.best("cgal", name, size), times.best("ours", name, size))
            for name in PAPER
        }
        targets.add_worst(f"warm, CGAL/here, {powered(size)}", against_cgal, ">=", 3.5)
    return middle, large


def measure_cold(program, plan, targets):
    for size in (plan.middle, plan.large):
        times = Times(program)
        say(f"cold, {powered(size)} points, processes of here and CGAL in turns")
        for _ in range(plan.cold[size]):
            for name in PAPER:
                for engine in ("ours", "cgal"):
                    times.measure([size], [name], [engine], 1, cold=True)
        print_table("Cold", times, PAPER, size, Times.middle)
        against_cgal = {
            name: ratio(times.middle("cgal", name, size), times.middle("ours", name, size))
            for name in PAPER
        }
        targets.add_worst(f"cold, CGAL/here, {powered(size)}", against_cgal, ">=", 2.8)


def measure_evenness(program, plan, targets, middle, large):
    say("growth, float32")
    times = Times(program)
    times.measure([plan.small, plan.large], PAPER, ["ours"], plan.repeat[plan.large])
    growth = {
        name: ratio(times.best("ours", name, plan.large), times.best("ours", name, plan.small))
        for name in PAPER
    }
    what = f"time per point, {powered(plan.large)}/{powered(plan.small)}"
    targets.add_worst(what, growth, "<=", 1.15)
    for measured, size in ((middle, plan.middle), (large, plan.large)):
        uniform = measured.best("ours", "Uniform", size)
        others = {name: ratio(measured.best("ours", name, size), uniform) for name in PAPER}
        targets.add_worst(f"worst distribution/uniform, {powered(size)}", others, "<=", 1.15)

    size = plan.middle
    uniform = middle.best("ours", "Uniform", size)
    for names, limit in ((ROUNDED, 1.6), (CROWDED, 1.5)):
        for name in names:
            value = ratio(middle.best("ours", name, size), uniform)
            targets.add(f"{name}/uniform, {powered(size)}", value, "<=", limit)
    floats = Times(program)
    floats.measure([size], ["Uniform"], ["ours", "float"], plan.repeat[size])
    value = ratio(floats.best("float", "Uniform", size), floats.best("ours", "Uniform", size))
    targets.add(f"float32/uniform, {powered(size)}", value, "<=", 1.6)


def measure_degenerate(program, plan, targets):
    """Each call in a process of its own: some of CGAL's do not come back."""
    small, large = plan.small, plan.middle
    times = Times(program)
    rows = []
    for name in DEGENERATE:
        say(f"{name}: growth, and beside CGAL, at most {plan.patience} s each")
        repeat = plan.repeat[small]
        times.measure([small, large], [name], ["ours"], repeat, seconds=20 * plan.patience)
        growth = ratio(times.best("ours", name, large), times.best("ours", name, small))
        fresh = Times(program)
        fresh.measure([large], [name], ["ours"], 1, cold=True, seconds=plan.patience)
        in_time = fresh.measure([large], [name], ["cgal"], 1, cold=True, seconds=plan.patience)
        ours, cgal = (fresh.best(engine, name, large) for engine in ("ours", "cgal"))
        if not in_time:
            cgal = 1e9 * plan.patience / large
        rows.append((name, ours, cgal, in_time))
        targets.add(f"{name}, growth {powered(large)}/{powered(small)}", growth, "<=", 1.3)
        targets.add(
            f"{name}, CGAL/here, {powered(large)}", ratio(cgal, ours), ">=", 1.5,
            at_least=not in_time,
        )
    print(f"\nDegenerate, {powered(large)} points, cold: CPU ns per point")
    for name, ours, cgal, in_time in rows:
        more = "" if in_time else f"   CGAL not done after {plan.patience} s"
        print(f"{name:16}{shown(ours, '10.1')}{shown(cgal, '11.1')}{more}")


def measure_threads(program, plan, targets):
    if len(PROCESSORS) < 2:
        say("one processor: two threads are not timed")
    print("\nTwo threads, uniform: ns per point on the wall")
    for size in plan.few + [plan.middle, plan.large]:
        times = Times(program)
        if len(PROCESSORS) >= 2:
            say(f"two threads, {powered(size)} points")
            repeat = 3 if size == plan.large else max(3, plan.repeat[plan.small])
            times.measure([size], ["Uniform"], ["threads1", "threads2"], repeat)
        one, two = (times.best(engine, "Uniform", size) for engine in ("threads1", "threads2"))
        print(f"{powered(size):8}{shown(one, '10.1')}{shown(two, '10.1')}")
        limit = 0.97 if size in plan.few else 1.6  # "never slower", less the noise
        targets.add(
            f"2 threads, speed-up, {powered(size)}", ratio(one, two), ">=", limit,
            "" if one else "one processor",
        )


def measure_counts(program, plan, targets):
    say("counts: NP, NR, memory, critical path")
    inputs = PAPER + ROUNDED + CROWDED + ["RepeatedDraws"]
    counted = counts_of(program, [plan.middle], inputs, [1, 2])
    counted += counts_of(program, [plan.large], ["Uniform"], [1, 2])
    alone = {c["distribution"]: c for c in counted if c["threads"] == 1 and c["points"] == plan.middle}
    print(f"\nCounted, {powered(plan.middle)} points")
    print(f"{'':16}{'NP':>7}{'NR':>7}{'bytes/point':>13}")
    for name, c in alone.items():
        print(f"{name:16}{c['np']:7.2f}{c['nr']:7.2f}{c['peakBytes'] / c['points']:13.1f}")
    targets.add_worst("NP", {name: alone[name]["np"] for name in PAPER}, "<", 3.7)
    targets.add_worst("NR", {name: alone[name]["nr"] for name in PAPER}, "<", 4.1)
    for size in (plan.middle, plan.large):
        memory = {
            f"{c['distribution']}, {c['threads']} threads": c["peakBytes"] / c["points"]
            for c in counted if c["points"] == size
        }
        targets.add_worst(f"memory, bytes per point, {powered(size)}", memory, "<=", 100)
        shared = {
            c["distribution"]: c["criticalPath"] / c["inserted"]
            for c in counted
            if c["points"] == size and c["threads"] == 2 and c["distribution"] in PAPER
        }
        targets.add_worst(f"2 threads, critical path/work, {powered(size)}", shared, "<=", 0.56)


def constraints_of(program, size, repeat):
    """Of each engine and shape: the measurement that took least time."""
    text = output_of(
        [
            program, f"--points={size}", f"--repeat={repeat}", "--benchmark_format=json",
            "--benchmark_enable_random_interleaving=true",
        ], pinned=True,
    )
    best = {}
    for benchmark in json.loads(text)["benchmarks"]:
        if benchmark["run_type"] == "iteration" and "constrain" in benchmark:
            key = tuple(benchmark["name"].split("/")[:2])
            if key not in best or benchmark["real_time"] < best[key]["real_time"]:
                best[key] = benchmark
    return best


def measure_constraints(program, plan, targets):
    """Constraints alone, and the whole beside the same points without any."""
    size = plan.middle
    best = {}
    if program:
        say(f"constraints, {powered(size)} points, beside CGAL")
        best = constraints_of(program, size, plan.repeat[size])
    shapes = sorted({shape for _, shape in best})
    print("\nConstraints, warm: CPU ms of all, and of the constraints alone")
    print(
        f"{'':16}{'points':>9}{'segments':>10}{'plain':>9}{'here':>9}{'alone':>9}{'CGAL':>9}"
        f"{'alone':>9}{'CGAL/here':>11}"
    )
    for shape in shapes:
        plain, ours, cgal = (best.get((e, shape)) for e in ("plain", "constrained", "cgal"))
        whole = [run and run["real_time"] for run in (plain, ours, cgal)]
        alone = [run and 1e3 * run["constrain"] for run in (ours, cgal)]
        print(
            f"{shape:16}{ours['points']:9.0f}{ours['segments']:10.0f}{shown(whole[0], '9.1')}"
            f"{shown(whole[1], '9.1')}{shown(alone[0], '9.2')}{shown(whole[2], '9.1')}"
            f"{shown(alone[1], '9.2')}{shown(ratio(whole[2], whole[1]), '11.2')}"
        )
    sys.stdout.flush()

    def of(shape, what, engine="constrained"):
        return best[engine, shape][what] if (engine, shape) in best else None

    note = "" if program else "no ConstraintBenchmark"
    for shape in ("EdgesThere", "LatticeRows"):
        value = ratio(of(shape, "constrain"), of(shape, "segments"))
        value = 1e6 * value if value else None
        targets.add(f"{shape}, us per edge that is there", value, "<=", 1.0, note)
    for shape in ("ShortSegments", "OtherEdges"):
        value = ratio(of(shape, "real_time"), of(shape, "real_time", "plain"))
        targets.add(f"{shape}/no constraints, {powered(size)}", value, "<=", 1.5, note)
    for shape in ("Across", "AcrossParabolas", "AcrossBulges", "AcrossCombs"):
        targets.add(f"{shape}, seconds for one segment", of(shape, "constrain"), "<=", 1.0, note)


def measure_filter(program, plan, targets):
    name = f"filter's Update()/engine, {powered(plan.middle)}"
    if not program:
        targets.add(name, None, "<=", 1.1, "no VTK found")
        return
    say("the filter's Update() beside the engine alone")
    text = output_of(
        [
            program, f"--points={plan.middle}", "--benchmark_format=json",
            f"--benchmark_repetitions={max(2, plan.repeat[plan.middle])}",
            "--benchmark_enable_random_interleaving=true",
        ], pinned=True,
    )
    found = {}
    for benchmark in json.loads(text)["benchmarks"]:
        if benchmark["run_type"] == "iteration":
            what = benchmark["name"].split("/")[0]
            found.setdefault(what, []).append(benchmark["nsPerPoint"])
    print(f"\nThe filter, {powered(plan.middle)} points, warm: CPU ns per point")
    print(f"engine alone {min(found['engine']):8.1f}\nUpdate()     {min(found['plain']):8.1f}")
    targets.add(name, ratio(min(found["plain"]), min(found["engine"])), "<=", 1.1)


def print_scaling(program, plan):
    """How the insertion would go on more threads than there may be here: by counts."""
    threads = [2, 4, 8, 16, 32, 64]
    say(f"scaling, {powered(plan.large)} points, 2 to 64 threads, counted")
    counted = counts_of(program, [plan.large], ["Uniform", "NestedClusters"], threads)
    print(f"\nInsertion of {powered(plan.large)} points on many threads, counted in insertions")
    print(
        f"{'':16}{'threads':>8}{'work/thread':>13}{'deferred':>10}{'critical path/work':>20}"
        f"{'implied speed-up':>18}"
    )
    for c in counted:
        print(
            f"{c['distribution']:16}{c['threads']:8}{c['attempts'] / c['threads']:13.0f}"
            f"{c['deferred'] / c['inserted']:10.2%}{c['criticalPath'] / c['inserted']:20.4f}"
            f"{c['inserted'] / c['criticalPath']:18.1f}"
        )
    sys.stdout.flush()


def main():
    arguments = parse_arguments()
    plan = Plan(arguments.quick)
    if arguments.scaling:
        print_scaling(arguments.counts, plan)
        return
    targets = Targets()
    middle, large = measure_warm(arguments.engine, plan, targets)
    measure_cold(arguments.engine, plan, targets)
    measure_evenness(arguments.engine, plan, targets, middle, large)
    measure_degenerate(arguments.engine, plan, targets)
    measure_threads(arguments.engine, plan, targets)
    measure_counts(arguments.counts, plan, targets)
    measure_constraints(arguments.constraints, plan, targets)
    measure_filter(arguments.filter, plan, targets)
    print_scaling(arguments.counts, plan)
    print()
    print("\n".join(targets.lines), flush=True)
    without = [name for name in targets.missing if arguments.filter or not name.startswith("filter")]
    if arguments.check and without:
        sys.exit("speed.py: not measured: " + ", ".join(without))


if __name__ == "__main__":
    main()
