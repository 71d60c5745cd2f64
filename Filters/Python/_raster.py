# SPDX-License-Identifier: BSD-3-Clause
"""Rasters: places in rows and columns."""

from __future__ import annotations

import math
import operator
from dataclasses import dataclass
from typing import Any, Callable, List, Mapping, NamedTuple, Optional, Sequence, Tuple

import numpy as np

from . import _exchange
from ._geometry import constraints_of

MOST = 2**31 - 1  # rows or columns
LEAST_CELLS, MOST_ALONG = 65536.0, 4096.0  # of a raster whose cells are chosen


@dataclass(frozen=True)
class Raster:
    """Places in rows and columns, such as the centres of the cells of a map: value ``[row, column]`` is at
    ``origin + (column, row) * spacing``.

    Attributes
    ----------
    origin : (x, y) of float
        The place of value ``[0, 0]``: the centre of its cell, in the unit of the points.
    spacing : (dx, dy) of float
        From column to column and from row to row: the size of a cell; finite and not 0. Rows of a positive dy run from
        south to north, those of a negative one from north to south.
    shape : (rows, columns) of int
        How many there are.

    Raises
    ------
    ValueError
        A number is not finite, a spacing is 0, there is a negative number of rows or columns.

    Examples
    --------
    >>> from adaptivehilbertdelaunay import Raster
    >>> cells = Raster((0.5, 0.5), (1, 1), (2, 3))
    >>> cells.x, cells.y, cells.bounds
    (array([0.5, 1.5, 2.5]), array([0.5, 1.5]), (0.0, 3.0, 0.0, 2.0))
    >>> cells.geotransform
    (0.0, 1.0, 0.0, 0.0, 0.0, 1.0)
    >>> cells.north_up()
    Raster(origin=(0.5, 1.5), spacing=(1.0, -1.0), shape=(2, 3))
    >>> cells[:, 1:]
    Raster(origin=(1.5, 0.5), spacing=(1.0, 1.0), shape=(2, 2))
    """

    origin: Tuple[float, float]
    spacing: Tuple[float, float]
    shape: Tuple[int, int]

    def __post_init__(self) -> None:
        for name in ("origin", "spacing"):
            pair = pair_of(name, getattr(self, name))
            if not all(map(math.isfinite, pair)) or (name == "spacing" and 0 in pair):
                wanted = "finite" if name == "origin" else "finite and not 0"
                raise ValueError("%s must be %s, not %r" % (name, wanted, pair))
            object.__setattr__(self, name, pair)
        object.__setattr__(self, "shape", shape_of(self.shape, 0))

    @classmethod
    def from_geotransform(cls, geotransform: Any, shape: Sequence[int]) -> Raster:
        """The raster of a map.

        Parameters
        ----------
        geotransform : six numbers in GDAL's order, or an affine.Affine as rasterio's `transform`
            For pixels that are areas. Rows and columns must run along the axes.
        shape : (rows, columns) of int
        """
        return cls(*_exchange.places_of(geotransform), shape_of(shape, 0))

    @classmethod
    def like(cls, given: Any) -> Raster:
        """The raster of a rasterio or GDAL data set, an xarray DataArray or Dataset (by the coordinates of its last two
        dimensions, which must be evenly spaced, within a hundredth of a cell), or of another Raster: its values are
        then those of the same cells, in the same rows and columns."""
        return given if isinstance(given, cls) else cls(*_exchange.raster_of(given))

    def north_up(self) -> Raster:
        """The same cells with the northernmost row first, as in most maps."""
        (x, _), (dx, dy) = self.origin, self.spacing
        return self if dy < 0 or not self.shape[0] else Raster((x, float(self.y[-1])), (dx, -dy), self.shape)

    def __getitem__(self, part: Any) -> Raster:
        """A tile: ``raster[rows]`` or ``raster[rows, columns]``, of slices without steps. Its places are those of the
        whole, up to rounding."""
        slices = part if isinstance(part, tuple) else (part,)
        if not 0 < len(slices) < 3 or not all(isinstance(one, slice) and one.step in (None, 1) for one in slices):
            raise TypeError("a raster has tiles raster[rows] and raster[rows, columns], of slices without steps")
        spans = [one.indices(count)[:2] for one, count in zip((*slices, slice(None)), self.shape)]
        (row, end), (column, last) = spans
        origin = self.origin[0] + column * self.spacing[0], self.origin[1] + row * self.spacing[1]
        return Raster(origin, self.spacing, (max(0, end - row), max(0, last - column)))

    def to_xarray(self, values: Any, name: Optional[str] = None) -> Any:
        """Values of these cells as an xarray.DataArray with the dimensions "y" and "x"; more of them follow."""
        return _exchange.to_xarray(self, values, name)

    def to_geotiff(self, path: Any, values: Any, crs: Any = None) -> None:
        """Writes values of these cells as a GeoTIFF by rasterio or GDAL, whichever Python finds.

        Parameters
        ----------
        path : str or path
        values : (rows, columns) or (rows, columns, bands) array of real numbers
            Written with the north up, whichever way the rows run. Of float32, float64 or int types that GeoTIFFs have;
            others as float64. NaN is the value of cells without one.
        crs : optional
            The coordinate reference system: "EPSG:32633", its number, WKT, or an object that has `to_wkt`, like those
            of pyproj and rasterio.

        Raises
        ------
        ImportError
            There is neither rasterio nor GDAL.
        ValueError, OSError
            Arrays do not fit; no such reference system; the file cannot be written.
        """
        _exchange.to_geotiff(self, path, values, crs)

    @property
    def x(self) -> np.ndarray:
        """(columns,) float64: x of each column."""
        made: np.ndarray = self.origin[0] + np.arange(self.shape[1]) * self.spacing[0]
        return made

    @property
    def y(self) -> np.ndarray:
        """(rows,) float64: y of each row."""
        made: np.ndarray = self.origin[1] + np.arange(self.shape[0]) * self.spacing[1]
        return made

    @property
    def bounds(self) -> Tuple[float, float, float, float]:
        """xmin, xmax, ymin, ymax of the cells, which reach half a spacing around their places."""
        (x, y), (dx, dy), (rows, columns) = self.origin, self.spacing, self.shape
        xs = sorted((x - dx / 2, x + (columns - 0.5) * dx))
        ys = sorted((y - dy / 2, y + (rows - 0.5) * dy))
        return xs[0], xs[1], ys[0], ys[1]

    @property
    def geotransform(self) -> Tuple[float, float, float, float, float, float]:
        """GDAL's geotransform, for pixels that are areas: corner, width and 0; corner, 0 and height, which is negative
        where row 0 is in the north (see `north_up`)."""
        (x, y), (dx, dy) = self.origin, self.spacing
        return x - dx / 2, dx, 0.0, y - dy / 2, 0.0, dy


def table_of(given: Any, names: str) -> Any:
    """Of a table (a data frame, a structured array) that has columns x and y: an array of its columns with these names,
    large or small, and others as they are."""
    if type(given) is np.ndarray and given.dtype.names is None:
        return given
    columns = getattr(given, "columns", None)
    if columns is None:
        columns = getattr(getattr(given, "dtype", None), "names", None)
    columns = [] if columns is None else list(columns)
    found = {str(name).lower(): name for name in columns}
    found.update((name, name) for name in names if name in columns)  # the small ones where there are both
    if not {"x", "y"} <= set(found):
        return given
    return np.stack([unmasked("column " + name, given[found[name]]) for name in names if name in found], axis=-1)


def xy_of(given: Any) -> Any:
    """Places; x and y where they are a tuple of two, which are broadcast together, or columns."""
    if not (isinstance(given, tuple) and len(given) == 2):
        return table_of(given, "xy")
    return np.stack(np.broadcast_arrays(*(unmasked("places", one) for one in given)), axis=-1)


def has_mask(given: Any) -> bool:
    """Is it a masked array of which something is masked?"""
    return isinstance(given, np.ma.MaskedArray) and bool(np.ma.is_masked(given))


def unmasked(name: str, given: Any) -> np.ndarray:
    """The array; a masked array only without masked values. TypeError."""
    if type(given) is np.ndarray:
        return given
    parts = given if isinstance(given, (list, tuple)) else (given,)
    if any(map(has_mask, parts)):
        raise TypeError("%s are a masked array, whose mask would be lost: use NaN for missing numbers" % name)
    return np.asarray(given)


def real_numbers(name: str, given: Any) -> np.ndarray:
    """The same of real numbers, as float64. TypeError."""
    found = unmasked(name, given)
    if found.dtype.kind not in "biuf" and found.size:
        raise TypeError("%s must be real numbers, not of type %s" % (name, found.dtype))
    return found.astype(np.float64, copy=False)


def number_of(given: Any) -> float:
    """A real number, not a str. TypeError, ValueError."""
    if isinstance(given, (str, bytes)):
        raise TypeError("%r is not a number" % (given,))
    return float(given)


def pair_of(name: str, given: Any) -> Tuple[float, float]:
    """Two numbers."""
    try:
        first, second = (number_of(number) for number in given)
    except (TypeError, ValueError):
        raise TypeError("%s must be two numbers, x and y, not %r" % (name, given)) from None
    return first, second


def shape_of(given: Any, least: int) -> Tuple[int, int]:
    """Rows and columns."""
    try:
        rows, columns = (operator.index(number) for number in given)
    except (TypeError, ValueError):
        raise TypeError("shape must be two whole numbers, rows and columns, not %r" % (given,)) from None
    if not (least <= rows <= MOST and least <= columns <= MOST):
        raise ValueError("shape must be rows and columns, each from %d to %d, not %r" % (least, MOST, given))
    return rows, columns


def size_of(given: Any) -> Tuple[float, float]:
    """The size of a cell, of one number or two."""
    isOne = np.ndim(given) == 0
    try:
        size = (number_of(given),) * 2 if isOne else pair_of("cell_size", given)
    except (TypeError, ValueError):
        raise TypeError("cell_size must be one number or two numbers, x and y, not %r" % (given,)) from None
    if not all(0 < number < math.inf for number in size):
        raise ValueError("cell_size must be greater than 0 and finite, not %r" % (given,))
    return size


_BOUNDS = "bounds must be xmin, xmax, ymin, ymax"


def _other_order(given: Any) -> ValueError:
    return ValueError(_BOUNDS + ", but %r are xmin, ymin, xmax, ymax, as in shapely and rasterio: give the geometry, "
                      "the raster or the BoundingBox itself, or put them in order" % (given,))  # fmt: skip


def _area_of(given: Any) -> Optional[Tuple[float, float, float, float]]:
    """Of a Raster, a geometry, or a BoundingBox of rasterio; None of others. ValueError."""
    if isinstance(given, Raster):
        return given.bounds
    if hasattr(given, "left") and hasattr(given, "bottom"):
        return given.left, given.right, given.bottom, given.top
    if not (hasattr(given, "__geo_interface__") or isinstance(given, Mapping)):
        return None
    places = constraints_of(given, "bounds").points
    if not len(places):
        raise ValueError("bounds: the geometry is empty")
    (xmin, ymin), (xmax, ymax) = places[:, :2].min(axis=0).tolist(), places[:, :2].max(axis=0).tolist()
    return xmin, xmax, ymin, ymax


def bounds_of(given: Any) -> Tuple[float, float, float, float]:
    """The area of a raster: four numbers, or what has an area."""
    area = _area_of(given)
    given = given if area is None else area
    try:
        xmin, xmax, ymin, ymax = (number_of(number) for number in given)
    except (TypeError, ValueError):
        raise TypeError("bounds must be four numbers: xmin, xmax, ymin, ymax; not %r" % (given,)) from None
    if not (xmin <= xmax and ymin <= ymax and all(map(math.isfinite, (xmin, xmax, ymin, ymax)))):
        if xmin < ymin and xmax < ymax and all(map(math.isfinite, (xmin, xmax, ymin, ymax))):
            raise _other_order(given)
        raise ValueError(_BOUNDS + ", finite and ascending, not %r" % (given,))
    return xmin, xmax, ymin, ymax


def check_order(given: Any, points: Callable[[], Sequence[float]]) -> None:
    """ValueError for four numbers that are xmin, ymin, xmax, ymax, as far as the area of the points tells: in that
    order they have an area there, and in the other one none at all, or a thousandth of it has points."""
    area = bounds_of(given)
    other = (area[0], area[2], area[1], area[3])
    if area[0] < area[2] and area[1] < area[3] and _area_of(given) is None:
        ours, theirs = _share(area, points()), _share(other, points())
        if theirs > 1000 * ours and (ours > 0 or area[0] == area[1] or area[2] == area[3]):
            raise _other_order(given)


def _share(area: Sequence[float], box: Sequence[float]) -> float:
    """How much of an area is in a box, from 0 to 1."""
    share = 1.0
    for low, high, least, most in ((*area[:2], *box[:2]), (*area[2:], *box[2:])):
        share *= max(0.0, min(high, most) - max(low, least)) / (high - low) if high > low else 0.0
    return share


def raster_over(
    bounds: Sequence[float],
    cell_size: Any = None,
    shape: Optional[Sequence[int]] = None,
    align: bool = False,
) -> Raster:
    """The raster of cells of this size, or of so many rows and columns, that covers the bounds; bit for bit that of
    vtkAdaptiveHilbertInterpolation2D (vtkAHDRaster.h)."""
    if (cell_size is None) == (shape is None):
        raise ValueError("a raster needs either a cell_size or a shape")
    area = bounds_of(bounds)
    if shape is None:
        x, y = axes_by_size(area, size_of(cell_size), align)
    elif align:
        raise ValueError("align needs a raster with a cell_size")
    else:
        rows, columns = shape_of(shape, 1)
        x, y = axes_by_count(area, (columns, rows))
    for axis in (x, y):
        if not axis.count <= MOST:
            raise MemoryError("a raster of %g x %g cells has more than %d rows or columns" % (x.count, y.count, MOST))
        if axis.is_too_wide():
            raise ValueError("the raster would be wider or higher than the largest float64")
        if not axis.is_apart():
            raise ValueError("float64 cannot tell cells of size %g apart within these bounds" % axis.spacing)
    return Raster((x.origin, y.origin), (x.spacing, y.spacing), (int(y.count), int(x.count)))


class Axis(NamedTuple):
    """A raster along one axis."""

    origin: float  # the first centre
    spacing: float
    count: float  # type: ignore[assignment]

    def last(self) -> float:
        return self.origin + (self.count - 1) * self.spacing

    def is_too_wide(self) -> bool:
        """Do its terms, or the last centre, exceed the largest number?"""
        return not (math.isfinite(self.spacing) and math.isfinite(self.last()))

    def is_apart(self) -> bool:
        """Are the centres of neighbours different numbers?"""
        last, step = self.last(), self.spacing
        return step > 0 and (self.count == 1 or (last - step < last and self.origin + step > self.origin))


def axes_by_size(area: Sequence[float], size: Sequence[float], align: bool) -> Tuple[Axis, Axis]:
    """Of cells of this size, along x and y; vtkAHDRaster.h has the rule. `area`: xmin, xmax, ymin, ymax."""
    return _by_size(area[0], area[1], size[0], align), _by_size(area[2], area[3], size[1], align)


def axes_by_count(area: Sequence[float], count: Sequence[int]) -> Tuple[Axis, Axis]:
    """The same of so many columns and rows."""
    x, y = _by_count(area[0], area[1], count[0]), _by_count(area[2], area[3], count[1])
    width, height = x.spacing, y.spacing
    x = x if width > 0 else Axis(area[0], height if height > 0 else 1.0, 1.0)
    y = y if height > 0 else Axis(area[2], width if width > 0 else 1.0, 1.0)
    return x, y


def chosen_size(area: Sequence[float], points: int) -> float:
    """The size of square cells for so many points in an area; vtkAHDRaster.h has the rule."""
    width, height = area[1] / 2 - area[0] / 2, area[3] / 2 - area[2] / 2  # the whole may be no number
    longer = max(width, height)
    cells = math.sqrt(max(float(points), LEAST_CELLS))
    size = 2 * max(math.sqrt(width) * math.sqrt(height) / cells, longer / MOST_ALONG)
    if not size > 0:
        return longer if longer > 0 else 1.0
    least, nearest = math.floor((math.frexp(size)[1] - 1) * 0.30103), 0.0  # the power of ten, or one less
    for step in (float("%de%d" % (digit, k)) for k in range(least - 1, least + 3) for digit in (1, 2, 5)):
        nearest = step if nearest == 0 or step / size < size / nearest else nearest
    return nearest


def _whole_below(quotient: float, slack: float) -> float:
    """The whole number that the quotient of a coordinate and a size stands for, if `slack` is how far that may be off;
    else the next one below."""
    if not math.isfinite(quotient):
        return quotient
    below = float(math.floor(quotient))
    isUpper = quotient - below > 0.5 or (quotient - below == 0.5 and quotient > 0)
    return below + 1.0 if isUpper and below + 1.0 - quotient <= slack else below


def _length_in(low: float, high: float, size: float) -> float:
    """(high - low) / size, where only the quotient may be a number, too."""
    length = high - low
    return length / size if math.isfinite(length) else high / size - low / size


def _by_size(low: float, high: float, size: float, align: bool) -> Axis:
    slack = 2.0**-50 * max(abs(low), abs(high)) / size  # what writing coordinates in decimal may have cost
    if align:
        first = _whole_below(low / size, slack)
        count = max(1.0, -_whole_below(-(high / size), slack) - first)
        return Axis((first + 0.5) * size, size, count)
    origin = low + 0.5 * size if low < high else low  # one row through a side without length
    return Axis(origin, size, max(1.0, -_whole_below(-_length_in(low, high, size), slack)))


def _by_count(low: float, high: float, count: int) -> Axis:
    spacing = _length_in(low, high, count)
    return Axis(low + 0.5 * spacing, spacing, float(count))


class Samples(NamedTuple):
    """What `Job.sample` found at k places."""

    values: List[np.ndarray]  #: (k, columns) float64 of each array; NaN where there is no value
    gradients: List[Any]  #: None, or (k, 2 * columns) float64 of each array: d/dx and d/dy of each column
    mask: np.ndarray  #: (k,) uint8: 1 where there is a value of the surface
