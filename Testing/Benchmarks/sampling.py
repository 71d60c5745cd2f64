#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Values between the points beside what others give: scipy's Linear-, NearestND- and CloughTocher2DInterpolator,
matplotlib's LinearTriInterpolator, GMT's triangulate -G, CGAL's natural_neighbor_coordinates_2.

Both sides of a row are measured in turns, each by the CPU time of one thread, and their values are compared. Who is
not there is left out, and the table says so.

  PYTHONPATH=<folder of adaptivehilbertdelaunay> sampling.py [--points N] [--rounds N] [--gmt PROGRAM]
      [--benchmark <build>/bin/SampleBenchmark] [--out Sampling.md]
"""

import argparse
import datetime
import importlib
import os
import re
import resource
import statistics
import subprocess
import tempfile
import time
from pathlib import Path

import numpy as np
from adaptivehilbertdelaunay import NearestInterpolator, delaunay
from adaptivehilbertdelaunay.scipy import CloughTocher2DInterpolator, Delaunay, estimate_gradients_2d_global

HEAD = """# Values between the points, beside others

Written by [`sampling.py`](sampling.py) on {date}: {points:,} uniform points, {rounds} rounds in turns, one thread,
CPU time, on a machine with a load of {load:.1f} on {cores} cores. Millions of places a second: the median, in brackets
the least and the most. *Evaluation*: triangulations, trees and finders are ready. *Whole*: from points in memory to the
raster; of GMT the whole program, its files in memory.

A call has many places, sorted along a curve and found by a walk from the last. Each call begins at the same triangle,
so that a single place takes the engine 1 µs among 1,000 points and about 200 among 10^6, cold; from Python 14 µs more:
[small calls](SmallCalls.md).

| what | here | the other | times as fast | largest difference |
|---|--:|--:|--:|--:|
"""


class Table:
    def __init__(self, rounds):
        self.rounds, self.rows, self.missing = rounds, [], []

    def add(self, name, ours, theirs, difference):
        """Rates of the rounds, and the differences of values."""
        both = ["%.3g (%.3g to %.3g)" % (statistics.median(rates), min(rates), max(rates)) for rates in (ours, theirs)]
        ratio = statistics.median(ours) / statistics.median(theirs)
        self.rows.append("| %s | %s | %s | %.3g | %s |" % (name, *both, ratio, difference))
        print(self.rows[-1], flush=True)

    def in_turns(self, name, ours, theirs):
        """`ours`, `theirs`: (how many places, a function that gives the values at them); compared at as many places
        as both have, if these are scattered or there are as many."""
        rates, values = ([], []), [None, None]
        for _ in range(self.rounds):
            for side, (count, work) in enumerate((ours, theirs)):
                begin = time.process_time()
                values[side] = work()
                rates[side].append(1e-6 * count / (time.process_time() - begin))
        size = values[1].size
        far = np.abs(values[0].ravel()[:size] - np.ma.filled(values[1], np.nan).ravel())
        areSame = values[0].ndim == 1 or values[0].size == size
        self.add(name, *rates, "%.1g" % np.nanmax(far) if areSame else "other places")


def peer(name, table):
    try:
        return importlib.import_module(name)
    except ImportError:
        table.missing.append(name)
        return None


class Case:
    """Points with values, triangulated; a fine raster, a coarse one of a cell for each point, scattered places."""

    def __init__(self, count):
        random = np.random.default_rng(1)
        self.points = random.random((count, 2))
        self.values = np.sin(3 * self.points[:, 0]) * np.cos(2 * self.points[:, 1])
        self.made = delaunay(self.points, threads=1)
        side = int(count**0.5)
        self.fine = self.made.raster(shape=(int(side * 10**0.5),) * 2)
        self.coarse = self.made.raster(shape=(side, side))
        self.grid = np.meshgrid(self.coarse.x, self.coarse.y)
        self.scattered = random.random((count, 2))
        for places in (self.coarse, self.scattered):
            self.ours(places)  # tables are made

    def ours(self, places, method="linear"):
        return self.made.interpolate(self.values, places, method)


def beside_scipy(case, table):
    found = peer("scipy.interpolate", table)
    if found is None:
        return
    count, size = len(case.scattered), case.coarse.shape[0] * case.coarse.shape[1]
    linear = found.LinearNDInterpolator(case.points, case.values)
    fine = case.fine.shape[0] * case.fine.shape[1]
    linear(case.scattered[:1])  # makes tables of its own
    theirs = (size, lambda: linear(*case.grid))
    table.in_turns("linear, raster of ten times as many cells, evaluation: scipy on a tenth of them",
                   (fine, lambda: case.ours(case.fine)), theirs)  # fmt: skip
    table.in_turns("linear, raster, evaluation: scipy", (size, lambda: case.ours(case.coarse)), theirs)
    few = case.scattered[: count // 100]  # its walks are long
    table.in_turns("linear, scattered, evaluation: scipy at a hundredth of them",
                   (count, lambda: case.ours(case.scattered)), (len(few), lambda: linear(few)))  # fmt: skip
    nearest, near = NearestInterpolator(case.made, case.values), found.NearestNDInterpolator(case.points, case.values)
    nearest(case.scattered[:1])
    table.in_turns("nearest, scattered, evaluation: scipy", (count, lambda: nearest(case.scattered)),
                   (count, lambda: near(case.scattered)))  # fmt: skip
    tri, theirs = Delaunay(case.points), found.CloughTocher2DInterpolator(case.points, case.values)
    table.in_turns("cubic, gradients at the points: scipy",
                   (len(case.points), lambda: estimate_gradients_2d_global(tri, case.values)),
                   (len(case.points), lambda: found.CloughTocher2DInterpolator(theirs.tri, case.values).grad)
                   )  # fmt: skip
    ours = CloughTocher2DInterpolator(tri, case.values)
    ours(*case.grid), theirs(case.scattered[:1])
    table.in_turns("cubic, raster, evaluation: scipy", (size, lambda: ours(*case.grid)),
                   (size, lambda: theirs(*case.grid)))  # fmt: skip


def beside_matplotlib(case, table):
    tri = peer("matplotlib.tri", table)
    if tri is None:
        return
    count, size = len(case.scattered), case.coarse.shape[0] * case.coarse.shape[1]
    linear = tri.LinearTriInterpolator(tri.Triangulation(*case.points.T, case.made.triangles), case.values)
    table.in_turns("linear, raster, evaluation: matplotlib", (size, lambda: case.ours(case.coarse)),
                   (size, lambda: linear(*case.grid)))  # fmt: skip
    table.in_turns("linear, scattered, evaluation: matplotlib", (count, lambda: case.ours(case.scattered)),
                   (count, lambda: linear(*case.scattered.T)))  # fmt: skip


def beside_gmt(program, count, table):
    """GMT's time grows faster than its points: fewer of them."""
    random = np.random.default_rng(1)
    points, side = random.random((count, 2)), 1000
    points[:4] = [[0, 0], [1, 0], [1, 1], [0, 1]]
    values = points[:, 0] * points[:, 1]
    rates = ([], [])
    with tempfile.TemporaryDirectory(dir="/dev/shm" if os.path.isdir("/dev/shm") else None) as folder:
        given, made = os.path.join(folder, "points.bin"), os.path.join(folder, "raster.bin")
        np.column_stack((points, values)).tofile(given)
        step = "-I%r" % (1 / side)
        command = [program, "triangulate", given, "-bi3d", "-R0/1/0/1", step, "-r", "-G%s=bd" % made]
        for _ in range(table.rounds):
            begin = time.process_time()
            surface = delaunay(points, threads=1)
            ours = surface.interpolate(values, surface.raster(shape=(side, side)))
            rates[0].append(1e-6 * side * side / (time.process_time() - begin))
            before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
            subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
            rates[1].append(1e-6 * side * side / (resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before))
        header = os.path.getsize(made) - 8 * side * side
        theirs = np.fromfile(made, np.float64, offset=header).reshape(side, side)[::-1]
    unlike = np.count_nonzero(np.isnan(ours) != np.isnan(theirs))  # a value here, none there
    difference = "%d cells have a value in one only" % unlike if unlike else "%.1g" % np.nanmax(np.abs(ours - theirs))
    table.add("linear, 10^6 cells, %s points, whole: GMT" % format(count, ","), *rates, difference)


def beside_cgal(program, count, table):
    """Of one run of the program each, which measures both itself."""
    rates = ([], [])
    for _ in range(table.rounds):
        command = [program, "--points=%d" % count, "--repeat=1"]
        said = subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True)
        for side, name in enumerate(("natural, raster", "CGAL, natural, raster")):
            found = re.search(r"^%s +\d+ places +([\d.]+) million" % name, said.stdout, re.MULTILINE)
            if found is None:
                table.missing.append("CGAL")
                return
            rates[side].append(float(found.group(1)))
    name = "natural neighbours, raster, evaluation: CGAL on a hundredth of the cells"
    table.add(name, *rates, "see NaturalBesideCgal")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--points", type=int, default=10**6)
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--gmt", help="the program gmt")
    parser.add_argument("--benchmark", help="the program SampleBenchmark, with CGAL")
    parser.add_argument("--out", type=Path, help="file for the table")
    arguments = parser.parse_args()
    table = Table(arguments.rounds)
    head = HEAD.format(date=datetime.date.today(), points=arguments.points, rounds=arguments.rounds,
                       load=os.getloadavg()[0], cores=os.cpu_count())  # fmt: skip
    case = Case(arguments.points)
    beside_scipy(case, table)
    beside_matplotlib(case, table)
    for program, measure, count, name in (
        (arguments.gmt, beside_gmt, max(1000, arguments.points // 10), "GMT"),
        (arguments.benchmark, beside_cgal, arguments.points, "SampleBenchmark"),
    ):
        if program:
            measure(program, count, table)
        else:
            table.missing.append(name)
    missing = "\nNot there: %s.\n" % ", ".join(table.missing) if table.missing else ""
    if arguments.out:
        arguments.out.write_text(head + "\n".join(table.rows) + "\n" + missing, encoding="utf-8")
    print(missing)


if __name__ == "__main__":
    main()
