# SPDX-License-Identifier: BSD-3-Clause
"""Points and constraints with all data that the filter reads. For cases.py."""

import math

from classtests import TABLE, Random, array, cloud, core, source


def scattered(count, seed=5, height=17):
    random = Random(seed)
    points = [[1000 * random.unit(), 1000 * random.unit(), float(i % height)] for i in range(count)]
    for i in range(9, count, 10):  # some at the place of others
        points[i][:2] = points[i - 5][:2]
    return points


def full(count=200, number=core.VTK_DOUBLE):
    """A cloud with heights as scalars, words, ghost marks, vectors, whole numbers, names of the points."""
    made = cloud(scattered(count), number)
    data = made.GetPointData()
    data.SetScalars(array("vtkDoubleArray", "Height", [0.5 * i for i in range(count)]))
    words = array("vtkStringArray", "Word", ["point %d" % i for i in range(count)])
    data.AddArray(words)
    data.AddArray(array("vtkUnsignedCharArray", "vtkGhostType", [int(i == 3) for i in range(count)]))
    data.AddArray(array("vtkFloatArray", "Flow", [0.25 * i for i in range(2 * count)], 2))
    data.AddArray(array("vtkIntArray", "Kind", [3 * i - 100 for i in range(count)]))
    data.AddArray(array("vtkUnsignedCharArray", "Class", [i % 256 for i in range(count)]))
    data.SetGlobalIds(array("vtkIdTypeArray", "Global", range(1000, 1000 + count)))
    made.GetFieldData().AddArray(array("vtkDoubleArray", "Year", [2016.0]))
    return made


def lines_and_loops():
    """With points of their own: lines that cross, one with an invalid id, a square with a hole."""
    made = source(
        [(100, 510, 1), (900, 520, 2), (500, 100, 3), (510, 900, 4), (20, 30, 0), (50, 50, 0), (950, 50, 0),
         (950, 950, 0), (50, 950, 0), (600, 600, 0), (600, 800, 0), (800, 600, 0)],
        lines=[(0, 1), (2, 3), (4, 99)], polygons=[(5, 6, 7, 8), (9, 10, 11)])
    made.GetPointData().AddArray(array("vtkDoubleArray", "Height", range(100, 112)))
    made.GetPointData().AddArray(array("vtkDoubleArray", "Class", [i * 30.7 - 20 for i in range(12)]))
    made.GetPointData().AddArray(array("vtkDoubleArray", "Kind", [math.nan, 1e300, -1e300] + [0.5] * 9))
    return made


def generate_all():
    names = [name for name in TABLE["delaunay"]["settings"] if name.startswith("Generate")]
    return dict({name: True for name in names}, Nmax=5)


def square(*more):
    return [(0, 0, 0), (10, 0, 1), (10, 10, 2), (0, 10, 3), *more]
