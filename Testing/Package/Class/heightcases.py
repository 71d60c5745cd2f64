# SPDX-License-Identifier: BSD-3-Clause
"""Inputs and settings for heights of a surface, and for points added to lines. For test_cases.py."""

from classtests import cloud, source
from inputs import full, generate_all, lines_and_loops, square

CASES = {}


def case(make):
    """A function that makes an input and settings."""
    CASES[make.__name__] = make
    return make


@case
def heights_from_the_surface():
    return full(), dict(SourceData=lines_and_loops(), SourceMode=1, SourceHeights=1, CrossingMode=1)


@case
def heights_from_the_surface_outside_it():
    given = source([(5, 5, 100), (5, 20, 100), (2, 3, 100)], lines=[(0, 1), (0, 2)])
    return cloud(square()), dict(SourceData=given, SourceMode=1, SourceHeights=1)


@case
def heights_from_the_surface_of_straight_lines():
    return full(), dict(
        SourceData=lines_and_loops(), SourceMode=1, SourceHeights=1, CrossingMode=1, SourceLinesOnSurface=False)


@case
def segments_of_a_maximum_length():
    return full(), dict(generate_all(), SourceData=lines_and_loops(), SourceMode=1, MaximumSegmentLength=40.0)


@case
def segments_of_a_maximum_length_by_ids():
    return full(), dict(SourceData=source(lines=[(0, 9), (3, 8)]), MaximumSegmentLength=40.0, DuplicatePolicy=3)


@case
def mixed_heights():
    return full(), dict(SourceData=lines_and_loops(), SourceMode=1, SourceHeights=2, ZeroIsMissing=True,
                        DuplicatePolicy=3)


@case
def mixed_heights_of_a_plane():
    return full(), dict(generate_all(), SourceData=lines_and_loops(), SourceMode=1, SourceHeights=2, CrossingMode=1,
                        ZeroIsMissing=True, ProjectionPlaneMode=2, Tolerance=0.01)


@case
def heights_from_the_surface_of_a_plane():
    return full(), dict(SourceData=lines_and_loops(), SourceMode=1, SourceHeights=1, ProjectionPlaneMode=2)
