# SPDX-License-Identifier: BSD-3-Clause
"""The raster: cells of the leaves, put together to a GeoTIFF by rasterio or GDAL, strip by strip from the north."""

from __future__ import annotations

import contextlib
import math
import os
from typing import Any, Iterator, List, Tuple

import numpy as np

from .. import _exchange
from .._raster import Raster
from ._errors import BadOptions, WriteFailed
from ._store import PART, Store, sync

_PROCESS = os.getpid()  # GDAL's threads are not in a child of fork, which would wait for them for ever
_CACHE = 64  # MB that GDAL may hold; it takes a share of the machine's memory otherwise

Window = Tuple[int, int, int, int]  # first row, first column, rows, columns; rows from the south


class Mosaic:
    """What _exchange writes: (rows, columns, 1), the first row in the north, read from the leaves' files when asked."""

    def __init__(self, store: Store, raster: Raster, windows: List[Window], dtype: Any, nodata: float) -> None:
        self.shape = (*raster.shape, 1)
        self.dtype = np.dtype(dtype)
        self._store, self._windows, self.nodata = store, windows, nodata

    def __len__(self) -> int:
        return self.shape[0]

    def __getitem__(self, at: Tuple[slice, slice, int]) -> np.ndarray:
        """Some rows, all of their columns."""
        begin, end, _ = at[0].indices(len(self))
        low, high = len(self) - end, len(self) - begin  # from the south
        made = np.full((end - begin, self.shape[1]), np.nan, self.dtype)
        for leaf, (row, column, rows, columns) in enumerate(self._windows):
            first, last = max(row, low), min(row + rows, high)
            if first < last and columns:
                cells = np.load(self._store.path("cells", "%d.npy" % leaf), mmap_mode="r")
                made[first - low : last - low, column : column + columns] = cells[first - row : last - row]
        if not math.isnan(self.nodata):
            made[np.isnan(made)] = self.nodata
        return made[::-1]


def package() -> Any:
    """rasterio or osgeo.gdal. BadOptions."""
    found = _exchange.writer()
    if found is None:
        raise BadOptions("a raster needs rasterio or GDAL, and Python finds neither: pip install rasterio")
    return found


def system(crs: Any) -> Any:
    """The reference system as the package has it. BadOptions."""
    try:
        return _exchange.system_of(package(), crs)
    except ValueError as error:
        raise BadOptions(str(error)) from error


@contextlib.contextmanager
def _little_cache(gdal: Any) -> Iterator[None]:
    if gdal.__name__ == "rasterio":
        with gdal.Env(GDAL_CACHEMAX=_CACHE):
            yield
        return
    before = gdal.GetCacheMax()
    gdal.SetCacheMax(_CACHE << 20)
    try:
        yield
    finally:
        gdal.SetCacheMax(before)


def write(path: str, mosaic: Mosaic, raster: Raster, crs: Any, threads: int) -> None:
    """WriteFailed, with the file that was there before."""
    gdal = package()
    by = _exchange._by_rasterio if gdal.__name__ == "rasterio" else _exchange._by_gdal
    (x, _), (dx, dy) = raster.origin, raster.spacing
    place = (x - dx / 2, dx, 0.0, float(raster.y[-1]) + dy / 2, 0.0, -dy)
    made = path + PART
    how = _exchange.How(mosaic.nodata, "YES", threads if os.getpid() == _PROCESS else 1)
    try:
        with _little_cache(gdal):
            by(gdal, made, mosaic, place, system(crs), how)
        sync(made)
        os.replace(made, path)
        sync(os.path.dirname(os.path.abspath(path)))
    except Exception as error:  # rasterio's are of many classes
        with contextlib.suppress(OSError):
            os.remove(made)
        if isinstance(error, (BadOptions, MemoryError)):
            raise
        raise WriteFailed("%s cannot be written: %s" % (path, str(error).partition("\n")[0])) from error
