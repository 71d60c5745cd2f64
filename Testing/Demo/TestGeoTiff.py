# SPDX-License-Identifier: BSD-3-Clause
"""The demo's GeoTIFFs, written by GDAL and by rasterio, if installed; the message without them. In a file that is read
again: the places of pixels, nodata, the coordinate system."""

import contextlib
import importlib
import math
import os
import sys
import tempfile
import unittest
from unittest import mock

import numpy

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Plugin", "Demo"))

import geotiff
from pointfiles import InputError

CORNER, CELL = (500000.0, -40.5), (2.0, 0.25)
ORIGIN = (500001.0, -40.375)
ON_CI = os.environ.get("CI") == "true"  # has GDAL


def has(*modules):
    """Imports these, so that no test does it first while others are hidden."""
    try:
        return bool([importlib.import_module(name) for name in modules])
    except ImportError:
        return False


HAS_GDAL = has("osgeo.gdal", "osgeo.osr") or ON_CI
HAS_RASTERIO = has("rasterio", "rasterio.crs", "rasterio.windows")


def heights():
    """More rows than are written at a time, and cells without a height in two corners."""
    made = numpy.arange(600 * 37, dtype=float).reshape(600, 37) / 3.0
    made[0, 0] = made[599, 36] = math.nan
    return made


@contextlib.contextmanager
def without(*packages):
    """As if these were not installed."""
    hidden = {name: None for name in sys.modules if name.split(".")[0] in packages}
    with mock.patch.dict(sys.modules, {**hidden, **dict.fromkeys(packages)}):
        yield


class Written(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = os.path.join(folder.name, "heights.tif")

    def check_by_gdal(self, code):
        from osgeo import gdal

        gdal.UseExceptions()
        found = gdal.Open(self.path)
        self.assertEqual((found.RasterXSize, found.RasterYSize, found.RasterCount), (37, 600, 1))
        self.assertEqual(found.GetGeoTransform(), (500000.0, 2.0, 0.0, -40.5 + 600 * 0.25, 0.0, -0.25))
        self.assertEqual(found.GetMetadataItem("AREA_OR_POINT"), "Area")
        band = found.GetRasterBand(1)
        self.assertTrue(math.isnan(band.GetNoDataValue()))
        numbers = numpy.frombuffer(band.ReadRaster(), numpy.float64).reshape(600, 37)
        numpy.testing.assert_array_equal(numbers, heights()[::-1])
        self.assertEqual('ID["EPSG",%d]]' % code in found.GetSpatialRef().ExportToWkt(["FORMAT=WKT2"]), True)

    def check_by_rasterio(self, code):
        import rasterio

        with rasterio.open(self.path) as found:
            self.assertEqual((found.bounds.left, found.bounds.bottom), CORNER)
            self.assertEqual((found.bounds.right, found.bounds.top), (500074.0, 109.5))
            self.assertEqual((found.crs.to_epsg(), found.tags()["AREA_OR_POINT"]), (code, "Area"))
            self.assertTrue(math.isnan(found.nodata))
            numpy.testing.assert_array_equal(found.read(1), heights()[::-1])

    @unittest.skipUnless(HAS_GDAL, "no GDAL for Python")
    def test_by_gdal(self):
        with without("rasterio"):
            self.assertEqual(geotiff.writer(), "osgeo.gdal")
            geotiff.check_crs("EPSG:32633")
            with self.assertRaisesRegex(InputError, "--crs: 99999999 is not known: .*not found"):
                geotiff.check_crs("EPSG:99999999")
            geotiff.write(self.path, heights(), ORIGIN, CELL, "EPSG:32633")
        self.check_by_gdal(32633)
        with self.assertRaisesRegex(OSError, "could not be written: .*[Dd]irectory"):
            geotiff.write(os.path.join(self.path, "no", "a.tif"), heights(), ORIGIN, CELL)

    @unittest.skipUnless(HAS_RASTERIO, "no rasterio")
    def test_by_rasterio(self):
        with without("osgeo"):
            self.assertEqual(geotiff.writer(), "rasterio")
            geotiff.check_crs("epsg:4326")
            with self.assertRaisesRegex(InputError, "--crs: 99999999 is not known: .*not found"):
                geotiff.check_crs("EPSG:99999999")
            geotiff.write(self.path, heights(), ORIGIN, CELL, "epsg:4326")
        self.check_by_rasterio(4326)
        with self.assertRaisesRegex(OSError, "could not be written: .*[Dd]irectory"):
            geotiff.write(os.path.join(self.path, "no", "a.tif"), heights(), ORIGIN, CELL)

    @unittest.skipUnless(HAS_GDAL, "no GDAL for Python")
    def test_without_a_coordinate_reference_system(self):
        from osgeo import gdal

        geotiff.write(self.path, heights(), ORIGIN, CELL)
        self.assertEqual(gdal.Open(self.path).GetProjection(), "")


class NotWritten(unittest.TestCase):
    def test_without_gdal_and_rasterio(self):
        with without("osgeo", "rasterio"):
            self.assertIsNone(geotiff.writer())
            geotiff.check_crs("EPSG:32633")

    def test_systems_that_are_none(self):
        for crs in ("32633", "EPSG:", "EPSG:1x", "/etc/passwd", "EPSG:32633 "):
            with self.assertRaisesRegex(InputError, "takes a code such as EPSG:32633"):
                geotiff.check_crs(crs)


if __name__ == "__main__":
    unittest.main()
