# SPDX-License-Identifier: BSD-3-Clause
"""A grid of heights as a GeoTIFF: Raster.to_geotiff() of the package, by rasterio or GDAL, whichever Python finds.

Pixel is area, the first row is the northernmost, cells without a height are NaN, which is the file's nodata value.
"""

import importlib.util
import os
import re

from pointfiles import InputError

HOW = "neither GDAL nor rasterio is here; apt install python3-gdal brings the first"


def _exchange():
    """The package's module, which is there before the package is built."""
    folder = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
    spec = importlib.util.spec_from_file_location("exchange", os.path.join(folder, "Filters", "Python", "_exchange.py"))
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


exchange = _exchange()


def writer():
    """"osgeo.gdal" or "rasterio", or None without either."""
    package = exchange.writer()
    return package and package.__name__


def check_crs(crs):
    """Raises InputError for a coordinate reference system that is none. Which codes there are is known where a file can
    be written."""
    if not re.fullmatch(r"EPSG:\d{1,9}", crs, re.IGNORECASE):
        raise InputError("--crs takes a code such as EPSG:32633, not %s" % crs)
    package = exchange.writer()
    try:
        if package is not None:
            exchange.system_of(package, _number(crs))
    except ValueError as error:
        raise InputError("--%s" % " ".join(str(error).split())) from error


def _number(crs):
    return int(crs.split(":")[1])


def write(path, heights, origin, spacing, crs=None):
    """Writes rows of heights, the first one the southernmost, of cells that have this spacing; `origin`: the centre of
    the first. Requires: writer(). OSError."""
    from adaptivehilbertdelaunay import Raster

    try:
        Raster(origin, spacing, heights.shape).to_geotiff(path, heights, _number(crs) if crs else None)
    except Exception as error:  # of whatever kind the library has for it
        raise OSError("%s could not be written: %s" % (path, " ".join(str(error).split()))) from error
