# SPDX-License-Identifier: BSD-3-Clause
"""Surfaces of fewer points than given, and settings that exclude one. For test_cases.py."""

import math

from classtests import array, cloud, source
from inputs import full, generate_all, lines_and_loops, scattered

CASES = {}


def case(make):
    """A function that makes an input and settings."""
    CASES[make.__name__] = make
    return make


def hills(count=600):
    """With a surface that is smooth."""
    return cloud([(x, y, 50 * math.sin(x / 160) * math.cos(y / 180)) for x, y, _ in scattered(count)])


@case
def simplified():
    return hills(), dict(MaximumError=2.0, SecondPass=True, GeneratePointStatus=True)


@case
def simplified_with_all():
    return hills(), dict(generate_all(), MaximumError=2.0, SourceData=lines_and_loops(), SourceMode=1, CrossingMode=1,
                         DuplicatePolicy=1)


@case
def simplified_in_a_plane():
    return hills(), dict(MaximumError=2.0, ProjectionPlaneMode=2, Tolerance=0.01, MaximumEdgeLength=300.0)


@case
def simplified_to_a_number():
    return hills(), dict(MaximumNumberOfVertices=80, MaximumError=0.5, GeneratePointStatus=True)


@case
def simplified_by_values():
    """With weights and marks; the source has values of its own, and one point that none of its lines has."""
    points = hills()
    data, count = points.GetPointData(), points.GetNumberOfPoints()
    data.AddArray(array("vtkFloatArray", "Heat", [0.25 * (i % 40) ** 2 + math.sin(i) for i in range(count)]))
    data.AddArray(array("vtkIntArray", "Weight", [i % 7 for i in range(count)]))
    data.AddArray(array("vtkDoubleArray", "Mark", [0.5 * (i % 90 == 0) for i in range(count)]))
    lines = source([(100, 100, 0), (900, 800, 0), (500, 520, 0), (300, 900, 0), (600, 50, 0)], lines=[(0, 1), (3, 4)])
    lines.GetPointData().AddArray(array("vtkDoubleArray", "Heat", [10, math.nan, 30, 40, 50]))
    return points, dict(MaximumError=300.0, ValueArrayName="Heat", WeightArrayName="Weight", KeepArrayName="Mark",
                        SourceData=lines, SourceMode=1, CrossingMode=1, MergeBlocks=True)


@case
def simplified_by_what_is_not_there():
    points = hills()
    points.GetPointData().AddArray(array("vtkDoubleArray", "Flow", [0.0] * 2 * points.GetNumberOfPoints(), 2))
    return points, dict(MaximumError=2.0, ValueArrayName="Flow", WeightArrayName="Nothing", KeepArrayName="None",
                        GenerateErrors=True)


@case
def simplified_with_all_points():
    return hills(), dict(MaximumError=2.0, KeptPointsOnly=False)


@case
def simplified_to_nothing():
    """Without cells all points stay."""
    return cloud([(i, 2.0 * i, i % 3) for i in range(9)]), dict(MaximumError=2.0)


@case
def errors_of_a_surface():
    """Of which a part is cut away, and some points are not in it."""
    return full(), dict(GenerateErrors=True, Tolerance=0.01, MaximumEdgeLength=200.0, ValueArrayName="Height")


@case
def simplified_and_a_limit():
    return hills(), dict(MaximumError=2.0, InsertionLimit=100)


@case
def simplified_and_alpha():
    return hills(), dict(MaximumNumberOfVertices=80, Alpha=50.0)


@case
def simplified_and_means():
    return hills(), dict(MaximumError=2.0, DuplicatePolicy=3)


@case
def little_memory_to_simplify():
    return hills(3000), dict(MaximumError=2.0, MemoryLimit=10)
