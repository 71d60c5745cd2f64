# SPDX-License-Identifier: BSD-3-Clause
"""Targets of speed: every row that speed.py measures.

A row has samples of two sides or more, measured in one run, in turns; the target is a ratio of two medians.
Warm: a later call in a process. Cold: the first call of a process, page faults included."""

import os
import subprocess
from dataclasses import dataclass, field
from statistics import median
from typing import Callable

PAPER = ["Uniform", "Line", "Cross", "Circle", "Spiral", "Mixed"]
CROWDED = ["KuzminDisc", "NestedClusters", "CrowdedBox"]
FEATURES = {
    "Voronoi": 3.0, "Alpha": 1.5, "Tolerance": 1.5, "RegionIds": 1.25, "Neighbors": 1.25,
    "MaximumEdgeLength": 1.25, "BestFittingPlane": 1.25, "ConstraintEdges": 1.25, "Curve": 1.25, "Boxes": 1.25,
}
BEFORE = "3cb74db"  # the commit that the row of the decimal lattice is measured against


class Plan:
    """Numbers of points and repetitions: what `--quick` makes smaller."""

    def __init__(self, quick):
        self.quick = quick
        self.small, self.middle, self.large, self.huge = (
            (10000, 30000, 100000, 200000) if quick else (100000, 1000000, 10000000, 100000000)
        )
        self.few = [10000] if quick else [10000, 30000, 100000]  # for threads
        self.repeat = {self.small: 1 if quick else 7, self.middle: 1 if quick else 5, self.large: 1 if quick else 5}
        self.patience = 3 if quick else 60  # seconds for a call of CGAL on degenerate input


@dataclass
class Row:
    """One thing that is measured. `over` names the two sides whose medians are divided; with one name it is
    that side's median itself."""

    section: str
    name: str
    measure: Callable  # gives {side: [samples]}
    over: tuple
    sense: str
    target: float
    unit: str = "ns"
    samples: dict = field(default_factory=dict)
    first: dict = field(default_factory=dict)  # of a row that was short, and so measured once more
    note: str = ""

    def value(self, samples=None):
        samples = self.samples if samples is None else samples
        if not all(samples.get(side) for side in self.over):
            return None
        medians = [median(samples[side]) for side in self.over]
        return medians[0] / medians[1] if len(medians) > 1 else medians[0]

    def good(self, samples=None):
        value = self.value(samples)
        if value is None:
            return False
        return value >= self.target if self.sense == ">=" else value <= self.target

    def run(self, once=False):
        """Measures; a row that misses its target is measured once more, and the better of the two stands."""
        self.samples = self.measure()
        if once or self.value() is None or self.good():
            return
        again = self.measure()
        better = max if self.sense == ">=" else min
        pair = [self.samples, again]
        best = better(pair, key=self.value)
        self.first = pair[1] if best is self.samples else self.samples
        self.samples = best

    def line(self):
        value = self.value()
        note = self.note or ("not measured" if value is None else "")
        shown = "-" if value is None else f"{value:.3f}"
        return (
            f"{'ok' if self.good() else 'short':5}  {self.section + ': ' + self.name:62}  {shown:>8}  "
            f"{self.sense} {self.target:g}{'   ' + note if note else ''}"
        )


def powered(size):
    """1e6 for 1000000."""
    return f"{size:.0e}".replace("e+0", "e").replace("e+", "e")


# --- Beside CGAL ------------------------------------------------------------------------------------


def warm_rows(programs, plan):
    for size in (plan.middle, plan.large):
        for name in PAPER:
            def measure(size=size, name=name):
                found = programs.engine(size, [("ours", name), ("cgal", name)], plan.repeat[size])
                return {"here": found["ours", name, size], "CGAL": found["cgal", name, size]}

            yield Row(f"Warm, {powered(size)} points", name, measure, ("CGAL", "here"), ">=", 4.0)


def cold_rows(programs, plan):
    for size in (plan.middle, plan.large):
        for name in PAPER:
            def measure(size=size, name=name):
                sides = {"here": [], "CGAL": []}
                for _ in range(plan.repeat[plan.middle] if size == plan.middle else min(3, plan.repeat[size])):
                    for side, engine in (("here", "ours"), ("CGAL", "cgal")):
                        sides[side] += programs.engine(size, [(engine, name)], 1, cold=True)[engine, name, size]
                return sides

            yield Row(f"Cold, {powered(size)} points", name, measure, ("CGAL", "here"), ">=", 3.0)


def degenerate_rows(programs, plan):
    size = plan.middle
    targets = {"OnCircle": 2.5, "OnParabola": 3.5, "NearlyCollinear": 3.5, "RepeatedDraws": 1.5, "Slivers": 1.5}
    for name, target in targets.items():
        row = Row(f"Degenerate, {powered(size)} points", name, None, ("CGAL", "here"), ">=", target)

        def measure(name=name, row=row):
            runs = [("ours", name), ("cgal", name)]
            found = programs.engine(size, runs, plan.repeat[size], seconds=(2 * plan.repeat[size] + 2) * plan.patience)
            if found:
                return {"here": found["ours", name, size], "CGAL": found["cgal", name, size]}
            row.note = f"CGAL took longer than {plan.patience} s a call"
            found = programs.engine(size, runs[:1], plan.repeat[size])
            return {"here": found["ours", name, size], "CGAL": [1e9 * plan.patience / size]}

        row.measure = measure
        yield row


# --- Beside uniform points ----------------------------------------------------------------------------


def uniform_rows(programs, plan):
    """(engine, distribution): at most so many times the time of uniform points."""
    size = plan.middle
    limits = {
        ("ours", "Lattice"): 1.15, ("shuffled", "Lattice"): 1.15, ("ours", "UtmRaster"): 1.15, ("ours", "Utm"): 1.15,
        ("ours", "OnParabola"): 1.4, ("ours", "NearlyCollinear"): 1.4,
        ("times1e-150", "Uniform"): 1.2, ("times1e-30", "Uniform"): 1.2, ("times1e30", "Uniform"): 1.2,
        ("times1e100", "Uniform"): 1.2, ("float", "Uniform"): 1.2,
        **{("ours", name): 1.5 for name in CROWDED},
    }
    for run, limit in limits.items():
        def measure(run=run):
            found = programs.engine(size, [run, ("ours", "Uniform")], plan.repeat[size])
            return {"here": found[(*run, size)], "uniform": found["ours", "Uniform", size]}

        name = run[1] if run[0] == "ours" else f"{run[1]}, {run[0]}"
        yield Row(f"Beside uniform points, {powered(size)}", name, measure, ("here", "uniform"), "<=", limit)


def growth_rows(programs, plan):
    small, large = plan.small, plan.large
    for cold in (False, True):
        for name in ["Uniform"] if cold else PAPER:
            def measure(cold=cold, name=name):
                sides = {powered(large): [], powered(small): []}
                for _ in range(3 if not plan.quick else 1):
                    for size, repeat in ((small, plan.repeat[small]), (large, 1)):
                        for _ in range(repeat if cold else 1):
                            found = programs.engine(size, [("ours", name)], 1 if cold else repeat, cold)
                            sides[powered(size)] += found["ours", name, size]
                return sides

            title = f"{'Cold' if cold else 'Warm'}, {powered(large)} against {powered(small)} points"
            yield Row(title, name, measure, (powered(large), powered(small)), "<=", 1.15)


def before_rows(programs, plan):
    if not programs.has("before"):
        return
    size = plan.middle
    for name, target in (("DecimalLattice", 0.78), ("Uniform", 0.85)):
        def measure(name=name):
            sides = {"here": [], BEFORE: []}
            for _ in range(plan.repeat[size]):
                for side in sides:
                    found = programs.engine(size, [("ours", name)], 2, before=side == BEFORE)
                    sides[side] += found["ours", name, size]
            return sides

        yield Row(f"Beside commit {BEFORE}, {powered(size)} points", name, measure, ("here", BEFORE), "<=", target)


def interface_rows(programs, plan):
    for size in (plan.small, plan.middle):
        for cold in (False, True):
            def measure(size=size, cold=cold):
                sides, repeat = {"C interface": "c", "engine": "ours"}, plan.repeat[size]
                samples = {side: [] for side in sides}
                for _ in range(repeat if cold else 1):
                    calls = [[side] for side in sides] if cold else [list(sides)]
                    for call in calls:
                        runs = [(sides[side], "Uniform") for side in call]
                        found = programs.engine(size, runs, 1 if cold else repeat, cold)
                        for side in call:
                            samples[side] += found[sides[side], "Uniform", size]
                return samples

            name = f"{powered(size)}, {'cold' if cold else 'warm'}"
            yield Row("The C interface beside the engine", name, measure, ("C interface", "engine"), "<=", 1.05)


# --- Threads ------------------------------------------------------------------------------------------


def thread_rows(programs, plan):
    if len(os.sched_getaffinity(0)) < 2:
        return
    for size in plan.few + [plan.middle, plan.large]:
        def measure(size=size):
            repeat = plan.repeat.get(size, plan.repeat[plan.small])
            found = programs.engine(size, [("threads1", "Uniform"), ("threads2", "Uniform")], repeat)
            return {"one": found["threads1", "Uniform", size], "two": found["threads2", "Uniform", size]}

        target = 0.97 if size in plan.few else 1.85  # few points: "never slower", less the noise
        yield Row("Two threads, uniform points, time on the wall", powered(size), measure, ("one", "two"), ">=", target)


# --- The filter -----------------------------------------------------------------------------------------


def feature_rows(programs, plan):
    if not programs.has("filter"):
        return
    size = plan.middle
    for name, limit in FEATURES.items():
        def measure(name=name):
            found = programs.features(size, ["plain", name], repeat=plan.repeat[size])
            return {"here": [cpu for cpu, _ in found[name]], "plain": [cpu for cpu, _ in found["plain"]]}

        title = f"Update() with a feature, {powered(size)} points"
        yield Row(title, name, measure, ("here", "plain"), "<=", limit)
    if len(os.sched_getaffinity(0)) < 2:
        return
    for name in ["plain", *FEATURES, "Breaklines", "CrossingLines"]:
        def measure_threads(name=name):
            sides = {"one": [], "two": []}
            for _ in range(plan.repeat[size]):
                for threads, side in enumerate(sides, 1):
                    sides[side] += [wall for _, wall in programs.features(size, [name], threads)[name]]
            return sides

        title = f"Update() with two threads, {powered(size)} points, time on the wall"
        yield Row(title, name, measure_threads, ("one", "two"), ">=", 1.85 if name == "plain" else 1.7)


def filter_rows(programs, plan):
    if not programs.has("filter"):
        return
    size = plan.middle

    def measure():
        found = programs.features(size, ["engine", "plain"], repeat=plan.repeat[size])
        return {"Update()": [cpu for cpu, _ in found["plain"]], "engine": [cpu for cpu, _ in found["engine"]]}

    yield Row("The filter", f"beside the engine, {powered(size)} points", measure, ("Update()", "engine"), "<=", 1.1)

    def measure_growth():
        sides = {powered(plan.huge): [], powered(plan.large): []}
        for n in (plan.large, plan.huge, plan.large):
            sides[powered(n)] += [cpu for cpu, _ in programs.features(n, ["plain"], threads=2, cold=True)["plain"]]
        return sides

    memory = os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_AVPHYS_PAGES")
    if plan.quick or memory > 200 * plan.huge:
        name = f"{powered(plan.huge)} against {powered(plan.large)} points, CPU time, cold, two threads"
        yield Row("The filter", name, measure_growth, (powered(plan.huge), powered(plan.large)), "<=", 1.3)


# --- Constraints ------------------------------------------------------------------------------------------


def constraint_rows(programs, plan):
    """Shapes of ConstraintBenchmark: whole runs beside CGAL's or ours without constraints, in ms; or the
    constraints alone."""
    if not programs.has("constraints"):
        return
    size, repeat = plan.middle, plan.repeat[plan.middle]

    def whole(engine, found):
        return [b["real_time"] for b in found.get(engine, [])]

    for shape in ("Breaklines", "ShortSegments", "Ring"):
        def beside_cgal(shape=shape):
            found = programs.shape(size, shape, repeat)
            return {"here": whole("constrained", found), "CGAL": whole("cgal", found)}

        title = f"Constraints, {powered(size)} points"
        yield Row(title, f"{shape}, beside CGAL", beside_cgal, ("CGAL", "here"), ">=", 4.0, "ms")
    for shape in ("ShortSegments", "OtherEdges"):
        def beside_plain(shape=shape):
            found = programs.shape(size, shape, repeat)
            return {"here": whole("constrained", found), "plain": whole("plain", found)}

        yield Row(title, f"{shape}, beside none", beside_plain, ("here", "plain"), "<=", 1.5, "ms")
    for shape in ("EdgesThere", "LatticeRows"):
        def alone(shape=shape):
            found = programs.shape(size, shape, repeat).get("constrained", [])
            return {"here": [1e6 * b["constrain"] / b["segments"] for b in found]}

        yield Row(title, f"{shape}, microseconds an edge that is there", alone, ("here",), "<=", 1.0, "us")
    for shape in ("Across", "AcrossParabolas", "AcrossBulges", "AcrossCombs"):
        def one(shape=shape):
            found = programs.shape(size, shape, repeat).get("constrained", [])
            return {"here": [1e3 * b["constrain"] for b in found]}

        yield Row(title, f"{shape}, ms for one segment", one, ("here",), "<=", 1000.0, "ms")


# --- Counts -----------------------------------------------------------------------------------------------


def count_rows(programs, plan):
    """Not timed: one sample each. NP and NR: triangles tested and removed per point."""
    title = "Counted"

    def counts(size, names, threads, what):
        found = programs.count([size], names, [threads])
        return {"here": [max(what(c) for c in found)]}

    for what, limit in (("np", 3.7), ("nr", 4.2)):
        def most(what=what):
            return counts(plan.middle, PAPER, 1, lambda c: c[what])

        yield Row(title, f"{what.upper()}, most of the six, {powered(plan.middle)}", most, ("here",), "<=", limit, "")
    for threads, limit in ((1, 85), (2, 90)):
        def memory(threads=threads):
            return counts(plan.middle, PAPER, threads, lambda c: c["peakBytes"] / c["points"])

        name = f"memory, most of the six, bytes a point, {threads} thread{'s' * (threads > 1)}"
        yield Row(title, name, memory, ("here",), "<=", limit, "bytes")
    for size in (plan.middle, plan.large):
        def chain(size=size):
            return counts(size, ["Uniform"], 2, lambda c: c["criticalPath"] / c["inserted"])

        name = f"two threads, longest chain of insertions, {powered(size)}"
        yield Row(title, name, chain, ("here",), "<=", 0.56, "of all")


SECTIONS = [
    warm_rows, cold_rows, degenerate_rows, uniform_rows, growth_rows, before_rows, interface_rows, thread_rows,
    filter_rows, feature_rows, constraint_rows, count_rows,
]


def machine(root):
    """The machine."""
    def first(path, begin):
        with open(path, encoding="utf-8") as file:
            return next((line.split(":", 1)[1].strip() for line in file if line.startswith(begin)), "unknown")

    def told(*command):
        return subprocess.run(command, capture_output=True, text=True, cwd=root, check=False).stdout.strip()

    return {
        "processor": first("/proc/cpuinfo", "model name"),
        "processors": len(os.sched_getaffinity(0)),
        "compiler": told("c++", "--version").splitlines()[0] if told("c++", "--version") else "unknown",
        "commit": told("git", "describe", "--always", "--dirty"),
    }
