# SPDX-License-Identifier: BSD-3-Clause
"""Callable interpolators, like those of scipy.interpolate."""

from __future__ import annotations

from typing import Any, Dict, Tuple

import numpy as np

from ._arrays import delaunay
from ._raster import real_numbers, table_of, unmasked
from ._sampling import Method, check_outside
from ._triangulation import Triangulation


class _Interpolator:
    """Points, values, and the triangulation of the points."""

    _method: Method

    def _start(self, points: Any, values: Any, rescale: bool, threads: int) -> None:
        isMade = isinstance(points, Triangulation)
        self._origin, self._scale, self._is_rescaled = np.zeros(2), np.ones(2), rescale
        if isMade and rescale:
            raise ValueError("rescale is for points, not for a triangulation of them")
        if not isMade:
            points = self._triangulated(self._own(points, rescale), threads)
        self.triangulation: Triangulation = points
        self.values = np.array(unmasked("values", values))
        points._lacking_rows(self.values)
        self.values.flags.writeable = False

    def _triangulated(self, points: np.ndarray, threads: int) -> Triangulation:
        return delaunay(points, threads=threads)

    def _own(self, points: Any, rescale: bool) -> np.ndarray:
        """A copy, rescaled on request to a square of side 1."""
        if isinstance(points, tuple):
            points = np.stack(np.broadcast_arrays(*(unmasked("points", one) for one in points)), axis=-1)
        given = unmasked("points", table_of(points, "xy"))
        if given.ndim != 2 or given.shape[1] != 2:
            raise ValueError("points must be of shape (n, 2), not %s" % (given.shape,))
        if given.dtype.kind not in "biuf" and given.size:
            raise TypeError("points must be real numbers, not of type %s" % given.dtype)
        own = np.array(given, np.float64)
        if rescale and len(own):
            known = own[np.isfinite(own).all(axis=1)]
            if len(known):
                self._origin, scale = known.mean(axis=0), np.ptp(known, axis=0)
                self._scale = np.where(scale > 0, scale, 1.0)
                own = (own - self._origin) / self._scale
        return own

    @property
    def points(self) -> np.ndarray:
        """(n, 2) float64: the points, as they were triangulated."""
        return self.triangulation.points

    def _places(self, args: Tuple[Any, ...]) -> np.ndarray:
        """(..., 2) float64."""
        if len(args) == 1 and isinstance(args[0], tuple):
            args = args[0]
        if len(args) == 2:
            places = np.stack(np.broadcast_arrays(*(real_numbers("places", one) for one in args)), axis=-1)
        elif len(args) == 1:
            places = real_numbers("places", table_of(args[0], "xy"))
            places = places.reshape(0, 2) if places.shape == (0,) else places
        else:
            raise TypeError("places are x and y, or one array of shape (..., 2), not %d arguments" % len(args))
        if places.ndim < 1 or places.shape[-1] != 2:
            raise ValueError("places must be of shape (..., 2), not %s" % (places.shape,))
        if self._is_rescaled:
            places = (places - self._origin) / self._scale
        return places

    def __setstate__(self, state: Dict[str, Any]) -> None:
        self.__dict__.update(state)
        self.values.flags.writeable = False  # which pickle forgets

    def __repr__(self) -> str:
        if "values" not in self.__dict__:
            return "<%s that was not made>" % type(self).__name__
        return "<%s of %d points>" % (type(self).__name__, len(self.values))


class LinearInterpolator(_Interpolator):
    """Linear interpolation on the exact Delaunay triangulation of points in the plane; behaves like
    `scipy.interpolate.LinearNDInterpolator`.

    Call it with x and y, which broadcast, with a tuple of both, or with one array of shape (..., 2); the result has the
    shape of these followed by that of a row of `values`.

    Parameters
    ----------
    points : (n, 2) array of real numbers, tuple (x, y), table with columns x and y, or Triangulation
        Copied. Of several at one place the first one's value counts.
    values : (n, ...) array of real or complex numbers
        One row for each point; NaN may be among them: then all of a triangle that has one is NaN.
    fill_value : number, default NaN
        The value outside the convex hull of the points (or the triangles of a Triangulation).
    rescale : bool, default False
        Triangulate the points as they are in a square of side 1, for axes of units that do not compare.
    threads : int from 0 to 1024, default 0
        How many triangulate and interpolate; 0: one for each processor that the process may run on.

    Raises
    ------
    ValueError, TypeError
        Arrays do not fit together or are of another type.
    MemoryError
        There is not enough memory; said before the work begins.

    Notes
    -----
    Several threads may call one object. It can be pickled. Python's other threads go on meanwhile, and Ctrl-C works.
    Points that are all on one line, which scipy's refuses, are warned of, and have values on that line between the
    outermost; a single point has its own at its place.

    Examples
    --------
    >>> from adaptivehilbertdelaunay import LinearInterpolator
    >>> plane = LinearInterpolator([[0, 0], [4, 0], [4, 4], [0, 4]], [0, 4, 8, 4])
    >>> plane(1, 2), plane([[3, 3], [5, 5]])
    (array(3.), array([ 6., nan]))
    >>> plane([[1], [2]], [0, 1, 2]).tolist()
    [[1.0, 2.0, 3.0], [2.0, 3.0, 4.0]]
    """

    _method: Method = "linear"

    def __init__(
        self, points: Any, values: Any, fill_value: Any = np.nan, rescale: bool = False, *, threads: int = 0
    ) -> None:
        self._start(points, values, rescale, threads)
        if self.values.dtype.kind not in "biufc":
            raise TypeError("values must be numbers, not of type %s" % self.values.dtype)
        check_outside("fill_value", fill_value, "", self.values.dtype.kind)
        self.fill_value = fill_value

    def __call__(self, *args: Any) -> np.ndarray:
        """Values at places: ``f(x, y)``, ``f((x, y))`` or ``f(places)``."""
        made: np.ndarray = self.triangulation._at(self.values, self._places(args), self._method, self.fill_value)
        return made


class NaturalNeighborInterpolator(LinearInterpolator):
    """Natural neighbour interpolation, after Sibson; called like `LinearInterpolator`, with the same parameters.

    Smooth except at the points, and local; reproduces linear functions and never exceeds the surrounding values. A
    point whose value is NaN is left out, and its neighbours get its weight.

    Examples
    --------
    >>> from adaptivehilbertdelaunay import NaturalNeighborInterpolator
    >>> bump = NaturalNeighborInterpolator([[0, 0], [4, 0], [4, 4], [0, 4], [2, 2]], [0, 0, 0, 0, 1], fill_value=-1)
    >>> bump([[2, 2], [2, 1], [9, 9]])
    array([ 1. ,  0.5, -1. ])
    """

    _method: Method = "natural"


class NearestInterpolator(_Interpolator):
    """The value of the nearest point; behaves like `scipy.interpolate.NearestNDInterpolator`. Called like
    `LinearInterpolator`. Exact: of several points at the same distance it takes the one with the smallest (x, y).

    Parameters
    ----------
    points, rescale, threads
        As in `LinearInterpolator`.
    values : (n, ...) array of any type
        One row for each point. What comes out has the same type: rows as they are, of several points at one place that
        of the one that stands for the vertex.

    Raises
    ------
    ValueError, TypeError, MemoryError
        As there; ValueError, too, if there are no points, or a place is not finite and `values` have no NaN.

    Examples
    --------
    >>> from adaptivehilbertdelaunay import NearestInterpolator
    >>> nearest = NearestInterpolator([[0, 0], [4, 0], [2, 9]], ["west", "east", "north"])
    >>> nearest([1, 3, 2], [0, 0, 99]).tolist()
    ['west', 'east', 'north']
    """

    _method: Method = "nearest"

    def __init__(self, points: Any, values: Any, rescale: bool = False, *, threads: int = 0) -> None:
        self._start(points, values, rescale, threads)
        if self.triangulation.counts["added_points"]:
            raise ValueError("the triangulation has points that were added, which have no values")

    def __call__(self, *args: Any) -> np.ndarray:
        """Values at places: ``f(x, y)``, ``f((x, y))`` or ``f(places)``."""
        places = self._places(args)
        return self._taken(self.triangulation._nearest_ids(places.reshape(-1, 2)), places.shape[:-1])

    def _taken(self, ids: np.ndarray, shape: Tuple[int, ...]) -> np.ndarray:
        """The values of these points; NaN: none."""
        has = ids == ids
        if has.all():
            rows = self.values[ids.astype(np.intp)]
        elif self.values.dtype.kind in "fc" and len(self.values):
            rows = np.full((len(has),) + self.values.shape[1:], np.nan, self.values.dtype)
            rows[has] = self.values[ids[has].astype(np.intp)]
        else:
            raise ValueError("%d places are not finite, or there are no points" % np.count_nonzero(~has))
        made: np.ndarray = rows.reshape(shape + self.values.shape[1:])
        return made
