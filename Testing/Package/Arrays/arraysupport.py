# SPDX-License-Identifier: BSD-3-Clause
"""Shared by the tests of arrays: points, exact arithmetic in Python's integers, the hash of Data/Hashes."""

import json
import os
import subprocess
import sys
import unittest
import warnings

import numpy as np

sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.abspath(__file__))))

import numbered  # noqa: E402
from adaptivehilbertdelaunay import DelaunayWarning, Triangulation  # noqa: E402
from numbered import Random  # noqa: E402

ROOT = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", ".."))
DATA = os.path.join(ROOT, "Data")

with open(os.path.join(ROOT, "Testing", "Support", "settings.json"), encoding="utf-8") as _file:
    TABLE = json.load(_file)  # of Filters/Settings

SQUARE = np.array([[0, 0], [4, 0], [4, 4], [0, 4], [1, 2], [3, 2]], float)


class KeywordTest(unittest.TestCase):
    """A warning that is not awaited is an error."""

    def setUp(self):
        warnings.simplefilter("error", DelaunayWarning)
        self.addCleanup(warnings.resetwarnings)


# --- Points -------------------------------------------------------------------------------------------------


def cloud(seed, count=200, columns=2, dtype=np.float64):
    """Random points in the unit square; the third column is random as well."""
    return np.random.default_rng(seed).random((count, columns)).astype(dtype)


def drawn_by(job, dtype):
    """The arrays of Job.draw_order(), by name."""
    points, cells = job.count("drawn_points"), job.count("drawn_cells")
    made = {"xyz": np.empty((points, 3)), "ranks": np.empty(points, dtype), "ids": np.empty(points, dtype),
            "levels": np.empty(cells, np.int32), "counts": np.empty(cells, dtype)}  # fmt: skip
    job.draw_order(**made)
    return made


def lattice(side):
    """Many cocircular points, and collinear ones on the hull."""
    x, y = np.meshgrid(np.arange(side), np.arange(side))
    return np.stack((x.ravel(), y.ravel()), axis=1).astype(float)


def corpus():
    """(name, points) of Data/Corpus."""
    folder = os.path.join(DATA, "Corpus")
    for name in sorted(os.listdir(folder)):
        if name.endswith(".txt"):
            with open(os.path.join(folder, name), encoding="utf-8") as file:
                rows = [line.split() for line in file if line.strip() and not line.startswith("#")]
            yield name, np.array([[float.fromhex(number) for number in row] for row in rows]).reshape(-1, 2)


def uniform(count, seed):
    """The points of Testing/Support/Points/Distributions.h with this name."""
    random = Random(seed)
    return np.array([random.unit() for _ in range(2 * count)]).reshape(-1, 2)


# --- Results ------------------------------------------------------------------------------------------------


def attributes():
    """The names of a Triangulation's arrays."""
    others = ("boxes", "counts", "measures", "vertex_neighbors", "vertex_triangles")
    return [name for kind in Triangulation.__mro__ for name, member in vars(kind).items()
            if isinstance(member, property) and not name.startswith("_") and name not in others]  # fmt: skip


# --- Programs -----------------------------------------------------------------------------------------------


def in_a_process(script, *arguments):
    return subprocess.run(
        [sys.executable, "-c", script, *arguments], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
        timeout=200, check=False)  # fmt: skip


# --- The hash of Data/Hashes --------------------------------------------------------------------------------


class Hash(numbered.Hash):
    """The same of whole arrays."""

    def numbers(self, array):
        """The numbers of an array, without their count."""
        kind = "<f8" if array.dtype.kind == "f" else "<i8"
        self.add_bytes(np.ascontiguousarray(array.ravel(), kind).tobytes())

    def vector(self, array, size=None):
        """A vector: its length (in entries of several numbers perhaps), and its numbers."""
        self.add(array.size if size is None else size)
        self.numbers(array)


def expected_hashes():
    """Name: hash, of Data/Hashes/Engine.txt."""
    with open(os.path.join(DATA, "Hashes", "Engine.txt"), encoding="utf-8") as file:
        rows = [line.split() for line in file if not line.startswith("#")]
    return {name: value for value, name in rows}


# --- Exact --------------------------------------------------------------------------------------------------


def integers(points):
    """The same places, all larger by one power of two: tuples of Python's integers."""
    ratios = [[float(number).as_integer_ratio() for number in point[:2]] for point in points]
    scale = max([below for row in ratios for _, below in row], default=1)
    return [tuple(above * (scale // below) for above, below in row) for row in ratios]


def orient(a, b, c):
    """Positive if a, b, c turn to the left."""
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def in_circle(a, b, c, d):
    """Positive if d is inside the circle through a, b, c, which turn to the left."""
    rows = [(p[0] - d[0], p[1] - d[1]) for p in (a, b, c)]
    (ax, ay), (bx, by), (cx, cy) = rows
    aa, bb, cc = (x * x + y * y for x, y in rows)
    return aa * (bx * cy - cx * by) - bb * (ax * cy - cx * ay) + cc * (ax * by - bx * ay)


def hull_of(places):
    """The vertices on the boundary of the convex hull, counterclockwise, those on its edges included; with two points
    or more that are not collinear."""

    def half(ordered):
        chain = []
        for p in ordered:
            while len(chain) > 1 and orient(chain[-2], chain[-1], p) < 0:
                chain.pop()
            chain.append(p)
        return chain

    ordered = sorted(set(places))
    return half(ordered)[:-1] + half(ordered[::-1])[:-1]


def twice_area(places, triangles):
    return sum(orient(*(places[i] for i in triangle)) for triangle in triangles)


def complaints(points, triangles, neighbors, is_constraint=None):
    """The faults of the triangles of a (constrained) Delaunay triangulation, locally and exactly."""
    places = integers(points)
    triangles, neighbors = triangles.tolist(), neighbors.tolist()
    found = []
    for t, (triangle, beyond) in enumerate(zip(triangles, neighbors)):
        corners = [places[i] for i in triangle]
        if orient(*corners) <= 0:
            found.append("triangle %d is not counterclockwise" % t)
        for e, other in enumerate(beyond):
            if other < 0:
                continue
            edge = (triangle[e], triangle[(e + 1) % 3])
            apex = [i for i in triangles[other] if i not in edge]
            if len(apex) != 1 or t not in neighbors[other]:
                found.append("triangles %d and %d are no neighbours" % (t, other))
            elif not (is_constraint is not None and is_constraint[t][e]) and in_circle(*corners, places[apex[0]]) > 0:
                found.append("point %d lies in the circle of triangle %d" % (apex[0], t))
    return found
