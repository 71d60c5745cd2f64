# SPDX-License-Identifier: BSD-3-Clause
"""A program written for scipy and matplotlib, the size of a notebook: soundings of a bay as linear and cubic surfaces.

    python3 bay_scipy.py <soundings.csv> <coastline.vtp> <picture.png>

Needs matplotlib and the package adaptivehilbertdelaunay (`pip install .`); no scipy, whose imports it would have:

    from scipy.interpolate import CloughTocher2DInterpolator, griddata
    from scipy.spatial import Delaunay
"""

import sys
import xml.etree.ElementTree as tree

import matplotlib.pyplot as plt
import numpy as np
from adaptivehilbertdelaunay import delaunay
from adaptivehilbertdelaunay.scipy import CloughTocher2DInterpolator, Delaunay, griddata

if len(sys.argv) != 4:
    sys.exit("usage: python3 bay_scipy.py <soundings.csv> <coastline.vtp> <picture.png>")
x, y, z = np.loadtxt(sys.argv[1], delimiter=",", skiprows=1).T
points = np.column_stack((x, y))
tri = Delaunay(points)
print("%d soundings, %d triangles, %d of them at the hull" % (len(points), len(tri.simplices), len(tri.convex_hull)))

# On a grid over all, as any program for scipy does it.
X, Y = np.meshgrid(np.linspace(x.min(), x.max(), 400), np.linspace(y.min(), y.max(), 300))
linear = griddata(points, z, (X, Y))
cubic = griddata(points, z, (X, Y), method="cubic")
print("linear and cubic differ by %.2f m in the median" % np.nanmedian(abs(linear - cubic)))

# What scipy does not have: the coastline bounds the surface, with islands as holes; the cubic one, too.
piece = tree.parse(sys.argv[2]).find("PolyData/Piece")


def numbers(where):
    return np.array(piece.find(where).text.split(), float)


def chains(kind):
    ids, ends = (numbers("%s/DataArray[@Name='%s']" % (kind, name)).astype(int) for name in ("connectivity", "offsets"))
    return np.split(ids, ends[:-1])


shore = numbers("Points/DataArray").reshape(-1, 3)
water = delaunay(points, source_points=shore[:, :2], loops=chains("Polys"), lines=chains("Lines"))
heights = np.concatenate((z, numbers("PointData/DataArray")))
smooth = CloughTocher2DInterpolator(water, heights)(X, Y)
print("%d of %d places are in the water" % (np.isfinite(smooth).sum(), smooth.size))

figure, axes = plt.subplots(2, 2, figsize=(11, 8), sharex=True, sharey=True, constrained_layout=True)
levels = np.linspace(z.min(), 0, 13)
for axis, title, values in zip(axes.flat, ("griddata, linear", "griddata, cubic", "cubic, with the coastline"), (
    linear, cubic, smooth)):  # fmt: skip
    axis.contourf(X, Y, values, levels, extend="both")
    axis.set_title(title)
shown = axes[1, 1].tricontourf(water.to_matplotlib(), heights, levels, extend="both")
axes[1, 1].triplot(water.to_matplotlib(), lw=0.2, color="white")
axes[1, 1].set_title("to_matplotlib: tricontourf, triplot")
figure.colorbar(shown, ax=axes, label="elevation")
for axis in axes.flat:
    axis.set_aspect("equal")
figure.savefig(sys.argv[3], dpi=80)
