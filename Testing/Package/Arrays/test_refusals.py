# SPDX-License-Identifier: BSD-3-Clause
"""Every refusal of the arrays' package, word for word as in Refusals.json, and none left out: every text that a module
raises is in one of them. AHD_WRITE_HASHES=1 writes the file anew, to be read and committed with the change.
"""

import ast
import copy
import json
import os
import pathlib
import re
import unittest
import warnings
from types import SimpleNamespace
from unittest import mock

import numpy as np

from adaptivehilbertdelaunay import (
    DelaunayWarning, LinearInterpolator, NearestInterpolator, Raster, _exchange, _geotiff, delaunay, scipy,
)
from arraysupport import SQUARE, cloud

import literals  # (arraysupport has put its folder on the path)
import test_geometry
import test_input

FILE = pathlib.Path(__file__).with_name("Refusals.json")
MODULES = ("_contours.py", "_edit.py", "_exchange.py", "_found.py", "_geometry.py", "_geotiff.py", "_input.py",
           "_interpolators.py", "_made.py", "_names.py", "_outlined.py", "_raster.py", "_refined.py", "_sampling.py",
           "_simplified.py", "_spatial.py", "_triangulate.py", "_triangulation.py", "scipy.py")  # fmt: skip
# Exceptions that are caught again, with other texts.
INSIDE = (" is not a number", '"voronoi_polygon"')
NOT_MUST = re.compile("(is|are|has|have) to (be|have) ")
VALUES = np.arange(6.0)
MADE = delaunay(SQUARE)
WITH_SOURCE = delaunay(SQUARE, source_points=SQUARE[:2] + 0.5)
MASKED = np.ma.masked_less(SQUARE, 2)
PLACE = [[1, 1]]
CELLS = Raster((0, 0), (1, 1), (2, 3))


class Endless:
    """A number above all of float's."""

    def __float__(self):
        raise OverflowError

    def __repr__(self):
        return "10**400"


def plane_of_shape(xyz):
    return xyz[:, :2]


class OfGdal:
    """A data set of GDAL, with such a place."""

    RasterXSize = RasterYSize = 2

    def __init__(self, *geotransform):
        self.GetGeoTransform = lambda: geotransform


class OfXarray:
    """A DataArray with such coordinates."""

    def __init__(self, **coords):
        self.dims, self.coords = tuple(coords), {name: each for name, each in coords.items() if each is not None}


def unknown_system(_):
    raise ValueError("no such system")


SYSTEMS = SimpleNamespace(CRS=SimpleNamespace(from_user_input=unknown_system))
RASTERIO = SimpleNamespace(__name__="rasterio", crs=SYSTEMS)


def written_without_packages():
    with mock.patch.object(_exchange, "writer", lambda: None):
        CELLS.to_geotiff("none.tif", np.zeros((2, 3)))


def edited(call):
    """A call of an edit of six points."""
    return lambda: call(MADE.edit())


def closed(edit):
    with edit:
        pass
    edit.insert([[5, 5]])


def lost(edit):
    with mock.patch.object(edit._job, "isLost", True):
        edit.insert([[5, 5]])


def changed():
    points = SQUARE.astype(np.float64)
    made = delaunay(points)
    points[0] = 7, 7
    made.interpolate(VALUES, PLACE)


# By name: the refused call. Refusals of delaunay()'s own arguments are in test_input.py.
CALLS = {
    "raster of nothing": lambda: MADE.raster(),
    "raster of both": lambda: MADE.raster(cell_size=1, shape=(1, 1)),
    "cell_size 0": lambda: MADE.raster(cell_size=0),
    "cell_size infinite": lambda: MADE.raster(cell_size=(1, np.inf)),
    "cell_size of three": lambda: MADE.raster(cell_size=(1, 1, 1)),
    "cell_size of text": lambda: MADE.raster(cell_size="5"),
    "shape 0": lambda: MADE.raster(shape=(0, 5)),
    "shape too large": lambda: MADE.raster(shape=(1, 2**31)),
    "shape of parts": lambda: MADE.raster(shape=(1.5, 5)),
    "shape and align": lambda: MADE.raster(shape=(1, 5), align=True),
    "bounds that descend": lambda: MADE.raster(cell_size=1, bounds=(1, 0, 0, 1)),
    "bounds of two": lambda: MADE.raster(cell_size=1, bounds=(0, 1)),
    "too many cells": lambda: MADE.raster(cell_size=1e-12),
    "cells that are not apart": lambda: MADE.raster(cell_size=1, bounds=(1e17, 1e17 + 64, 0, 1)),
    "raster too wide": lambda: MADE.raster(shape=(8, 8), bounds=(0, 1, -1.7e308, 1.7e308)),
    "raster without vertices": lambda: delaunay(np.full((3, 2), np.nan)).raster(shape=(1, 1)),
    "spacing 0": lambda: Raster((0, 0), (0, 1), (1, 1)),
    "spacing of one": lambda: Raster((0, 0), 1, (1, 1)),
    "origin infinite": lambda: Raster((np.inf, 0), (1, 1), (1, 1)),
    "origin of text": lambda: Raster(("a", 0), (1, 1), (1, 1)),
    "negative shape": lambda: Raster((0, 0), (1, 1), (-1, 1)),
    "bounds of shapely": lambda: MADE.raster(cell_size=1, bounds=(2, 1, 3, 4)),
    "bounds of nothing": lambda: MADE.raster(cell_size=1, bounds={"type": "Polygon", "coordinates": []}),
    "like and more": lambda: MADE.raster(like=CELLS, cell_size=1),
    "tile by a number": lambda: CELLS[1],
    "tile with steps": lambda: CELLS[::2, :],
    "method": lambda: MADE.interpolate(VALUES, PLACE, "cubic"),
    "method that is none": lambda: MADE.interpolate(VALUES, PLACE, 1),
    "too few values": lambda: MADE.interpolate(VALUES[:5], PLACE),
    "values of text": lambda: MADE.interpolate(["a"] * 6, PLACE),
    "masked values": lambda: MADE.interpolate(MASKED[:, 0], PLACE),
    "masked places": lambda: MADE.interpolate(VALUES, MASKED),
    "places in space": lambda: MADE.interpolate(VALUES, [[1, 1, 1]]),
    "places of text": lambda: MADE.interpolate(VALUES, [["a", "b"]]),
    "outside": lambda: MADE.interpolate(VALUES, PLACE, outside="far"),
    "outside of two": lambda: MADE.interpolate(VALUES, PLACE, outside=[1, 2]),
    "gradient by neighbours": lambda: MADE.interpolate(VALUES, PLACE, "natural", gradient=True),
    "method without places": lambda: MADE.interpolate(VALUES, method="natural"),
    "places to locate": lambda: MADE.locate([1, 1]),
    "clip": lambda: MADE.voronoi("box"),
    "clip of four numbers": lambda: MADE.voronoi([0, 0, 1, 1]),
    "clip of text": lambda: MADE.voronoi([["a", "b"]]),
    "clip that is not finite": lambda: MADE.voronoi([[0, 0], [np.inf, 1]]),
    "clip of a line": lambda: MADE.voronoi({"type": "LineString", "coordinates": [[0, 0], [1, 1]]}),
    "clip without an area": lambda: MADE.voronoi([[0, 0], [0, 1]]),
    "voronoi_clip that is not convex": lambda: delaunay(SQUARE, voronoi_clip=[[0, 0], [1, 1], [1, 0], [0, 1]]),
    "voronoi_clip in space": lambda: delaunay(SQUARE, voronoi_clip=np.zeros((3, 3))),
    "rescaled triangulation": lambda: LinearInterpolator(MADE, VALUES, rescale=True),
    "values of an interpolator": lambda: LinearInterpolator(SQUARE, VALUES[:5]),
    "text of an interpolator": lambda: LinearInterpolator(SQUARE, ["a"] * 6),
    "fill_value": lambda: LinearInterpolator(SQUARE, VALUES, [1, 2]),
    "points of an interpolator in space": lambda: LinearInterpolator(cloud(1, 6, 3), VALUES),
    "points of an interpolator of text": lambda: LinearInterpolator([["a", "b"]], [1]),
    "arguments of an interpolator": lambda: LinearInterpolator(SQUARE, VALUES)(1, 2, 3),
    "places of an interpolator": lambda: LinearInterpolator(SQUARE, VALUES)([1, 2, 3]),
    "nearest with bounding points": lambda: NearestInterpolator(delaunay(SQUARE, bounding=True), VALUES),
    "nearest to nowhere": lambda: NearestInterpolator(SQUARE, list("abcdef"))([[np.nan, 0], [0, 0]]),
    "bounding in a plane": lambda: delaunay(SQUARE, bounding=True, plane="best_fit"),
    "source's ids": lambda: delaunay(SQUARE, source_points=SQUARE[:3], lines=[[0, 3]]),
    "plane of another shape": lambda: delaunay(SQUARE, plane=plane_of_shape),
    "what scipy calls otherwise": lambda: MADE.simplices,
    "what scipy's has": lambda: MADE.add_points,
    "points across": lambda: delaunay(np.zeros((2, 9))),
    "loops of coordinates": lambda: delaunay(SQUARE, loops=[SQUARE[:3].tolist(), SQUARE[:4].tolist()]),
    "a loop of coordinates": lambda: delaunay(SQUARE, loops=SQUARE),
    "a loop of ids above all": lambda: delaunay(SQUARE, loops=np.array([0, 1, 2**63], np.uint64)),
    "ragged segments": lambda: delaunay(SQUARE, segments=[[0, 1], [2]]),
    "values without those of the source": lambda: WITH_SOURCE.interpolate(VALUES, PLACE),
    "values of an interpolator with a source": lambda: LinearInterpolator(WITH_SOURCE, VALUES),
    "constraints of both kinds": lambda: delaunay(SQUARE, constraints=SQUARE[:3], loops=[0, 1, 2]),
    "x and y": lambda: delaunay(SQUARE[:, 0], SQUARE[:, 1]),
    "both names": lambda: delaunay(SQUARE, tol=0, tolerance=0),
    "heights of points in space": lambda: delaunay(np.zeros((6, 3)), heights=VALUES),
    "too few heights": lambda: delaunay(SQUARE, heights=VALUES[:5]),
    "heights of text": lambda: delaunay(SQUARE, heights=["a"] * 6),
    "heights by two names": lambda: delaunay(SQUARE, heights="own", source_heights="surface"),
    "simplified and a limit": lambda: delaunay(SQUARE, maximum_error=1, insertion_limit=3),
    "simplified and alpha": lambda: delaunay(SQUARE, alpha=1).simplify(maximum_vertices=5),
    "simplified and means": lambda: delaunay(SQUARE, maximum_error=1, duplicates="mean_z"),
    "simplify to nothing": lambda: MADE.simplify(),
    "simplify to NaN": lambda: MADE.simplify(np.nan),
    "simplify to infinity": lambda: MADE.simplify(np.inf),
    "simplify to less than nothing": lambda: MADE.simplify(-1.0),
    "simplify to text": lambda: MADE.simplify("1"),
    "simplify to parts of a vertex": lambda: MADE.simplify(maximum_vertices=1.5),
    "simplify too few values": lambda: MADE.simplify(1, values=VALUES[:5]),
    "simplify values of text": lambda: MADE.simplify(1, values=["a"] * 6),
    "simplify masked values": lambda: MADE.simplify(1, values=MASKED[:, 0]),
    "refine to a wide angle": lambda: MADE.refine(35),
    "refine to NaN": lambda: MADE.refine(np.nan),
    "refine to no area": lambda: MADE.refine(maximum_area=0),
    "refine to an infinite area": lambda: MADE.refine(maximum_area=np.inf),
    "refine to an area of text": lambda: MADE.refine(maximum_area="1"),
    "refine to a negative length": lambda: MADE.refine(maximum_length=-2.0),
    "refine to True": lambda: MADE.refine(maximum_area=True),
    "refine to an endless length": lambda: MADE.refine(maximum_length=Endless()),
    "refine with True points": lambda: MADE.refine(maximum_added=True),
    "refine with less than nothing": lambda: MADE.refine(maximum_added=-1),
    "refine with parts of a point": lambda: MADE.refine(maximum_added=1.5),
    "refine to too few sizes": lambda: MADE.refine(sizes=[1.0, 2.0]),
    "refine to a function's one size": lambda: MADE.refine(sizes=lambda xy: 1.0),
    "refine to sizes of text": lambda: MADE.refine(sizes=["a"] * 6),
    "refine to masked sizes": lambda: MADE.refine(sizes=MASKED[:, 0]),
    "refine what alpha left": lambda: delaunay(SQUARE, alpha=9.0).refine(),
    "refine what lengths left": lambda: delaunay(SQUARE, maximum_edge_length=9.0).refine(),
    "levels in a table": lambda: MADE.contours(VALUES, [[1.0, 2.0]]),
    "levels of text": lambda: MADE.contours(VALUES, ["a"]),
    "a level that is NaN": lambda: MADE.contours(VALUES, [1.0, np.nan]),
    "no level": lambda: MADE.contours(VALUES, []),
    "one level of bands": lambda: MADE.contours(VALUES, [1.0, 1.0], filled=True),
    "contours of rows": lambda: MADE.contours(np.zeros((6, 2)), [1.0]),
    "a radius of 0": lambda: MADE.alpha_shape(0),
    "a radius that is NaN": lambda: MADE.alpha_shape(np.nan),
    "points that were changed": changed,
    "edit of alpha and loops": lambda: delaunay(SQUARE, alpha=9.0, loops=[0, 1, 2]).edit(),
    "edit that was closed": edited(closed),
    "edit that was lost": edited(lost),
    "edit in space": edited(lambda edit: edit.insert([[5, 5, 5]])),
    "edit copied": edited(copy.copy),
    "edit: more ids than points": edited(lambda edit: edit.move([0, 1], [[5, 5]])),
    "edit: places in space": edited(lambda edit: edit.locate([[5, 5, 5]])),
    "edit: ids of text": edited(lambda edit: edit.remove(["a"])),
    "edit: parts of an id": edited(lambda edit: edit.remove([1.5])),
    "edit: ids in pairs": edited(lambda edit: edit.remove([[0, 1]])),
    "edit: segments one by one": edited(lambda edit: edit.constrain([0, 1])),
    "edit: an id that is no point's": edited(lambda edit: edit.remove([6])),
    "edit: an id above all": edited(lambda edit: edit.remove(np.array([2**63], np.uint64))),
    "raster like text": lambda: MADE.raster(like=OfGdal),
    "raster of GDAL with five numbers": lambda: MADE.raster(like=OfGdal(0, 1, 0, 0, 0)),
    "raster of GDAL that is turned": lambda: MADE.raster(like=OfGdal(0, 1, 0.5, 0, 0, -1)),
    "raster of xarray in one dimension": lambda: MADE.raster(like=OfXarray(x=[1, 2])),
    "raster of xarray with x first": lambda: MADE.raster(like=OfXarray(x=[1, 2], y=[1, 2])),
    "raster of xarray without coordinates": lambda: MADE.raster(like=OfXarray(y=None, x=[1, 2])),
    "raster of xarray that is uneven": lambda: MADE.raster(like=OfXarray(y=[1, 2], x=[1, 2, 4])),
    "file of another shape": lambda: CELLS.to_geotiff("none.tif", np.zeros((3, 2))),
    "file of text": lambda: CELLS.to_geotiff("none.tif", np.full((2, 3), "a")),
    "file without packages": written_without_packages,
    "file of an unknown system": lambda: _exchange.system_of(RASTERIO, "EPSG:0"),
    "file above 4 GiB": lambda: _geotiff.write("none.tif", np.broadcast_to(0.0, (25000, 25000)), (0, 0), (1, 1)),
    "simplify values with a source": lambda: WITH_SOURCE.simplify(1, values=np.arange(7.0)),
    "simplify by few weights": lambda: MADE.simplify(1, weights=VALUES[:5]),
    "simplify by pairs of weights": lambda: MADE.simplify(1, weights=SQUARE),
    "keep a few": lambda: MADE.simplify(1, keep=np.zeros(5, bool)),
    "keep numbers": lambda: delaunay(SQUARE, maximum_error=1, keep=VALUES),
    "keep masked": lambda: delaunay(SQUARE, maximum_error=1, keep=MASKED[:, 0]),
    "a masked skip": lambda: delaunay(SQUARE, skip=np.ma.masked_equal(np.zeros(6, bool), False)),
}
for k, (_, given, _) in enumerate(test_geometry.WRONG):
    CALLS["constraints %d" % k] = lambda given=given: delaunay(SQUARE, constraints=given)
CALLS.update({
    "scipy: furthest_site": lambda: scipy.Delaunay(SQUARE, furthest_site=True),
    "scipy: qhull_options": lambda: scipy.Delaunay(SQUARE, qhull_options="Qbb Qu"),
    "scipy: points on a line": lambda: scipy.Delaunay([[0, 0], [1, 1], [2, 2]]),
    "scipy: points in space": lambda: scipy.Delaunay(cloud(1, 6, 3)),
    "scipy: points of text": lambda: scipy.Delaunay([["a", "b"]]),
    "scipy: points that are not finite": lambda: scipy.griddata([[0, 0], [np.nan, 1], [1, np.inf]], [1, 2, 3], PLACE),
    "scipy: masked points": lambda: scipy.Delaunay(MASKED),
    "scipy: places in space": lambda: scipy.Delaunay(SQUARE).find_simplex([1, 2, 3]),
    "scipy: add_points": lambda: scipy.Delaunay(SQUARE).add_points(SQUARE),
    "scipy: rescaled triangulation": lambda: scipy.LinearNDInterpolator(scipy.Delaunay(SQUARE), VALUES, rescale=True),
    "scipy: too few values": lambda: scipy.LinearNDInterpolator(SQUARE, VALUES[:5]),
    "scipy: values of text": lambda: scipy.CloughTocher2DInterpolator(SQUARE, ["a"] * 6),
    "scipy: fill_value": lambda: scipy.LinearNDInterpolator(SQUARE, VALUES, 1j),
    "scipy: places of an interpolator": lambda: scipy.LinearNDInterpolator(SQUARE, VALUES)([1, 2, 3]),
    "scipy: bounding points": lambda: scipy.CloughTocher2DInterpolator(delaunay(SQUARE, bounding=True), VALUES),
    "scipy: another norm": lambda: scipy.NearestNDInterpolator(SQUARE, VALUES)(PLACE, p=1),
    "scipy: tree": lambda: scipy.NearestNDInterpolator(SQUARE, VALUES).tree,
    "scipy: method": lambda: scipy.griddata(SQUARE, VALUES, PLACE, "natural"),
    "scipy: one dimension": lambda: scipy.griddata(VALUES, VALUES, VALUES),
})  # fmt: skip
for k, (_, points, _) in enumerate(test_input.RefusedTest.POINTS):
    CALLS["points %d" % k] = lambda points=points: delaunay(points)
for k, (_, name, value, _) in enumerate(test_input.RefusedTest.KEYWORDS):
    if name not in ("memory_limit", "no_such"):  # all free memory; Python's own text
        CALLS["%s %d" % (name, k)] = lambda name=name, value=value: delaunay(SQUARE, **{name: value})


def refusal_of(call):
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", DelaunayWarning)
            call()
    except (AttributeError, ImportError, RuntimeError, TypeError, ValueError, MemoryError) as error:
        return "%s: %s" % (type(error).__name__, error)
    return "taken"


class RefusalsTest(unittest.TestCase):
    maxDiff = None

    @classmethod
    def setUpClass(cls):
        cls.found = {name: refusal_of(call) for name, call in CALLS.items()}
        # NumPy's text, which differs between its versions
        cls.found = {name: text for name, text in cls.found.items() if "inhomogeneous" not in text}
        if os.environ.get("AHD_WRITE_HASHES") == "1":
            FILE.write_text(json.dumps(cls.found, indent=1, ensure_ascii=False) + "\n", encoding="utf-8")

    def test_they_are_those(self):
        self.assertEqual(self.found, json.loads(FILE.read_text(encoding="utf-8")))
        self.assertNotIn("taken", self.found.values())

    def test_they_say_must(self):
        """For callers, in Python and in C++: neither "is to be" nor "has to be"."""
        found = [text for text in literals.said_in_cxx().split("\0") if NOT_MUST.search(text)]
        for path in sorted(literals.PYTHON.rglob("*.py")):
            tree = ast.parse(path.read_text(encoding="utf-8"))
            found += [(path.name, line, text) for line, text in literals.pieces_of(tree) if NOT_MUST.search(text)]
        self.assertEqual(found, [])

    def test_none_is_left_out(self):
        said = "\n".join(self.found.values())
        for name in MODULES:
            for line, piece in literals.pieces_of_refusals(name):
                self.assertTrue(piece in said or piece in INSIDE, (name, line, piece))


if __name__ == "__main__":
    unittest.main()
