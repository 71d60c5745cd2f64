# SPDX-License-Identifier: BSD-3-Clause
"""A surface as a raster of heights: a .vti, whose points are the centres of the cells, and a GeoTIFF."""

import math
import time

import numpy

import geotiff
from pointfiles import METRES_PER_DEGREE, InputError, are_degrees, thousands

ENDINGS = (".vti", ".tif")
FEW = 10  # cells along the longer side
METHODS = {"linear": "Linear", "natural": "NaturalNeighbor", "laplace": "Laplace", "nearest": "Nearest"}


def add_options(parser):
    parser.add_argument("--raster", type=float, metavar="CELL")
    parser.add_argument("--method", choices=tuple(METHODS))
    parser.add_argument("--crs", metavar="EPSG:CODE")


def check(chosen, parser):
    if chosen.raster is None:
        if chosen.method or chosen.crs is not None:
            parser.error("--method and --crs are for --raster")
        return
    if not (chosen.raster > 0 and math.isfinite(chosen.raster)):
        parser.error("--raster must be greater than 0 and finite")
    if chosen.crs is not None:
        geotiff.check_crs(chosen.crs)


def check_unit(points, cell):
    """What to tell where cells are few. InputError for degrees of half the extent or more: metres were meant."""
    places = points.xyz[numpy.isfinite(points.xyz[:, :2]).all(axis=1), :2]
    if not len(places):
        return []
    (west, south), (east, north) = places.min(axis=0), places.max(axis=0)
    width, height = east - west, north - south
    if not 0 < max(width, height) < FEW * cell:
        return []
    degrees = are_degrees(points.names, south, north)
    size = math.sqrt(width) * math.sqrt(height) / math.sqrt(len(places)) or max(width, height) / FEW
    said = "--raster %g is in %s, and x and y span %.3g × %.3g; for about a point in a cell: --raster %.1g" % (
        cell, "degrees, the unit of x and y" if degrees else "the unit of x and y", width, height, size)
    if degrees and max(width, height) <= 2 * cell:
        raise InputError("%s (%g m are about %.2g degrees)" % (said, cell, cell / METRES_PER_DEGREE))
    return ["few cells: " + said]


def results(chosen, stem):
    """The files that are written, the second one where that is possible."""
    return () if chosen.raster is None else tuple(stem + ending for ending in ENDINGS)


def make(surface, cell, method):
    """The raster of a surface that the filter made, and how long it took. The borders of its cells are multiples of
    their size, so that rasters of several files fit."""
    from adaptivehilbertdelaunay import vtkAdaptiveHilbertInterpolation2D

    algorithm = vtkAdaptiveHilbertInterpolation2D()
    algorithm.SetInputData(surface)
    algorithm.SetRasterSizeToByCellSize()
    algorithm.SetCellSize(cell, cell)
    algorithm.AlignToCellSizeOn()
    getattr(algorithm, "SetMethodTo" + METHODS[method])()
    started = time.monotonic()
    algorithm.Update()
    made = algorithm.GetOutputDataObject(0)
    if made.GetNumberOfPoints() == 0:
        raise InputError("no raster of cells of %r was made; its reason is above" % cell)
    return made, algorithm, time.monotonic() - started


def heights_of(image):
    """Rows of an image's heights, the first one the southernmost."""
    from paraview.vtk.util.numpy_support import vtk_to_numpy

    columns, rows, _ = image.GetDimensions()
    return vtk_to_numpy(image.GetPointData().GetArray("Elevation")).reshape(rows, columns)


def save(image, path):
    from vtkmodules.vtkIOXML import vtkXMLImageDataWriter

    writer = vtkXMLImageDataWriter()
    writer.SetFileName(path)
    writer.SetInputData(image)
    writer.SetDataModeToBinary()  # not appended, see appended_data_hint
    writer.Write()


def run(surface, chosen, paths):
    """Writes the files, tells of them and gives their names. OSError, InputError."""
    method = chosen.method or "linear"
    image, algorithm, seconds = make(surface, chosen.raster, method)
    heights = heights_of(image)
    valued = int(numpy.isfinite(heights).sum())
    print("Raster   %s × %s cells of %g, %s, %.1f %% of them with a height, in %.3f s" % (
        thousands(heights.shape[1]), thousands(heights.shape[0]), chosen.raster, method,
        100.0 * valued / heights.size, seconds))  # fmt: skip
    save(image, paths[0])
    print("         %s" % paths[0])
    if not geotiff.writer():
        print("         no GeoTIFF: %s" % geotiff.HOW)
        return paths[:1]
    geotiff.write(paths[1], heights, image.GetOrigin()[:2], image.GetSpacing()[:2], chosen.crs)
    told = chosen.crs or "without a coordinate reference system; --crs EPSG:CODE gives it one"
    print("         %s (%s)" % (paths[1], told))
    return paths
