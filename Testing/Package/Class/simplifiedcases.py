# SPDX-License-Identifier: BSD-3-Clause
"""Surfaces of fewer points than given, and settings that exclude one. For test_cases.py."""

import math

from classtests import cloud
from inputs import generate_all, lines_and_loops, scattered

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
