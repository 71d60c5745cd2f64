# SPDX-License-Identifier: BSD-3-Clause
"""File > Save Data as a GeoTIFF: read again by GDAL (if installed; on CI it is), and by the tags."""

import importlib
import resource
import signal
import struct

from paraview import servermanager
from paraview.simple import *
from vtkmodules.vtkCommonCore import vtkOutputWindow, vtkStringOutputWindow
from vtkmodules.util.numpy_support import vtk_to_numpy

import numpy
from pluginsupport import *

LoadPlugin(PLUGIN, remote=False, ns=globals())


def raster(at=(500000.0, 4000000.0), **settings):
    """Of a triangle, so that there are cells without a value; not square."""
    points = [(at[0] + x, at[1] + y, z) for x, y, z in ((0, 0, 1), (4, 0, 2), (0, 6, 3))]
    given = XMLPolyDataReader(FileName=[write_vtp("triangle.vtp", points)])
    settings = dict({"RasterSize": "Cell Size", "CellSize": [1, 0.5]}, **settings)
    return AdaptiveHilbertInterpolation2D(Input=given, **settings)


def save(source, name="raster.tif", **settings):
    path = scratch(name)
    SaveData(path, proxy=source, **settings)
    return path


def rows_of(source, no_data):
    """As the file is to have them: the north first."""
    image = servermanager.Fetch(source)
    heights = vtk_to_numpy(image.GetPointData().GetArray("Elevation"))
    heights = numpy.where(numpy.isnan(heights), no_data, heights)
    return heights.reshape(image.GetDimensions()[1::-1])[::-1]


def tags_of(path):
    """(type, count, first four bytes of the value or its place) by tag."""
    with open(path, "rb") as file:
        content = file.read()
    check_equal(content[:8], b"II*\0\x08\0\0\0", "the first bytes")
    count = struct.unpack_from("<H", content, 8)[0]
    found = [struct.unpack_from("<HHII", content, 10 + 12 * k) for k in range(count)]
    check_equal([tag for tag, *_ in found], sorted(tag for tag, *_ in found), "the order of the tags")
    return content, {tag: rest for tag, *rest in found}


def test_place_and_values():
    source = raster()
    content, tags = tags_of(save(source, EPSG=32633))
    _, count, place = tags[33922]
    check_equal(struct.unpack_from("<%dd" % count, content, place), (0, 0, 0, 500000, 4000006, 0), "the upper corner")
    _, count, place = tags[273]
    offsets = struct.unpack_from("<%dI" % count, content, place)
    wanted = rows_of(source, -9999)
    check_equal(count, len(wanted), "rows")
    for offset, row in zip(offsets, wanted):
        check_equal(list(numpy.frombuffer(content, "<f8", len(row), offset)), list(row), "a row")
    check_equal(len(content), offsets[-1] + 8 * wanted.shape[1], "bytes")
    check((wanted == -9999).any(), "each cell has a value, so this test would prove nothing")


def test_degrees():
    """Also where cells that cover the points stick out beyond the pole."""
    for y, size, kind in ((83.9, 0.7, 2048), (83.9, 4, 2048), (85, 0.5, 3072), (-90, 0.5, 2048), (-91, 0.5, 3072)):
        content, tags = tags_of(save(raster((12.0, y), CellSize=[1, size]), EPSG=4326))
        keys = struct.unpack_from("<16H", content, tags[34735][2])
        check_equal(keys[12:], (kind, 0, 1, 4326), "the key of the system from %r in cells of %r" % (y, size))


def test_a_file_stays_until_the_new_one_is_whole():
    """As where the disk is full."""
    source, before, window = raster(CellSize=[0.01, 0.01]), vtkOutputWindow.GetInstance(), vtkStringOutputWindow()
    path = save(raster())
    with open(path, "rb") as file:
        old = file.read()
    source.UpdatePipeline()
    vtkOutputWindow.SetInstance(window)
    limit, action = resource.getrlimit(resource.RLIMIT_FSIZE), signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
    resource.setrlimit(resource.RLIMIT_FSIZE, (100000, limit[1]))
    save(source)
    resource.setrlimit(resource.RLIMIT_FSIZE, limit)
    signal.signal(signal.SIGXFSZ, action)
    vtkOutputWindow.SetInstance(before)
    check(window.GetOutput(), "nothing is said")
    check(tags_of(path)[0] == old, "the file before is another")
    check(not os.path.exists(path + ".part"), "a part is left")
    check(len(tags_of(save(source))[0]) > 100000, "with space, it is not replaced")


def test_gdal_reads_it():
    try:
        gdal, osr = importlib.import_module("osgeo.gdal"), importlib.import_module("osgeo.osr")
    except ImportError:
        check(os.environ.get("CI") != "true", "there is no GDAL")
        return
    for at, code, no_data, kind in (
        ((500000.0, 4000000.0), 32633, -9999.0, "IsProjected"), ((12.0, 47.0), 4326, -1.0, "IsGeographic"),
        ((12.0, 47.0), 0, -9999.0, None),
    ):  # fmt: skip
        source = raster(at)
        made = gdal.Open(save(source, EPSG=code, NoDataValue=no_data))
        check_equal(made.GetGeoTransform(), (at[0], 1, 0, at[1] + 6, 0, -0.5), "GDAL's place")
        band = made.GetRasterBand(1)
        check_equal((band.GetNoDataValue(), band.DataType), (no_data, gdal.GDT_Float64), "no data, and the type")
        pixels = numpy.frombuffer(band.ReadRaster(), float).reshape(made.RasterYSize, made.RasterXSize)
        check(numpy.array_equal(pixels, rows_of(source, no_data)), "the pixels that GDAL reads")
        check_equal(made.GetMetadataItem("AREA_OR_POINT"), "Area" if code else None, "what a pixel is")
        system = osr.SpatialReference(made.GetProjection()) if code else None
        found = (system.GetAuthorityCode(None), bool(getattr(system, kind)())) if code else made.GetProjection()
        check_equal(found, (str(code), True) if code else "", "the coordinate reference system")


def test_both_plugins_write_the_same():
    try:
        write = importlib.import_module("adaptivehilbertdelaunay._geotiff").write
    except ImportError:
        check(os.environ.get("AHD_EXPECT_PYTHON") != "1", "there is no package")
        return
    for code, no_data in ((32633, -9999.0), (0, 0.1)):
        source = raster()
        image = servermanager.Fetch(source)
        other = scratch("other.tif")
        write(other, rows_of(source, no_data)[::-1], image.GetOrigin()[:2], image.GetSpacing()[:2], code, no_data)
        check(tags_of(save(source, EPSG=code, NoDataValue=no_data))[0] == tags_of(other)[0], "the bytes of both")
    for kind, wanted in ((numpy.float32, FileNotFoundError), (numpy.float64, ValueError)):  # of 2 and 4 GiB
        try:
            write(scratch("no/such/folder.tif"), numpy.broadcast_to(kind(1), (22500, 24000)), (0, 0), (1, 1))
        except (OSError, ValueError) as error:
            check_equal(type(error), wanted, "540 million pixels of %s" % kind)


def test_other_arrays():
    """By name; floats stay such; hidden points have no value, whatever their numbers."""
    source = raster(Outside="Nearest Vertex")
    single = Calculator(Input=source, Function="7", ResultArrayName="seven", ResultArrayType="Float")
    content, tags = tags_of(save(single, ArrayName="seven"))
    pixels = numpy.frombuffer(content[-4 * 4 * 12:], "<f4")
    check_equal((tags[258][2], set(pixels)), (32, {7.0}), "bits and pixels")
    content, _ = tags_of(save(single, ArrayName="seven", NoDataValue=0.1))
    check(b"\0%.17g\0" % numpy.float32(0.1) in content, "the number for no data is none of floats")
    hiding = Calculator(Input=raster(), Function="7", ResultArrayName="seven")
    content, tags = tags_of(save(hiding, ArrayName="seven", NoDataValue=-1))
    wanted = numpy.where(rows_of(hiding, -9999) == -9999, -1, 7)
    check_equal(list(numpy.frombuffer(content[-8 * wanted.size:], "<f8")), list(wanted.ravel()), "with hidden points")


def test_what_cannot_be_written():
    """An error, and no file."""
    before, window = vtkOutputWindow.GetInstance(), vtkStringOutputWindow()
    vtkOutputWindow.SetInstance(window)
    for source, name, settings, said in (
        (Wavelet(), "volume.tif", {}, "one layer in x and y"),
        (raster(), "array.tif", {"ArrayName": "none"}, "no point array"),
        (raster(), "no/such/folder.tif", {}, "folder.tif"),
    ):  # fmt: skip
        path = save(source, name, **settings)
        check(said in window.GetOutput(), "%s: %r is not said, but %r" % (name, said, window.GetOutput()))
        check(not os.path.exists(path), "%s was written" % name)
    vtkOutputWindow.SetInstance(before)


for name, test in sorted(globals().items()):
    if name.startswith("test_"):
        test()
        print("passed:", name)
