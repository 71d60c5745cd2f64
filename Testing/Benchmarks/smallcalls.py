#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Small calls from Python: a few points, one place, a thousand places; beside scipy, the C interface and vtkDelaunay2D.

Both sides of a row are measured in turns of about 5 milliseconds, with one thread: the least time of a call in a turn
counts, as others on the machine only add to it. The first call after other code finds cold caches and takes longer. Who
is not there is left out. vtkDelaunay2D is beside the class that is compiled with the same VTK; to call either by Python
is 0.3 microseconds of the time.

  PYTHONPATH=<folder of adaptivehilbertdelaunay> smallcalls.py [--rounds N] [--only WORD] [--out SmallCalls.md]
"""

import argparse
import datetime
import math
import os
import platform
import time

import numpy as np
from adaptivehilbertdelaunay import LinearInterpolator, delaunay
from adaptivehilbertdelaunay import _library as library

HEAD = """# Small calls

Written by [`smallcalls.py`](smallcalls.py): microseconds a call, one thread, the least of many rounds in turns.
"""
TABLE = """
{date}, {machine}, Python {python}, NumPy {numpy}{others}; {rounds} rounds:

| call | here | the other | times the other's |
|---|--:|--:|--:|
"""


def once(call, count):
    """Microseconds of one call, of so many."""
    begin = time.perf_counter()
    for _ in range(count):
        call()
    return 1e6 * (time.perf_counter() - begin) / count


def in_turns(ours, theirs, rounds):
    """The least times of both."""
    counts = [max(1, int(5000 / once(call, 3))) for call in (ours, theirs)]
    least = [math.inf, math.inf]
    for _ in range(rounds):
        for side, call in enumerate((ours, theirs)):
            least[side] = min(least[side], once(call, counts[side]))
    return least


def beside_scipy(points, values, place):
    """Rows: the call, ours, scipy's."""
    from scipy.interpolate import LinearNDInterpolator
    from scipy.spatial import Delaunay

    few, made = points[:10], delaunay(points, threads=1)
    ours, theirs, simplices = LinearInterpolator(made, values), LinearNDInterpolator(points, values), Delaunay(points)
    for some, name in ((few, "10"), (points, "1,000")):
        yield ("`delaunay` of %s points, triangles; scipy" % name,
               lambda some=some: delaunay(some, threads=1).triangles, lambda some=some: Delaunay(some).simplices)
    yield "`interpolate` at one place; scipy", lambda: made.interpolate(values, place), lambda: theirs(place)
    yield "`LinearInterpolator` at one place; scipy", lambda: ours(place), lambda: theirs(place)
    yield "`locate` of one place; scipy", lambda: made.locate(place), lambda: simplices.find_simplex(place)


def beside_the_library(points, values, places):
    """The same for ahd_sample, with arrays that are ready."""
    ours, other = LinearInterpolator(delaunay(points, threads=1), values), delaunay(points, threads=1)
    other.interpolate(values, places)  # makes the tables
    other._job._hear(None)  # of no progress, which the job of a call in Python would be told
    out = np.empty(len(places))
    array = library.array_type(library.Sampled, 1)(library.Sampled(values.ctypes.data, 1, out.ctypes.data, None))
    at = library.Places(places.ctypes.data, len(places))
    arguments = other._job._handle.address, at, array, 1, None
    yield ("`LinearInterpolator` at 1,000 places; `ahd_sample`", lambda: ours(places),
           lambda: library.C.ahd_sample(*arguments))  # fmt: skip


def beside_vtk():
    """The same for the class that is compiled with VTK."""
    from adaptivehilbertdelaunay import vtkAdaptiveHilbertDelaunay2D
    from vtkmodules.vtkCommonCore import vtkPoints
    from vtkmodules.vtkCommonDataModel import vtkPolyData
    from vtkmodules.vtkFiltersCore import vtkDelaunay2D

    if not vtkAdaptiveHilbertDelaunay2D.__module__.endswith("AdaptiveHilbertDelaunayFilters"):
        raise ImportError("the class is not compiled")
    for count in (10, 100, 1000):
        points = vtkPoints()
        for x, y in np.random.default_rng(1).random((count, 2)):
            points.InsertNextPoint(x, y, 0.0)
        data = vtkPolyData()
        data.SetPoints(points)
        both = vtkAdaptiveHilbertDelaunay2D(), vtkDelaunay2D()
        both[0].SetNumberOfThreads(1)
        for each in both:
            each.SetInputData(data)
        yield ("`Update()` of %s points; vtkDelaunay2D" % format(count, ","),
               *(lambda each=each: (each.Modified(), each.Update()) for each in both))  # fmt: skip


def rows(points, values, places):
    for make in (lambda: beside_scipy(points, values, places[:1]), lambda: beside_the_library(points, values, places),
                 beside_vtk):  # fmt: skip
        try:
            yield from make()
        except ImportError as error:
            print("left out: %s" % error)


def versions():
    """Of packages that are there."""
    for name, module in (("SciPy", "scipy"), ("VTK", "vtkmodules.vtkCommonCore")):
        try:
            found = __import__(module, fromlist=["_"])
        except ImportError:
            continue
        yield "%s %s" % (name, getattr(found, "__version__", None) or found.vtkVersion.GetVTKVersion())


def processor():
    """Its name, where the system tells it."""
    try:
        with open("/proc/cpuinfo", encoding="utf-8") as file:
            return next(line.partition(":")[2].strip() for line in file if line.startswith("model name"))
    except (OSError, StopIteration):
        return platform.processor() or platform.machine()


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--rounds", type=int, default=300)
    parser.add_argument("--only", default="", help="calls with this word")
    parser.add_argument("--out", help="adds the table to this file")
    chosen = parser.parse_args()
    random = np.random.default_rng(1)
    points, values, places = random.random((1000, 2)), random.random(1000), random.random((1000, 2))
    lines = []
    for name, ours, theirs in rows(points, values, places):
        if chosen.only not in name:
            continue
        least = in_turns(ours, theirs, chosen.rounds)
        lines.append("| %s | %.1f | %.1f | %.2f |" % (name, *least, least[0] / least[1]))
        print(lines[-1], flush=True)
    if chosen.out:
        others = "".join(", " + said for said in versions())
        table = TABLE.format(
            date=datetime.date.today(), rounds=chosen.rounds, others=others, python=platform.python_version(),
            numpy=np.__version__, machine="%s, %d processors" % (processor(), os.cpu_count() or 1))  # fmt: skip
        with open(chosen.out, "a", encoding="utf-8") as file:
            file.write(("" if file.tell() else HEAD) + table + "\n".join(lines) + "\n")


if __name__ == "__main__":
    main()
