# SPDX-License-Identifier: BSD-3-Clause
"""Rasters of other packages, and files: rasterio, GDAL, xarray. None of them is needed before it is asked for."""

from __future__ import annotations

import importlib
import math
import os
from typing import TYPE_CHECKING, Any, Dict, Iterator, NamedTuple, Sequence, Tuple

import numpy as np

if TYPE_CHECKING:
    from ._raster import Raster

Places = Tuple[Tuple[float, float], Tuple[float, float]]  # origin and spacing

_ROWS = 256  # that are turned and written at a time


def places_of(geotransform: Any) -> Places:
    """Of GDAL's six numbers, or of an Affine. ValueError."""
    if all(hasattr(geotransform, name) for name in "abcdef"):
        given = tuple(getattr(geotransform, name) for name in "cabfde")
    else:
        given = tuple(geotransform) if hasattr(geotransform, "__iter__") else ()
    if len(given) != 6:
        raise ValueError("geotransform must be six numbers in GDAL's order or an affine.Affine, not %r" % (
            geotransform,))  # fmt: skip
    x, dx, turnX, y, turnY, dy = map(float, given)
    if turnX or turnY:
        raise ValueError("geotransform: rows and columns must run along the axes, but %r turns them" % (geotransform,))
    return (x + dx / 2, y + dy / 2), (dx, dy)


def raster_of(given: Any) -> Tuple[Tuple[float, float], Tuple[float, float], Tuple[int, int]]:
    """Origin, spacing and shape of what has rows and columns. TypeError, ValueError."""
    if hasattr(given, "GetGeoTransform"):
        return (*places_of(given.GetGeoTransform()), (given.RasterYSize, given.RasterXSize))
    if hasattr(given, "transform") and hasattr(given, "width") and hasattr(given, "height"):
        return (*places_of(given.transform), (given.height, given.width))
    if hasattr(given, "dims") and hasattr(given, "coords"):
        rows, columns = _axes_of(given)
        y, x = _axis(rows, given), _axis(columns, given)
        return (x[0], y[0]), (x[1], y[1]), (y[2], x[2])
    raise TypeError("a raster can be like a Raster, a data set of rasterio or GDAL, or one of xarray, not like %s" % (
        type(given).__name__))  # fmt: skip


_NAMES = (("y", "x"), ("lat", "lon"), ("latitude", "longitude"))


def _axes_of(given: Any) -> Sequence[Any]:
    """The names of the dimensions along y and x: of a DataArray the last two."""
    names = list(given.dims)
    if hasattr(given, "data_vars"):  # a Dataset, whose dimensions have no order
        names = [name for pair in _NAMES if set(pair) <= set(names) for name in pair]
    if len(names) < 2:
        raise ValueError("a raster has two dimensions, y and x, not %r" % (tuple(given.dims),))
    if (names[-1], names[-2]) in _NAMES:
        raise ValueError("the last dimensions must be along y and x: take .transpose(..., %r, %r)" % (
            names[-1], names[-2]))  # fmt: skip
    return names[-2:]


def _axis(name: Any, given: Any) -> Tuple[float, float, int]:
    """The first coordinate, the spacing and the number of coordinates of a dimension."""
    places = np.asarray(given.coords[name], np.float64) if name in given.coords else np.zeros(0)
    count = len(places)
    if places.ndim != 1 or count < 2 or not np.isfinite(places).all():
        raise ValueError("%r: a raster like this needs two coordinates or more, all finite" % (name,))
    spacing = float(places[-1] - places[0]) / (count - 1)
    if not np.abs(places - (places[0] + np.arange(count) * spacing)).max() <= abs(spacing) / 100:
        raise ValueError("%r: the coordinates are not evenly spaced" % (name,))
    return float(places[0]), spacing, count


def _checked(raster: Raster, values: Any) -> np.ndarray:
    found = np.asarray(values)
    if found.shape[:2] != raster.shape:
        raise ValueError("values must have the shape of the raster, %s, not %s" % (raster.shape, found.shape))
    return found


def to_xarray(raster: Raster, values: Any, name: Any) -> Any:
    found = _checked(raster, values)
    more = ["band"] if found.ndim == 3 else ["dim_%d" % k for k in range(2, found.ndim)]
    return importlib.import_module("xarray").DataArray(
        found, dims=("y", "x", *more), coords={"y": raster.y, "x": raster.x}, name=name)  # fmt: skip


def to_geotiff(raster: Raster, path: Any, values: Any, crs: Any) -> None:
    found = _checked(raster, values)
    if found.ndim not in (2, 3) or found.size == 0 or found.dtype.kind not in "biuf":
        raise ValueError("values must be real numbers of one cell or more, of shape (rows, columns) or (rows, columns, "
                         "bands), not %s of type %s" % (found.shape, found.dtype))  # fmt: skip
    bands = found[:, :, None] if found.ndim == 2 else found
    (x, y), (dx, dy) = raster.origin, raster.spacing
    if dx < 0:
        x, dx, bands = float(raster.x[-1]), -dx, bands[:, ::-1]
    if dy > 0:
        y, dy, bands = float(raster.y[-1]), -dy, bands[::-1]
    package = writer()
    if package is None:
        raise ImportError("to_geotiff() needs rasterio or GDAL, and Python finds neither: pip install rasterio")
    write = _by_rasterio if package.__name__ == "rasterio" else _by_gdal
    place = (x - dx / 2, dx, 0.0, y - dy / 2, 0.0, dy)
    write(package, os.fspath(path), bands, place, system_of(package, crs))


def writer() -> Any:
    """What writes GeoTIFFs: rasterio, or osgeo.gdal; None where Python finds neither."""
    for name in ("rasterio", "osgeo.gdal"):
        try:
            return importlib.import_module(name)
        except ImportError:
            continue
    return None


def system_of(package: Any, crs: Any) -> Any:
    """The coordinate reference system as writer() has it; None if none is given. ValueError if it is none."""
    crs = crs.to_wkt() if hasattr(crs, "to_wkt") else crs
    read = package.crs.CRS.from_user_input if package.__name__ == "rasterio" else _wkt_by_gdal
    try:
        return None if crs is None else read(crs)
    except (ValueError, TypeError, RuntimeError) as error:
        raise ValueError("crs: %r is not known: %s" % (crs, error)) from error


def _dtype_of(bands: np.ndarray, known: Sequence[str]) -> Any:
    return np.dtype(bands.dtype.name if bands.dtype.name in known else np.float64)


class How(NamedTuple):
    """A file is written, beside what it shows; its bytes are the same for any number of threads."""

    noData: float = math.nan
    isBig: str = "IF_SAFER"  #: is it a BigTIFF?
    threads: int = 1  #: that compress

    def options(self, dtype: Any) -> Dict[str, str]:
        predictor = "3" if dtype.kind == "f" else "2"  # of numbers from those beside them
        return {"COMPRESS": "DEFLATE", "PREDICTOR": predictor, "TILED": "YES", "BIGTIFF": self.isBig,
                "NUM_THREADS": str(self.threads)}  # fmt: skip


def _places(bands: Any) -> Iterator[Tuple[int, int, int]]:
    """First row, rows and band (from 0) of each piece."""
    for row in range(0, len(bands), _ROWS):
        for band in range(bands.shape[2]):
            yield row, min(_ROWS, len(bands) - row), band


def _by_rasterio(rasterio: Any, path: str, bands: Any, place: Sequence[float], crs: Any, how: How = How()) -> None:
    """`bands`: an array (rows, columns, bands), or what has its shape, dtype and some rows of a band."""
    dtype = _dtype_of(bands, ("uint8", "uint16", "int16", "uint32", "int32", "float32", "float64"))
    nodata = how.noData if dtype.kind == "f" else None
    options = {name.lower(): value for name, value in how.options(dtype).items()}
    rows, columns, count = bands.shape
    with rasterio.open(
        path, "w", driver="GTiff", width=columns, height=rows, count=count, dtype=dtype.name, nodata=nodata, crs=crs,
        transform=rasterio.Affine.from_gdal(*place), **options
    ) as made:  # fmt: skip
        for row, some, band in _places(bands):
            piece = np.ascontiguousarray(bands[row : row + some, :, band], dtype)
            made.write(piece, band + 1, window=((row, row + some), (0, columns)))
    # which is told of no error while a file is closed, as of a full disk
    with rasterio.open(path, num_threads=how.threads) as made:
        for row, some, band in _places(bands):
            made.read(band + 1, window=((row, row + some), (0, columns)))


def _by_gdal(gdal: Any, path: str, bands: Any, place: Sequence[float], crs: Any, how: How = How()) -> None:
    types = {"uint8": gdal.GDT_Byte, "uint16": gdal.GDT_UInt16, "int16": gdal.GDT_Int16, "uint32": gdal.GDT_UInt32,
             "int32": gdal.GDT_Int32, "float32": gdal.GDT_Float32, "float64": gdal.GDT_Float64}  # fmt: skip
    dtype = _dtype_of(bands, tuple(types))
    gdal.UseExceptions()
    rows, columns, count = bands.shape
    options = ["%s=%s" % option for option in how.options(dtype).items()]
    try:
        made = gdal.GetDriverByName("GTiff").Create(
            path, columns, rows, count, types[dtype.name], options)
        made.SetGeoTransform(place)
        if crs is not None:
            made.SetProjection(crs)
        for band in range(count) if dtype.kind == "f" else ():
            made.GetRasterBand(band + 1).SetNoDataValue(how.noData)
        for row, some, band in _places(bands):  # as bytes: GDAL's arrays need the NumPy it was built with
            piece = np.ascontiguousarray(bands[row : row + some, :, band], dtype)
            made.GetRasterBand(band + 1).WriteRaster(0, row, columns, some, piece.tobytes())
        made.FlushCache()
        del made
        # GDAL 3.10 raises no error while a file is closed, as of a full disk
        found = gdal.OpenEx(path, open_options=["NUM_THREADS=%d" % how.threads])
        for row, some, band in _places(bands):
            found.GetRasterBand(band + 1).ReadRaster(0, row, columns, some)
    except RuntimeError as error:
        raise OSError("%s: %s" % (path, error)) from error


def _wkt_by_gdal(crs: Any) -> str:
    osr = importlib.import_module("osgeo.osr")
    osr.UseExceptions()
    system = osr.SpatialReference()
    system.SetFromUserInput("EPSG:%d" % crs if isinstance(crs, int) else crs)
    return str(system.ExportToWkt())
