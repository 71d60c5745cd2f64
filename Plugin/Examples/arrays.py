# SPDX-License-Identifier: BSD-3-Clause
"""Soundings and a coastline as NumPy arrays: how much water is in the bay, and how deep is it here and there?

    python3 arrays.py <soundings.csv> <coastline.vtp>

Needs NumPy and the package adaptivehilbertdelaunay (`pip install .`); no VTK. The coastline is a small .vtp file with
numbers as text, such as Data/Bay/coastline.vtp, which this reads by itself.
"""

import sys
import xml.etree.ElementTree as tree

import numpy as np
from adaptivehilbertdelaunay import delaunay

if len(sys.argv) != 3:
    sys.exit("usage: python3 arrays.py <soundings.csv> <coastline.vtp>")
soundings = np.loadtxt(sys.argv[1], delimiter=",", skiprows=1)  # x, y, elevation
piece = tree.parse(sys.argv[2]).find("PolyData/Piece")


def numbers(where):
    return np.array(piece.find(where).text.split(), float)


def chains(kind):
    ids, ends = (numbers("%s/DataArray[@Name='%s']" % (kind, name)).astype(int) for name in ("connectivity", "offsets"))
    return np.split(ids, ends[:-1])


shore = numbers("Points/DataArray").reshape(-1, 3)
shore[:, 2] = numbers("PointData/DataArray")

# The coastline has points of its own. Polygons bound the surface: the shore, and islands as holes; which way they run
# does not matter. Lines, here the channel, are edges.
bay = delaunay(soundings, source_points=shore, loops=chains("Polys"), lines=chains("Lines"))
print("%d triangles; %d constraint edges" % (len(bay.triangles), len(bay.constraint_edges)))
print("%d of the constraints' segments were left out" % len(bay.left_out))

# Each triangle: its area in the plane, and the water above it.
x, y, z = np.moveaxis(bay.points[bay.triangles], 2, 0)
area = ((x[:, 1] - x[:, 0]) * (y[:, 2] - y[:, 0]) - (x[:, 2] - x[:, 0]) * (y[:, 1] - y[:, 0])) / 2
print("%.4f square kilometres of water, %.3e cubic metres" % (area.sum() / 1e6, -(area * z.mean(axis=1)).sum()))

# The channel cuts the water into regions.
for region, size in enumerate(np.bincount(bay.regions, area)):
    print("region %d: %.4f square kilometres" % (region, size / 1e6))

# The depth at places: linear in the triangle that has them. Land and what is outside has none.
places = soundings[:, :2].mean(axis=0) + np.array([[0, 0], [500, 200], [-400, 100], [1e6, 0]])
for place, triangle in zip(places, bay.locate(places).triangle):
    if triangle < 0:
        print("(%.0f, %.0f): no water" % tuple(place))
        continue
    corners = bay.points[bay.triangles[triangle]]
    weights = np.linalg.solve(np.vstack((corners[:, :2].T, np.ones(3))), np.append(place, 1))
    print("(%.0f, %.0f): %.2f m deep" % (*place, -weights @ corners[:, 2]))
