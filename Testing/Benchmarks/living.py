#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Simplified, refined and edited surfaces beside other libraries, in turns, on one core: the table Living.md.

  living.py --program LivingBenchmark [--work FOLDER] [--data FOLDER] [--rounds N] [--quick] [--no-peers] [--only WORD]
            [--out FILE]

living.sh builds the program and calls this. Fetches the other libraries from PyPI into a venv in the folder; who is not
there is left out, as are rows of data that the folder --data (default: AHD_DATA) lacks. Under 15 minutes; --quick:
a minute, with few points, which shows only that all is measured. The exit code is 1 if a point is above its bound.
"""

import argparse
import datetime
import json
import math
import os
import platform
import random
import statistics
import subprocess
import sys
from array import array
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE / "peers"))
import install  # noqa: E402

PACKAGES = ("numpy", "vtk", "triangle", "pydelatin")
ANGLES = (20, 30, 33)
FEW, MOST_SECONDS = 20000, 300
HEAD = """# Simplified, refined and edited: beside others

Written by [`living.sh`](living.sh) on {date}: {machine}, load {load} before it{quick}. {versions}.
All on one core, CPU time, in turns in {rounds} rounds; ratios are medians, with the least and the most in brackets:
below 1 is less time, or fewer points, than the other. Counts do not depend on the machine.

| what | here | the other | ratio | target | |
|---|--:|--:|--:|--:|---|
"""
REFINED = """
Points added to each input, and the ratio of times from segments to triangles. *bad*: triangles left with a smaller
angle, which lie in an angle of the input. A, face, la, double_hex, double_hex2, square_circle_hole are examples of the
package `triangle`.

| input | angle | here | bad | Triangle | ratio | time | CGAL | ratio | time |
|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|
"""


class Bench:
    """Runs programs, and collects rows of the table."""

    def __init__(self, chosen):
        self.work, self.program, self.quick = Path(chosen.work), chosen.program, chosen.quick
        self.rounds, self.only, self.data = chosen.rounds, chosen.only, chosen.data
        self.work.mkdir(parents=True, exist_ok=True)
        self.python = None if chosen.no_peers else self.work / "venv" / "bin" / "python"
        self.missing = install.make_venv(self.work / "venv", PACKAGES) if self.python else {}
        self.lines, self.refined, self.failed = [], [], False

    def here(self, *words):
        return self._run([self.program, *words])

    def peer(self, *words):
        """None if it is missing, fails, or is not done in time."""
        return self._run([self.python, HERE / "peers" / "living_peers.py", *words], True) if self.python else None

    def _run(self, command, may_fail=False):
        try:
            done = subprocess.run([str(word) for word in command], capture_output=True, text=True, check=not may_fail,
                                  timeout=MOST_SECONDS)  # fmt: skip
        except subprocess.TimeoutExpired:
            if may_fail:
                return None
            raise
        return json.loads(done.stdout) if done.returncode == 0 else None

    def wants(self, name):
        return self.only in name

    def row(self, what, here, other, ratios, target, mean=statistics.median):
        """`ratios`: one a round, or a number; `target`: the most, or None."""
        ratios = ratios if isinstance(ratios, list) else [ratios]
        middle = mean(ratios)
        spread = " (%.2f to %.2f)" % (min(ratios), max(ratios)) if len(ratios) > 1 else ""
        said = "" if target is None else "ok" if middle <= target else "short"
        self.lines.append("| %s | %s | %s | %.3g%s | %s | %s |" % (
            what, here, other, middle, spread, "" if target is None else "≤ %g" % target, said))  # fmt: skip
        print(self.lines[-1], flush=True)


def seconds(times):
    return "%.3g s" % statistics.median(times)


def ratios_of(ours, theirs):
    return [a / b for a, b in zip(ours, theirs)]


# --- Data ----------------------------------------------------------------------------------------------------


def write_points(path, rows):
    with open(path, "wb") as file:
        array("d", [number for row in rows for number in row]).tofile(file)
    return path


def hills():
    """Sums of 40 Gaussians over the unit square."""
    drawn = random.Random(1)
    bumps = []
    for _ in range(40):
        width = 0.02 + 0.2 * drawn.random() ** 2
        bumps.append((drawn.random(), drawn.random(), 0.5 / width**2, (drawn.random() - 0.3) * 60 * width**0.5))
    return lambda x, y: sum(h * math.exp(-s * ((x - a) ** 2 + (y - b) ** 2)) for a, b, s, h in bumps)


def make_surfaces(bench):
    """{name: (file, points, bounds)}."""
    drawn, height, count = random.Random(2), hills(), FEW if bench.quick else 1000000
    places = [(drawn.random(), drawn.random()) for _ in range(count)]
    rows = [(1000 * x, 1000 * y, height(x, y)) for x, y in places]
    noisy = [(x, y, z + drawn.gauss(0, 0.05)) for x, y, z in rows]
    made = {"hills": (write_points(bench.work / "hills.bin", rows), count, (0.1, 0.02)),
            "noisy hills": (write_points(bench.work / "noisy.bin", noisy), count, (0.2,))}  # fmt: skip
    for name, bounds in (("lidar", (5, 0.25)), ("soundings", (200, 50, 10))):
        path = Path(bench.data or "/") / (name + ".csv")
        if path.exists():
            lines = path.read_text(encoding="ascii").splitlines()[1:]
            rows = {row[:2]: row for row in (tuple(map(float, line.split(","))) for line in reversed(lines))}
            made[name] = (write_points(bench.work / (name + ".bin"), rows.values()), len(rows), bounds)
    return made


def make_rasters(bench):
    side, height = 65 if bench.quick else 513, hills()
    rows = [(x, y, height(x / (side - 1), y / (side - 1))) for y in range(side) for x in range(side)]
    single = array("f", [row[2] for row in rows])  # pydelatin reads float32
    return write_points(bench.work / "raster.bin", [(x, y, z) for (x, y, _), z in zip(rows, single)])


def write_domain(path, points, segments, loops):
    lines = ["%d %d 0 %d" % (len(points), len(segments), len(loops))]
    lines += ["%r %r" % tuple(row) for row in [*points, *segments]]
    lines += ["%d %s" % (len(loop), " ".join(map(str, loop))) for loop in loops]
    path.write_text("\n".join(lines) + "\n", encoding="ascii")


def make_domains(bench):
    """Names of .domain files: segments, and the loops that bound what is meshed. (LivingBenchmark.cxx)"""
    box = [(0.0, 0.0), (10.0, 0.0), (10.0, 10.0), (0.0, 10.0)]
    slit = [(1.0, 5.0), (9.0, 5.0), (1.0, 5.001), (9.0, 5.0005), (0.5, 5.0005)]
    around = [(k, (k + 1) % 4) for k in range(4)]
    write_domain(bench.work / "slit.domain", box + slit, around + [(4, 5), (6, 7), (8, 4), (8, 6)], [range(4)])
    ends = [(length * math.cos(k * math.pi / 180), length * math.sin(k * math.pi / 180))
            for k, length in ((k, 1 + 0.1 * (k % 3)) for k in range(31))]  # fmt: skip
    frame = [(-1.0, -1.0), (2.0, -1.0), (2.0, 2.0), (-1.0, 2.0)]
    write_domain(bench.work / "fan.domain", [*frame, (0.0, 0.0), *ends], around + [(4, 5 + k) for k in range(31)],
                 [range(4)])  # fmt: skip
    names = ["slit", "fan"]
    data = Path(bench.data or "/")
    if (data / "coastline.csv").exists():
        rows = (data / "coastline.csv").read_text(encoding="ascii").splitlines()[1:]
        points = list(dict.fromkeys(tuple(map(float, row.split(","))) for row in rows))
        ring = range(len(points))
        write_domain(bench.work / "Australia.domain", points, [(k, (k + 1) % len(points)) for k in ring], [ring])
        names.append("Australia")
    if (data / "sweden.txt").exists():
        words = (data / "sweden.txt").read_text(encoding="ascii").split()
        points, numbers = int(words[0]), words[2:]
        places = [(float(a), float(b)) for a, b in zip(numbers[0 : 2 * points : 2], numbers[1 : 2 * points : 2])]
        numbers = list(map(int, numbers[2 * points :]))
        write_domain(bench.work / "Sweden.domain", places, list(zip(numbers[::2], numbers[1::2])), [])
        names += ["Sweden"] if bench.peer("bound", bench.work / "Sweden.domain") else []
    return names + (bench.peer("examples", bench.work) or {"made": []})["made"]


# --- Rows ----------------------------------------------------------------------------------------------------


def simplify_rows(bench):
    surfaces, above = make_surfaces(bench), 0
    for name, (path, count, bounds) in surfaces.items():
        for bound in bounds:
            made = bench.here("simplify", path, bound, bench.rounds, 1)
            greedy = bench.here("greedy", path, bound)["kept"]
            what = "%s, %d points, within %g" % (name, count, bound)
            bench.row(what + ": over a plain triangulation, time", seconds(made["once"]), seconds(made["plain"]),
                      ratios_of(made["once"], made["plain"]), 3 if name == "hills" and bound == 0.1 else 8)  # fmt: skip
            bench.row(what + ": over exact greedy, points", made["kept"], greedy, made["kept"] / greedy, 1.03)
            bench.row("the same with the second pass", made["kept_twice"], greedy, made["kept_twice"] / greedy, 0.96)
            above += made["above"]
    bench.row("points above the bound, in all of these", above, "", above, 0)
    bench.failed = above > 0
    quadric_rows(bench, *surfaces["hills"][:2])
    memory = bench.here("memory", FEW if bench.quick else 10000000)
    bench.row("bytes a point, 10^7 points", "%.0f" % memory["bytes"], "", memory["bytes"], 150)


def quadric_rows(bench, path, count):
    kept = bench.work / "triangles.bin"
    whole = bench.here("triangles", path, kept)["triangles"]
    ours, theirs, last = [], [], None
    for _ in range(min(bench.rounds, 3)):
        made = bench.here("simplify", path, 0.1, 1, 1)
        last = bench.peer("quadric", path, kept, 2 * made["kept"])
        if last is None:
            return
        ours += made["once"]
        theirs.append(last["seconds"])
    bench.row("hills, %d triangles to %d: vtkQuadricDecimation (largest error %.2g, here 0.1), time" % (
        whole, last["triangles"], last["error"]), seconds(ours), seconds(theirs), ratios_of(ours, theirs), 0.02)


def raster_rows(bench):
    path = make_rasters(bench)
    for bound in (0.1, 0.02):
        ours, theirs, made, other = [], [], None, None
        for _ in range(bench.rounds):
            made = bench.here("simplify", path, bound, 1, 1)
            other = bench.peer("pydelatin", path, bound, 0)
            if other is None:
                return
            ours += made["once"]
            theirs.append(other["seconds"])
        what = "raster of %d points within %g: pydelatin, " % (made["points"], bound)
        bench.row(what + "points", made["kept"], other["vertices"], made["kept"] / other["vertices"], 1.02)
        bench.row(what + "with the second pass", made["kept_twice"], other["vertices"],
                  made["kept_twice"] / other["vertices"], None)  # fmt: skip
        bench.row(what + "time", seconds(ours), seconds(theirs), ratios_of(ours, theirs), None)


def thread_rows(bench):
    for name in ("hills", "noisy"):
        path = bench.work / (name + ".bin")
        if not path.exists():
            continue
        one, two = [], []
        for _ in range(bench.rounds):
            one += bench.here("simplify", path, 0.1 if name == "hills" else 0.2, 1, 1)["once"]
            two += bench.here("simplify", path, 0.1 if name == "hills" else 0.2, 1, 2)["once"]
        bench.row("%s: two threads over one, time on the wall" % name, seconds(two), seconds(one), ratios_of(two, one),
                  0.59)  # fmt: skip


def refine_rows(bench):
    counts, times, of_cgal, cgal_times = [], [], [], []
    short = 0.02 if bench.quick else 0.2
    for name in make_domains(bench):
        for angle in ANGLES[:1] if bench.quick else ANGLES:
            path = bench.work / (name + ".domain")
            made, other, ratios = None, None, []
            for _ in range(bench.rounds):
                made = bench.here("refine", path, angle, short)
                other = bench.peer("triangle", path, angle, short)
                if other:
                    ratios.append(made["seconds"] / other["seconds"])
            cells = [name, angle, made["steiner"], made["bad"], "", "", "", "", "", ""]
            if other:
                ratio = made["steiner"] / other["steiner"] if other["steiner"] else 1.0
                counts.append(ratio)
                times.append(statistics.median(ratios))
                cells[4:7] = [other["steiner"], "%.2f" % ratio, "%.2f" % times[-1]]
            if name in ("Australia", "Sweden") and angle <= 30:
                cgal = bench.here("cgalmesh", path, angle)
                if "missing" not in cgal:
                    of_cgal.append(made["steiner"] / cgal["steiner"])
                    cgal_times.append(made["seconds"] / cgal["seconds"])
                    cells[7:] = [cgal["steiner"], "%.2f" % of_cgal[-1], "%.2f" % cgal_times[-1]]
            bench.refined.append("| " + " | ".join(map(str, cells)) + " |")
            print(bench.refined[-1], flush=True)
    for what, ratios, target in (("Triangle: points added", counts, 1.02), ("Triangle: time", times, 1.2),
                                 ("CGAL's mesher on coasts: points added", of_cgal, 0.5),
                                 ("CGAL's mesher on coasts: time", cgal_times, 0.3)):  # fmt: skip
        if ratios:
            what = "refine, geometric mean of %d runs: %s" % (len(ratios), what)
            bench.row(what, "", "", ratios, target, statistics.geometric_mean)


def edit_rows(bench):
    count, changes = (FEW, 2000) if bench.quick else (1000000, 100000)
    made = bench.here("edit", count, changes, bench.rounds)
    for name, target in (("insert", 1.0), ("remove", 0.7), ("move", 0.7)):
        many = count if name == "insert" else changes
        if made[name + "_cgal"][0] > 0:
            bench.row("edit %d points: CGAL, %s %d" % (count, name, many),
                      "%.0f ns" % (1e9 * statistics.median(made[name]) / many),
                      "%.0f ns" % (1e9 * statistics.median(made[name + "_cgal"]) / many),
                      ratios_of(made[name], made[name + "_cgal"]), target)  # fmt: skip


def processor():
    for line in Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines():
        if line.startswith("model name"):
            return line.split(":")[1].strip()
    return platform.machine()


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", required=True)
    parser.add_argument("--work", default="build/living")
    parser.add_argument("--data", default=os.environ.get("AHD_DATA"))
    parser.add_argument("--rounds", type=int, default=0)
    parser.add_argument("--quick", action="store_true")
    parser.add_argument("--no-peers", action="store_true", help="nothing is fetched")
    parser.add_argument("--only", default="", help="rows of simplify, raster, threads, refine or edit")
    parser.add_argument("--out")
    chosen = parser.parse_args()
    chosen.rounds = chosen.rounds or (1 if chosen.quick else 5)
    load = "%.1f" % os.getloadavg()[0]
    bench = Bench(chosen)
    for name, rows in (("simplify", simplify_rows), ("threads", thread_rows), ("raster", raster_rows),
                       ("refine", refine_rows), ("edit", edit_rows)):  # fmt: skip
        # one core, but for the row about threads
        processors = sorted(os.sched_getaffinity(0))
        os.sched_setaffinity(0, processors if name == "threads" else processors[-1:])
        if bench.wants(name):
            rows(bench)
        os.sched_setaffinity(0, processors)
    for package, why in bench.missing.items():
        print("%s is missing: %s" % (package, why))
    said = bench.peer("versions") or {}
    if chosen.out:
        head = HEAD.format(
            date=datetime.date.today(), machine="%s, %d processors" % (processor(), os.cpu_count() or 1), load=load,
            rounds=chosen.rounds, quick=", **with few points: `--quick`**" if chosen.quick else "",
            versions=", ".join("%s %s" % one for one in sorted(said.items())) or "Without peers")  # fmt: skip
        text = head + "\n".join(bench.lines) + "\n"
        text += REFINED + "\n".join(bench.refined) + "\n" if bench.refined else ""
        Path(chosen.out).write_text(text, encoding="utf-8")
    return int(bench.failed)


if __name__ == "__main__":
    sys.exit(main())
