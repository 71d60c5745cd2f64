# SPDX-License-Identifier: BSD-3-Clause
"""Packages by which others bring geometries, tables and rasters: shapely, pandas, geopandas, rasterio, GDAL, xarray.
Debian 12 has shapely 1.8, PyPI 2. Skipped (exit code 77) where one of them is missing, which is named.
"""

import contextlib
import importlib.util
import os
import sys
import tempfile
import unittest
import unittest.mock
import warnings

import numpy as np
from adaptivehilbertdelaunay import LinearInterpolator, Raster, delaunay
from arraysupport import KeywordTest, cloud
from test_geometry import area

import literals  # (arraysupport has put its folder on the path)

NEEDED = ("geopandas", "osgeo", "pandas", "rasterio", "shapely", "xarray")
POINTS = 10 * cloud(62, 500)


class GeometryTest(KeywordTest):
    def setUp(self):
        super().setUp()
        warnings.filterwarnings("ignore", category=DeprecationWarning)  # of the packages themselves

    def test_shapely(self):
        from shapely import geometry, wkt

        ring = geometry.Point(5, 5).buffer(3).difference(geometry.Point(5, 5).buffer(1))
        corner = geometry.box(8.2, 8.2, 9, 9)
        for given in (ring, geometry.MultiPolygon([ring, corner]), [ring, corner], geometry.GeometryCollection([ring])):
            wanted = sum(one.area for one in given) if isinstance(given, list) else given.area
            made = delaunay(POINTS, constraints=given)
            self.assertAlmostEqual(area(made), wanted, places=6)
            values = made.interpolate(POINTS.sum(axis=1), [[5, 7.5], [5, 5]])
            np.testing.assert_allclose(values, [12.5, np.nan])
        made = delaunay(POINTS, constraints=wkt.loads("LINESTRING Z (1 1 5, 9 9 6)"))
        self.assertEqual(made.points[-2:].tolist(), [[1, 1, 5], [9, 9, 6]])
        made = delaunay(POINTS, constraints=geometry.LinearRing(corner.exterior.coords))
        self.assertAlmostEqual(area(made), corner.area, places=6)
        whole = delaunay(POINTS).triangles
        for empty in (geometry.Polygon(), geometry.MultiPolygon(), geometry.Point(), geometry.GeometryCollection()):
            np.testing.assert_array_equal(delaunay(POINTS, constraints=empty).triangles, whole)

    def test_as_a_clip_of_voronoi_cells(self):
        from shapely import geometry

        for shape in (geometry.box(1, 2, 8, 9), geometry.Point(5, 5).buffer(3)):
            cells = delaunay(POINTS).voronoi(shape)
            found = sum(geometry.Polygon(cell).area for cell in cells if len(cell))
            self.assertAlmostEqual(found, shape.area, places=9)
        with self.assertRaisesRegex(ValueError, "clip must be one polygon without holes, but there are 2 rings"):
            delaunay(POINTS).voronoi(geometry.Point(5, 5).buffer(3).difference(geometry.Point(5, 5).buffer(1)))

    def test_polygons_and_lines_out(self):
        """Valid ones; bands meet only at their borders and cover the surface, lines are where bands meet."""
        import geopandas
        from shapely import geometry, ops

        lake = geometry.Point(5, 5).buffer(4).difference(geometry.Point(5, 5).buffer(1))
        made = delaunay(POINTS, constraints=lake)
        levels = [-np.inf, 0.6, 0.9, 1.2, np.inf]
        waves = 1 + np.sin(POINTS[:, 0]) * np.cos(POINTS[:, 1])
        bands = made.contours(waves, levels, filled=True)
        shapes = [geometry.shape(band) for band in bands]
        self.assertTrue(all(shape.is_valid for shape in shapes))
        self.assertGreater(sum(len(one.interiors) for shape in shapes for one in shape.geoms), 0)
        self.assertAlmostEqual(sum(shape.area for shape in shapes), area(made), places=9)
        self.assertAlmostEqual(ops.unary_union(shapes).area, area(made), places=6)
        table = geopandas.GeoDataFrame.from_features(bands, crs="EPSG:32633")
        self.assertEqual([list(table.lower[1:]), list(table.upper[:-1])], [levels[1:-1]] * 2)
        self.assertTrue(np.isnan([table.lower[0], table.upper[3]]).all())  # no numbers, in JSON
        lines = made.contours(waves, levels[1:-1])
        table = geopandas.GeoDataFrame.from_features(lines)
        self.assertEqual(list(table.level), levels[1:-1])
        for filled in (False, True):  # of no height
            table_of_none = geopandas.GeoDataFrame.from_features(made.contours(waves, [7, 8], filled))
            self.assertTrue(table_of_none.geometry.is_empty.all() and len(table_of_none) == 2 - filled)
        for k, line in enumerate(table.geometry):
            common = shapes[k].intersection(shapes[k + 1])
            self.assertAlmostEqual(line.length, common.length, places=6)
        outline = geometry.shape(made.outline())
        self.assertTrue(outline.is_valid)
        for radius in (0.3, 0.5):
            shape = geometry.shape(made.alpha_shape(radius))
            self.assertTrue(shape.is_valid and 1 < shape.area < outline.area)
        cells = geopandas.GeoDataFrame.from_features(made.voronoi("bounds"))
        self.assertTrue(cells.geometry.is_valid.all())
        self.assertEqual(list(cells.site), made.voronoi("bounds").sites.tolist())

    def test_a_union_is_kept_whole(self):
        """As the documentation advises for polygons that overlap."""
        from shapely import geometry, ops

        parts = [geometry.box(1, 1, 5, 5), geometry.box(3, 3, 8, 8)]
        self.assertAlmostEqual(area(delaunay(POINTS, constraints=ops.unary_union(parts))), 16 + 25 - 4, places=6)

    def test_geopandas(self):
        import geopandas
        from shapely import geometry

        shapes = [geometry.box(1, 1, 4, 4), geometry.box(4, 1, 6, 3), geometry.Polygon(), None]
        table = geopandas.GeoDataFrame({"name": list("abcd")}, geometry=shapes)
        for given in (table, table.geometry, table.geometry.values, table.geometry.tolist()):
            self.assertAlmostEqual(area(delaunay(POINTS, constraints=given)), 9 + 4, places=6)


class TableTest(KeywordTest):
    def test_data_frames(self):
        """Columns by their names, in any order, or all of a frame of two or three."""
        import pandas

        table = pandas.DataFrame({"Z": POINTS.sum(axis=1), "y": POINTS[:, 1], "name": "a", "x": POINTS[:, 0]})
        made = delaunay(table)
        np.testing.assert_array_equal(made.points, np.c_[POINTS, POINTS.sum(axis=1)])
        places = pandas.DataFrame({"y": [5.0, 6], "x": [4.0, 4], "z": [0, 0]})
        np.testing.assert_allclose(made.interpolate(table["Z"], places), [9, 10])
        np.testing.assert_allclose(LinearInterpolator(table, table["Z"])(places), [9, 10])
        lonlat = pandas.DataFrame(POINTS, columns=["lon", "lat"])
        np.testing.assert_array_equal(delaunay(lonlat).points, POINTS)
        with self.assertRaisesRegex(ValueError, r"not \(500, 4\): name its columns x, y and z"):
            delaunay(table.rename(columns={"x": "east"}))

    def test_geopandas(self):
        import geopandas

        points = geopandas.GeoDataFrame(geometry=geopandas.points_from_xy(*POINTS.T))
        with self.assertRaisesRegex(ValueError, r"take .get_coordinates\("):
            delaunay(points)
        if hasattr(points, "get_coordinates"):  # not in Debian 12
            np.testing.assert_array_equal(delaunay(points.get_coordinates()).points, POINTS)


class RasterTest(KeywordTest):
    CELLS = Raster((448010.5, 5411020.25), (21, 40.5), (30, 20))

    def setUp(self):
        super().setUp()
        warnings.filterwarnings("ignore", category=DeprecationWarning)
        warnings.filterwarnings("ignore", category=FutureWarning)  # GDAL's, about UseExceptions
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = os.path.join(folder.name, "heights.tif")

    def values(self, *more):
        made = np.random.default_rng(5).random((*self.CELLS.shape, *more))
        made[:3, :5] = np.nan
        return made

    def read(self):
        """The bands, northernmost row first, the data set's raster and its profile."""
        import rasterio

        with rasterio.open(self.path) as found:
            self.assertEqual(Raster.like(found), delaunay(POINTS).raster(like=found))
            return found.read(), Raster.like(found), found.profile

    def test_geotiff(self):
        """By rasterio, and by GDAL where that is not there, from rows that run either way."""
        import rasterio

        system = rasterio.crs.CRS.from_epsg(32633)
        for hidden in ((), ("rasterio",)):
            with unittest.mock.patch.dict(sys.modules, dict.fromkeys(hidden)):
                for cells in (self.CELLS, self.CELLS.north_up()):
                    for values, crs in ((self.values(), "EPSG:32633"), (self.values(3).astype(np.float32), system),
                                        (np.arange(600, dtype=np.int16).reshape(30, 20), 32633),
                                        (np.arange(600).reshape(30, 20), system.to_wkt())):  # fmt: skip
                        cells.to_geotiff(self.path, values, crs)
                        found, raster, profile = self.read_again()
                        wanted = values[::-1] if cells is self.CELLS else values
                        wanted = wanted[None] if wanted.ndim == 2 else np.moveaxis(wanted, 2, 0)
                        np.testing.assert_array_equal(found, wanted)
                        self.assertEqual(profile["dtype"], "float64" if values.dtype == int else values.dtype)
                        self.assertTrue(profile["nodata"] is None or np.isnan(profile["nodata"]))
                        self.assertEqual(profile["crs"].to_epsg(), 32633)
                        self.assertEqual(raster, self.CELLS.north_up())
                cells.to_geotiff(self.path, self.values())
                self.assertIsNone(self.read_again()[2]["crs"])

    def test_geotiff_on_a_full_disk(self):
        """Is told, wherever the room ends: rasterio alone is silent of what fails while a file is closed."""
        import resource

        self.CELLS.to_geotiff(self.path, self.values())
        size, limits = os.path.getsize(self.path), resource.getrlimit(resource.RLIMIT_FSIZE)
        for hidden in ((), ("rasterio",)):
            for room in (0, 100, size // 2, size - 1):
                os.remove(self.path)
                with self.subTest(hidden=hidden, room=room), \
                        unittest.mock.patch.dict(sys.modules, dict.fromkeys(hidden)):
                    resource.setrlimit(resource.RLIMIT_FSIZE, (room, limits[1]))
                    try:
                        self.assertRaises(OSError, self.CELLS.to_geotiff, self.path, self.values())
                    finally:
                        resource.setrlimit(resource.RLIMIT_FSIZE, limits)

    def read_again(self):
        with unittest.mock.patch.dict(sys.modules):
            for name in [name for name, module in sys.modules.items() if module is None]:
                del sys.modules[name]
            return self.read()

    def test_data_sets(self):
        """Rows from east to west and to the north, too; turned ones are refused."""
        import rasterio
        from osgeo import gdal

        self.CELLS.to_geotiff(self.path, self.values())
        with rasterio.open(self.path) as found:
            self.assertEqual(Raster.like(gdal.Open(self.path)), Raster.like(found))
            self.assertEqual(Raster.from_geotransform(found.transform, found.shape), Raster.like(found))
            self.assertEqual(delaunay(POINTS).raster(shape=(3, 4), bounds=found.bounds).bounds, self.CELLS.bounds)
        turned = rasterio.Affine.rotation(30)
        self.assertRaisesRegex(ValueError, "along the axes", Raster.from_geotransform, turned, (3, 3))

    def test_xarray(self):
        for cells in (self.CELLS, self.CELLS.north_up(), Raster((7, 47), (-0.1, 0.3), (4, 3))):
            values = np.arange(float(np.prod(cells.shape))).reshape(cells.shape)
            made = cells.to_xarray(values, "heights")
            self.assertEqual((made.dims, made.name), (("y", "x"), "heights"))
            for same in (made, made.to_dataset(), made.expand_dims(time=3), made.rename(y="lat", x="lon"),
                         made.rename(y="lat", x="lon").to_dataset().transpose()):  # fmt: skip
                found = Raster.like(same)
                self.assertEqual(found.shape, cells.shape)
                np.testing.assert_allclose(found.geotransform, cells.geotransform, rtol=1e-13)
            self.assertEqual(float(made.sel(y=cells.y[2], x=cells.x[1])), values[2, 1])
        self.assertEqual(self.CELLS.to_xarray(self.values(3)).dims, ("y", "x", "band"))
        points = POINTS * 40 + self.CELLS.origin
        raster = delaunay(points).raster(like=self.CELLS.to_xarray(self.values()))
        self.assertEqual(delaunay(points).interpolate(points[:, 0], raster, outside=0).shape, (30, 20))
    def test_refusals(self):
        """Each text that the module raises."""
        import xarray

        uneven = xarray.DataArray(np.zeros((3, 3)), dims=("y", "x"), coords={"y": [0, 1, 3], "x": [0, 1, 2]})
        cells, values, like = self.CELLS, self.values(), Raster.like
        hidden = unittest.mock.patch.dict(sys.modules, {"rasterio": None, "osgeo": None, "osgeo.gdal": None})
        gdal_alone = unittest.mock.patch.dict(sys.modules, {"rasterio": None})
        said = []
        for kind, text, call, around in (
            (ValueError, "'y': the coordinates are not evenly spaced", lambda: like(uneven), None),
            (ValueError, "'y': .* needs two coordinates or more", lambda: like(uneven[:1]), None),
            (ValueError, "'x': .* needs two coordinates or more", lambda: like(uneven[:2].drop_vars("x")), None),
            (ValueError, r"two dimensions, y and x, not \('x',\)", lambda: like(uneven[0]), None),
            (ValueError, r"take .transpose\(..., 'y', 'x'\)", lambda: like(uneven.T), None),
            (TypeError, "a raster can be like .* not like int", lambda: like(7), None),
            (ValueError, "geotransform must be", lambda: Raster.from_geotransform(range(5), (1, 1)), None),
            (ValueError, "along the axes", lambda: Raster.from_geotransform((0, 1, 1, 0, 0, 1), (1, 1)), None),
            (ValueError, r"of the raster, \(30, 20\), not \(20, 30\)", lambda: cells.to_xarray(values.T), None),
            (ValueError, "values must be real", lambda: cells.to_geotiff(self.path, values.astype(str)), None),
            (ImportError, "needs rasterio or GDAL", lambda: cells.to_geotiff(self.path, values), hidden),
            (ValueError, "crs: 'EPSG:1' is not", lambda: cells.to_geotiff(self.path, values, "EPSG:1"), None),
            (ValueError, "crs: 'EPSG:1' is not", lambda: cells.to_geotiff(self.path, values, "EPSG:1"), gdal_alone),
            (OSError, "/no", lambda: cells.to_geotiff(self.path + "/no.tif", values), None),
            (OSError, "/no.tif: ", lambda: cells.to_geotiff(self.path + "/no.tif", values), gdal_alone),
        ):  # fmt: skip
            with around or contextlib.nullcontext(), self.assertRaisesRegex(kind, text) as caught:
                call()
            said.append(str(caught.exception))
        for line, piece in literals.pieces_of_refusals("_exchange.py"):
            self.assertIn(piece, "\n".join(said), line)

    def test_bounds_of_geometries(self):
        import geopandas
        from shapely import geometry

        box = geometry.box(2, 3, 5, 7)
        made = delaunay(POINTS)
        for given in (box, geopandas.GeoSeries([box, geometry.Point(3, 4)]), geometry.MultiPolygon([box])):
            self.assertEqual(made.raster(cell_size=1, bounds=given).bounds, (2, 5, 3, 7))
        with self.assertRaisesRegex(ValueError, "as in shapely and rasterio"):
            made.raster(cell_size=1, bounds=geometry.box(2, 1, 3, 7).bounds)


if __name__ == "__main__":
    missing = [name for name in NEEDED if importlib.util.find_spec(name) is None]
    if missing:
        print("skipped: there is no %s here" % " and no ".join(missing))
        sys.exit(77)
    unittest.main()
