# SPDX-License-Identifier: BSD-3-Clause
"""A grid of heights as a GeoTIFF, by GDAL or rasterio, whichever Python finds.

Pixel is area, the first row is the northernmost, cells without a height are NaN, which is the file's nodata value.
"""

import re

import numpy

from pointfiles import InputError

HOW = "neither GDAL nor rasterio is here; apt install python3-gdal brings the first"
ROWS = 256  # that are turned and written at a time
OPTIONS = {"COMPRESS": "DEFLATE", "PREDICTOR": "3", "TILED": "YES", "BIGTIFF": "IF_SAFER"}


def writer():
    """"gdal" or "rasterio", or None without either."""
    try:
        from osgeo import gdal, osr  # noqa: F401 (is it there?)

        return "gdal"
    except ImportError:
        pass
    try:
        import rasterio  # noqa: F401 (is it there?)

        return "rasterio"
    except ImportError:
        return None


def check_crs(crs):
    """Raises InputError for a coordinate reference system that is none. Which codes there are is known where a file can
    be written."""
    if not re.fullmatch(r"EPSG:\d{1,9}", crs, re.IGNORECASE):
        raise InputError("--crs takes a code such as EPSG:32633, not %s" % crs)
    try:
        {"gdal": _gdal_crs, "rasterio": _rasterio_crs, None: str}[writer()](crs)
    except Exception as error:  # of whatever kind the library has for it
        raise InputError("--crs: %s is not known: %s" % (crs, " ".join(str(error).split()))) from error


def write(path, heights, corner, cell, crs=None):
    """Writes rows of heights, the first one the southernmost, of cells of this width and height; `corner` is the lower
    left one of all. Requires: writer(). OSError."""
    rows, columns = heights.shape
    place = (corner[0], cell[0], 0.0, corner[1] + rows * cell[1], 0.0, -cell[1])
    pieces = ((row, numpy.ascontiguousarray(heights[::-1][row:row + ROWS])) for row in range(0, rows, ROWS))
    try:
        {"gdal": _with_gdal, "rasterio": _with_rasterio}[writer()](path, (columns, rows), place, crs, pieces)
    except Exception as error:  # of whatever kind the library has for it
        raise OSError("%s could not be written: %s" % (path, " ".join(str(error).split()))) from error


def _gdal_crs(crs):
    from osgeo import osr

    osr.UseExceptions()
    system = osr.SpatialReference()
    system.ImportFromEPSG(int(crs.split(":")[1]))
    return system.ExportToWkt()


def _with_gdal(path, size, place, crs, pieces):
    from osgeo import gdal

    gdal.UseExceptions()
    options = ["%s=%s" % option for option in OPTIONS.items()]
    made = gdal.GetDriverByName("GTiff").Create(path, *size, 1, gdal.GDT_Float64, options)
    made.SetGeoTransform(place)
    if crs:
        made.SetProjection(_gdal_crs(crs))
    band = made.GetRasterBand(1)
    band.SetNoDataValue(float("nan"))
    for row, piece in pieces:  # as bytes: GDAL's arrays need the NumPy that it was built with
        band.WriteRaster(0, row, size[0], len(piece), piece.astype(numpy.float64).tobytes())
    made.FlushCache()


def _rasterio_crs(crs):
    from rasterio.crs import CRS

    return CRS.from_epsg(int(crs.split(":")[1]))


def _with_rasterio(path, size, place, crs, pieces):
    import rasterio
    from rasterio.windows import Window

    form = dict(
        driver="GTiff", width=size[0], height=size[1], count=1, dtype="float64", nodata=float("nan"),
        transform=rasterio.Affine.from_gdal(*place), crs=_rasterio_crs(crs) if crs else None,
        **{name.lower(): value for name, value in OPTIONS.items()})  # fmt: skip
    with rasterio.open(path, "w", **form) as made:
        for row, piece in pieces:
            made.write(piece.astype(numpy.float64), 1, window=Window(0, row, size[0], len(piece)))
