# SPDX-License-Identifier: BSD-3-Clause
"""Rasters: of geotransforms and other rasters, north up, tiles, bounds in either order, and places that are nowhere.
With rasterio, GDAL and xarray: with_gis.py. Their numbers of cells: test_sampling.py, test_decimals.py.
"""

import unittest
from types import SimpleNamespace
from unittest import mock

import numpy as np
from adaptivehilbertdelaunay import (
    DelaunayWarning, LinearInterpolator, NearestInterpolator, Raster, _exchange, delaunay,
)
from arraysupport import KeywordTest, cloud

UTM = 1000 * cloud(71, 300) + (448000, 5411000)
MADE = delaunay(UTM)
HEIGHTS = UTM.sum(axis=1)


class RasterTest(KeywordTest):
    def test_from_geotransform(self):
        for place in ((10, 2, 0, 50, 0, -5), (10.0, 2.0, 0.0, 50.0, 0.0, 5.0), np.array([0.1, 0.3, 0, -7, 0, 0.7])):
            made = Raster.from_geotransform(place, (3, 4))
            np.testing.assert_allclose(made.geotransform, place, rtol=1e-15)
            self.assertEqual(made.shape, (3, 4))
        self.assertEqual(Raster.from_geotransform((10, 2, 0, 50, 0, -5), (3, 4)), Raster((11, 47.5), (2, -5), (3, 4)))

    def test_like(self):
        cells = Raster((1, 2), (3, -4), (5, 6))
        self.assertIs(Raster.like(cells), cells)
        self.assertIs(MADE.raster(like=cells), cells)

    def test_north_up(self):
        cells = MADE.raster(cell_size=20)
        turned = cells.north_up()
        self.assertEqual((turned.shape, turned.spacing), (cells.shape, (20, -20)))
        np.testing.assert_allclose(turned.bounds, cells.bounds, rtol=1e-15)
        np.testing.assert_allclose(turned.y, cells.y[::-1], rtol=1e-15)
        np.testing.assert_array_equal(turned.x, cells.x)
        self.assertIs(turned.north_up(), turned)
        south, north = (MADE.interpolate(HEIGHTS, one) for one in (cells, turned))
        np.testing.assert_allclose(north, south[::-1])
        self.assertEqual(Raster((0, 0), (1, 1), (0, 3)).north_up().shape, (0, 3))

    def test_tiles(self):
        for cells in (MADE.raster(cell_size=16), MADE.raster(cell_size=16).north_up()):
            whole = MADE.interpolate(HEIGHTS, cells)
            for part in (np.s_[:], np.s_[5:20], np.s_[5:20, 7:9], np.s_[:, 3:], np.s_[-4:, :-50], np.s_[9:9],
                         np.s_[2:999], np.s_[7:3, 0:1], np.s_[5:20:1]):  # fmt: skip
                tile = cells[part]
                wanted = whole[part]
                self.assertEqual(tile.shape, wanted.shape)
                if wanted.size:
                    np.testing.assert_allclose(MADE.interpolate(HEIGHTS, tile), wanted)

    def test_the_order_of_bounds(self):
        """Of shapely and rasterio: refused where the points tell."""
        for bounds in ((448100, 448900, 5411100, 5411900), (400000, 500000, 5400000, 5500000), (0, 1e7, 0, 1e7)):
            self.assertEqual(MADE.raster(shape=(2, 2), bounds=bounds).bounds, bounds)
        around = delaunay(10 * cloud(72) - 2)
        for bounds in ((0, 1, 5, 6), (-9, -7, 0, 9), (-1000, 1000, -1000, 1000)):
            self.assertEqual(around.raster(shape=(2, 2), bounds=bounds).bounds, bounds)  # it may be either
        for made, bounds in (
            (MADE, (448100, 5411100, 448900, 5411900)), (MADE, (447000, 5410000, 450000, 5412500)),
            (MADE, (448000, 5410000, 448010, 5412000)), (around, (0, 0, 5, 5)), (around, (0, 0, 5, 6)),
            (around, (2, 1, 3, 4)), (around, (1, 1, 1e5, 1e5 + 1)), (around, (-1, -1, 3, 8)),
        ):  # fmt: skip
            with self.assertRaisesRegex(ValueError, "but .* are xmin, ymin, xmax, ymax, as in shapely"):
                made.raster(cell_size=1, bounds=bounds)

    def test_bounds_of_what_has_an_area(self):
        wanted = MADE.raster(cell_size=50, bounds=(448100, 448900, 5411100, 5411900))
        ring = [(448100, 5411100), (448900, 5411200), (448500, 5411900), (448100, 5411100)]
        for area in (wanted, {"type": "Polygon", "coordinates": [ring]},
                     {"type": "LineString", "coordinates": ring[:3]},
                     {"type": "Feature", "geometry": {"type": "MultiPoint", "coordinates": ring}}):  # fmt: skip
            self.assertEqual(MADE.raster(cell_size=50, bounds=area), wanted)


class Gdal:
    """As much of osgeo.gdal as writes a file: keeps what it is given."""

    GDT_Byte, GDT_UInt16, GDT_Int16, GDT_UInt32, GDT_Int32, GDT_Float32, GDT_Float64 = "BHhIifd"
    __name__ = "osgeo.gdal"

    def GetDriverByName(self, name):
        return self

    def Create(self, path, columns, rows, count, kind, options):
        self.kind, self.written = kind, np.full((rows, columns, count), 99, kind)
        self.without = []
        return self

    def SetGeoTransform(self, place):
        self.place = place

    def GetRasterBand(self, band):
        def write(column, row, columns, rows, numbers):
            piece = np.frombuffer(numbers, self.kind).reshape(rows, columns)
            self.written[row : row + rows, column : column + columns, band - 1] = piece

        def read(column, row, columns, rows):
            self.read[row : row + rows, column : column + columns, band - 1] = True

        return SimpleNamespace(WriteRaster=write, ReadRaster=read, SetNoDataValue=lambda _: self.without.append(band))

    def UseExceptions(self):
        pass

    FlushCache = UseExceptions

    def OpenEx(self, path, open_options):
        self.read = np.zeros(self.written.shape, bool)
        return self


class OtherPackagesTest(unittest.TestCase):
    """Rasters like those of packages that are not needed for it, and what is given to one that writes."""

    def check(self, like, origin, spacing, shape):
        raster = Raster.like(like)
        self.assertEqual((raster.origin, raster.spacing, raster.shape), (origin, spacing, shape))

    def test_places(self):
        gdal = SimpleNamespace(RasterXSize=4, RasterYSize=3, GetGeoTransform=lambda: (100.0, 2.0, 0.0, 50.0, 0.0, -1.0))
        self.check(gdal, (101.0, 49.5), (2.0, -1.0), (3, 4))
        affine = SimpleNamespace(a=2.0, b=0.0, c=100.0, d=0.0, e=-1.0, f=50.0)
        self.check(SimpleNamespace(transform=affine, width=4, height=3), (101.0, 49.5), (2.0, -1.0), (3, 4))
        x, y = [1.0, 1.5, 2.0, 2.5], [9.0, 8.0, 7.0]
        self.check(SimpleNamespace(dims=("band", "y", "x"), coords={"x": x, "y": y}), (1.0, 9.0), (0.5, -1.0), (3, 4))
        table = SimpleNamespace(dims=("lon", "lat"), coords={"lon": x, "lat": y}, data_vars={})
        self.check(table, (1.0, 9.0), (0.5, -1.0), (3, 4))

    def test_files_of_gdal(self):
        gdal, raster = Gdal(), Raster((10, 20), (1, -1), (600, 3))
        for dtype, kind in (("int16", "h"), ("uint8", "B"), ("float32", "f"), ("int64", "d"), ("float16", "d")):
            values = (np.arange(3600) % 100).reshape(600, 3, 2).astype(dtype)
            with mock.patch.object(_exchange, "writer", lambda: gdal):
                raster.to_geotiff("none.tif", values)
            self.assertEqual(gdal.kind, kind)
            self.assertTrue((gdal.written == values).all())
            self.assertTrue(gdal.read.all())  # as GDAL may tell of no error before
            self.assertEqual(gdal.without, [1, 2] if kind in "fd" else [])
            self.assertEqual(gdal.place, (9.5, 1.0, 0.0, 20.5, 0.0, -1.0))

    def test_files_begin_in_the_north_west(self):
        values = np.arange(6.0).reshape(2, 3)
        for spacing, turned in (
            ((1, -1), values), ((1, 1), values[::-1]), ((-1, -1), values[:, ::-1]), ((-1, 1), values[::-1, ::-1])
        ):  # fmt: skip
            raster, written = Raster((10, 20), spacing, (2, 3)), []
            with mock.patch.object(_exchange, "writer", lambda: SimpleNamespace(__name__="osgeo.gdal")):
                with mock.patch.object(_exchange, "_by_gdal", lambda *given: written.append(given[1:])):
                    raster.to_geotiff("none.tif", values)
            (path, bands, place, crs), = written
            self.assertEqual((path, crs, bands.shape), ("none.tif", None, (2, 3, 1)))
            self.assertEqual(bands[:, :, 0].tolist(), turned.tolist())
            west, north = min(raster.x) - 0.5, max(raster.y) + 0.5
            self.assertEqual(place, (west, 1.0, 0.0, north, 0.0, -1.0))


class PlacesTest(KeywordTest):
    def test_x_and_y(self):
        """A tuple of two is that, even where each has two numbers."""
        for count in (1, 2, 3, 7):
            places = 800 * cloud(73, count) + (448100, 5411100)
            x, y = places.T
            wanted = places.sum(axis=1)
            for at in ((x, y), (x.tolist(), y.tolist()), (tuple(x), tuple(y)), places, places.tolist()):
                np.testing.assert_allclose(MADE.interpolate(HEIGHTS, at), wanted)
                np.testing.assert_array_equal(MADE.locate(at).triangle, MADE.locate(places).triangle)
                np.testing.assert_array_equal(MADE.weights(at).points, MADE.weights(places).points)
            np.testing.assert_allclose(MADE.interpolate(HEIGHTS, (x[:, None], y)), x[:, None] + y)
            np.testing.assert_allclose(MADE.interpolate(HEIGHTS, (x, 5411500)), x + 5411500)
        self.assertEqual(MADE.interpolate(HEIGHTS, (448500, 5411500)).shape, ())
        masked = np.ma.masked_less([448500, 0], 1)
        self.assertRaisesRegex(TypeError, "masked", MADE.interpolate, HEIGHTS, (masked, masked))

    def test_none_is_on_the_surface(self):
        nowhere = ([[0, 0]], ([0, 1], [0, 2]), [[0, 0], [np.nan, 0]], Raster((0, 0), (1, 1), (3, 3)), [0, 0])
        for at in nowhere:
            with self.assertWarnsRegex(DelaunayWarning, r"None of \d places? is on the surface .* points: x 44800"):
                self.assertTrue(np.isnan(MADE.interpolate(HEIGHTS, at)).all())
        with self.assertWarnsRegex(DelaunayWarning, "None of 9 places .* Places: x 0 to 2, y -8 to 0"):
            MADE.interpolate(HEIGHTS, Raster((0, 0), (1, -4), (3, 3)))
        with self.assertWarnsRegex(DelaunayWarning, "no finite|no triangle"):
            none = delaunay([[np.nan, 0]] * 3)
        with self.assertWarnsRegex(DelaunayWarning, "Places: x 0 to 0, y 0 to 0; points: nowhere"):
            none.interpolate(np.ones(3), [[0, 0]])

    def test_where_that_is_no_news(self):
        """The caller said what the value is, has a place on the surface, or none at all."""
        for at in ([[0, 0], [448500, 5411500]], [], [[np.nan, np.nan]], Raster((0, 0), (1, 1), (0, 5))):
            MADE.interpolate(HEIGHTS, at)
        for outside in (-1, "nearest", "boundary"):
            MADE.interpolate(HEIGHTS, [[0, 0]], outside=outside)
        for kind in (LinearInterpolator, NearestInterpolator):
            kind(MADE, HEIGHTS)(0, 0)
        holes = np.full(len(UTM), np.nan)
        MADE.interpolate(holes, [[448500, 5411500]])


if __name__ == "__main__":
    unittest.main()
