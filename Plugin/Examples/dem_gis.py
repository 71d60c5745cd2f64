# SPDX-License-Identifier: BSD-3-Clause
"""Soundings and a coastline become a terrain model for a GIS, a GeoTIFF, and a picture of it.

    python3 dem_gis.py <soundings.csv> <coastline.vtp> <bay.tif> <bay.png>

Needs the package adaptivehilbertdelaunay (`pip install .`), geopandas, rasterio and matplotlib. The coastline is a
small .vtp file with numbers as text, such as Data/Bay/coastline.vtp; one of your own is `geopandas.read_file(...)`.
"""

import sys
import xml.etree.ElementTree as tree

if len(sys.argv) != 5:
    sys.exit("usage: python3 dem_gis.py <soundings.csv> <coastline.vtp> <bay.tif> <bay.png>")

import geopandas
import matplotlib
import numpy as np
import pandas
import rasterio
from adaptivehilbertdelaunay import delaunay
from shapely.geometry import LineString, Polygon

matplotlib.use("Agg")
from matplotlib import pyplot

soundings = pandas.read_csv(sys.argv[1]).rename(columns={"elevation": "z"})
piece = tree.parse(sys.argv[2]).find("PolyData/Piece")


def numbers(where):
    return np.array(piece.find(where).text.split(), float)


def chains(kind):
    ids, ends = (numbers("%s/DataArray[@Name='%s']" % (kind, name)).astype(int) for name in ("connectivity", "offsets"))
    return [places[one] for one in np.split(ids, ends[:-1])]


places = numbers("Points/DataArray").reshape(-1, 3)
places[:, 2] = numbers("PointData/DataArray")
rings = [Polygon(ring) for ring in chains("Polys")]
shores = [ring for ring in rings if ring.exterior.is_ccw]
islands = [ring for ring in rings if not ring.exterior.is_ccw]
water = [Polygon(shore.exterior, [one.exterior for one in islands if shore.contains(one)]) for shore in shores]
coast = geopandas.GeoDataFrame(
    {"kind": ["water"] * len(water) + ["channel"]}, geometry=water + [LineString(chains("Lines")[0])], crs="EPSG:32632")

# Polygons with their holes bound the surface, the channel is an edge; their z are those of the coastline.
bay = delaunay(soundings, constraints=coast)
print("%d triangles; %d of the constraints' segments were left out" % (len(bay.triangles), len(bay.left_out)))

# Cells of five metres over the coast, with borders at multiples of five, the northernmost row first.
cells = bay.raster(5, bounds=coast, align=True).north_up()
heights = bay.interpolate(bay.points[:, 2], cells, "natural")
cells.to_geotiff(sys.argv[3], heights, coast.crs)

# What a GIS finds there: the same numbers, in the same place, in these coordinates.
with rasterio.open(sys.argv[3]) as found:
    dem = found.read(1, masked=True)
    print("%d x %d cells in %s, %d of them water, the deepest at %.1f m" % (
        *found.shape, found.crs, dem.count(), dem.min()))
    again = bay.raster(like=found)
    extent = (found.bounds.left, found.bounds.right, found.bounds.bottom, found.bounds.top)
slopes = bay.interpolate(bay.points[:, 2], again, gradient=True)[1]
light = -slopes @ (1, -1) / 2**0.5  # of a sun in the north-west

# Lines of equal depth, exact on the triangles; with filled=True they would be polygons, for a layer of the GIS.
depths = bay.contours(bay.points[:, 2], range(-20, 0, 5))
depths = geopandas.GeoDataFrame.from_features(depths, crs=coast.crs)
for level, lines in zip(depths.level, depths.geometry):
    print("%.1f km of the line at %g m" % (lines.length / 1000, level))

figure, axes = pyplot.subplots(figsize=(9, 6), constrained_layout=True)
shown = axes.imshow(heights, extent=extent, cmap="YlGnBu_r", interpolation="nearest")
axes.imshow(light, extent=extent, cmap="gray", alpha=0.15, interpolation="nearest", vmin=-0.3, vmax=0.3)
coast[coast.kind == "water"].boundary.plot(ax=axes, color="0.2", linewidth=0.8)
depths.plot(ax=axes, color="0.3", linewidth=0.5)
axes.scatter(soundings.x, soundings.y, s=0.3, color="k")
figure.colorbar(shown, label="elevation in metres", shrink=0.8)
axes.set_title("%d soundings and a coastline" % len(soundings))
figure.savefig(sys.argv[4], dpi=110)
