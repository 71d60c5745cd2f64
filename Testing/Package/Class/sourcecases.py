# SPDX-License-Identifier: BSD-3-Clause
"""More cases for test_cases.py: sources as users have them, and what is said of them."""

from classtests import cloud, source
from inputs import square

CASES = {}


def case(make):
    """A function that makes an input and settings."""
    CASES[make.__name__] = make
    return make


@case
def lines_that_meet_as_loops():
    given = source(lines=[(1, 0), (1, 2), (3, 2), (3, 0), (4, 5)])
    return cloud(square((2, 2, 0), (2, 5, 0), (5, 2, 0))), dict(SourceData=given, ClosedLines=1, FillRule=1)


@case
def lines_of_which_none_is_closed():
    return cloud(square((2, 2, 0))), dict(SourceData=source(lines=[(1, 0), (1, 2), (4, 3)]), ClosedLines=1)


@case
def a_ring_that_is_a_line_too():
    given = source(lines=[(4, 5, 6, 4)], polygons=[(0, 1, 2, 3), (6, 5, 4)])
    return cloud(square((2, 2, 0), (2, 5, 0), (5, 2, 0))), dict(SourceData=given, ClosedLines=1, FillRule=1)


@case
def points_as_line():
    given = cloud([(1, 1, 0), (6, 1, 0), (1, 6, 0), (1, 1, 4)])
    return cloud(square((2, 2, 0))), dict(SourceData=given, SourceMode=1, PointsAsLine=True, ClosedLines=1, FillRule=1)


@case
def strips_as_no_line():
    given = source([(1, 1, 0), (6, 1, 0), (1, 6, 0), (1, 1, 4)], strips=[(0, 1, 2)])
    return cloud(square((2, 2, 0))), dict(SourceData=given, SourceMode=1, PointsAsLine=True)


@case
def a_source_elsewhere():
    given = source([(101, 1, 0), (106, 1, 0), (101, 6, 0)], polygons=[(0, 1, 2)])
    return cloud(square((2, 2, 0))), dict(SourceData=given, SourceMode=1, FillRule=1)


@case
def an_outline_around_no_point():
    given = source([(1, 1, 0), (2, 1, 0), (1, 2, 0)], polygons=[(0, 1, 2)])
    return cloud(square((5, 5, 0))), dict(SourceData=given, SourceMode=1, FillRule=1)


@case
def lines_without_heights():
    given = source([(1, 1, 0), (6, 1, 0), (1, 6, 0.5)], lines=[(0, 1), (1, 2)], polygons=[(0, 1, 2)])
    return cloud([(x, y, 1.5) for x, y, _ in square((2, 2, 0))]), dict(SourceData=given, SourceMode=1, FillRule=1)
