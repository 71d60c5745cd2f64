# SPDX-License-Identifier: BSD-3-Clause
"""How much lies above a level, and how much below? Exactly that of the triangles, without a raster.

    python3 volumes.py <points.csv> <level>

Needs NumPy and the package adaptivehilbertdelaunay (`pip install .`). The table has x, y and a height, and a line with
their names; Data/Bay/soundings.csv is one. Over a triangle the height is linear. Above a level lies all of it, nothing,
a corner, or all but a corner; what is over a corner is a pyramid, and its volume needs no more than the three heights.
"""

import sys

import numpy as np


def at_level(points, triangles, level):
    """The volume between a surface and a level: (above it, below it, the area above it). `points`: x, y and height of
    each; `triangles`: three of their numbers each."""
    x, y, z = np.moveaxis(np.asarray(points, float)[np.asarray(triangles)], 2, 0)
    area = np.abs((x[:, 1] - x[:, 0]) * (y[:, 2] - y[:, 0]) - (x[:, 2] - x[:, 0]) * (y[:, 1] - y[:, 0])) / 2
    low, middle, high = np.sort(z - level, axis=1).T
    whole = area * (low + middle + high) / 3
    with np.errstate(divide="ignore", invalid="ignore"):
        top = np.where(high > 0, high**2 / ((high - low) * (high - middle)), 0.0)  # share of the area over the level
        bottom = np.where(low < 0, low**2 / ((low - high) * (low - middle)), 0.0)  # and of that under it
    is_corner = middle <= 0  # at most the highest corner is above
    above = np.where(is_corner, np.where(high > 0, area * top * high / 3, 0.0), whole - area * bottom * low / 3)
    above = np.where(low >= 0, whole, above)
    over = np.where((low >= 0) & (high > 0), area, np.where(is_corner, area * top, area * (1 - bottom)))
    return above.sum(), (above - whole).sum(), over.sum()


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit("usage: python3 volumes.py <points.csv> <level>")
    from adaptivehilbertdelaunay import delaunay

    surface = delaunay(np.loadtxt(sys.argv[1], delimiter=",", skiprows=1)[:, :3])
    found = at_level(surface.points, surface.triangles, float(sys.argv[2]))
    print("above: %.6g, below: %.6g; area above the level: %.6g" % found)
