# SPDX-License-Identifier: BSD-3-Clause
"""Values between the points of a triangulation: at any places or on a raster."""

from __future__ import annotations

import math
from typing import (
    TYPE_CHECKING, Any, Callable, Literal, NamedTuple, Optional, Sequence, Tuple, Union, get_args, overload,
)  # fmt: skip

import numpy as np

from . import _library as library
from ._interface import SAY_PLACES, WORDS_OF_NUMPY, say
from ._made import Made, frozen
from ._raster import Raster, Samples, check_order, raster_over, real_numbers, unmasked, xy_of
from ._warnings import tell as warn_of

#: In the order of the header's numbers.
Method = Literal["linear", "natural", "laplace", "nearest"]
METHODS: Tuple[str, ...] = get_args(Method)
Outside = Union[complex, Literal["nearest", "boundary"]]
#: By the header's numbers, from 1 on.
OUTSIDE = {"nearest": library.OUTSIDE_NEAREST_VERTEX, "boundary": library.OUTSIDE_BOUNDARY}

ProgressFunction = Callable[[str, float], Any]

_REAL, _COMPLEX = np.dtype(np.float64), np.dtype(np.complex128)
_NO_COLUMNS = np.arange(0)


class Weights(NamedTuple):
    """The weights of the points in the value at each place: place `i`, in flattened order, has the entries
    ``offsets[i]`` to ``offsets[i + 1]`` of the others; none if it has no value. As a matrix for values of all points:
    ``scipy.sparse.csr_matrix((weights, points, offsets), (places, n))``."""

    offsets: np.ndarray  #: (places + 1,) int64
    points: np.ndarray  #: (entries,) int: ids; of a place each once
    weights: np.ndarray  #: (entries,) float64: not negative; those of a place sum to 1, up to rounding


def method_of(given: Any) -> int:
    if not isinstance(given, str):
        raise TypeError("method must be one of %s, not %r" % (", ".join(map(repr, METHODS)), given))
    if given not in METHODS:
        raise ValueError("method must be one of %s, not %r" % (", ".join(map(repr, METHODS)), given))
    return METHODS.index(given)


def places_of(given: Any) -> Tuple[Union[Raster, np.ndarray], Tuple[int, ...]]:
    """Places as a job takes them, and the shape of values at them."""
    if isinstance(given, Raster):
        return given, given.shape
    places = unmasked("places", xy_of(given))
    if places.ndim < 1 or places.shape[-1] != 2:
        if places.shape != (0,):
            raise ValueError("places must be of shape (k, 2) or (..., 2), or a Raster, not %s" % (places.shape,))
        places = places.reshape(0, 2)
    return np.ascontiguousarray(real_numbers("places", places)).reshape(-1, 2), places.shape[:-1]


def check_outside(name: str, given: Any, also: str, kind: str) -> None:
    """Is it one number, complex ones only among values of that kind? TypeError."""
    isWord = isinstance(given, (str, bytes))
    found = np.asarray(None if isWord else given)
    if found.ndim != 0 or found.dtype.kind not in ("biufc" if kind == "c" else "biuf"):
        raise TypeError("%s must be a number%s, not %r" % (name, also, given))


class Sampled(Made):
    """The interpolation on a Triangulation."""

    if TYPE_CHECKING:

        @property
        def points(self) -> np.ndarray: ...

    def _for_places(self) -> library.Job:
        """The job. The first time the engine makes tables of its own, and reads no points after that. Requires: the
        lock."""
        return self._job if self._job is not None and self._job.hasTables else self._engine()

    @property
    def _is_from_surface(self) -> bool:
        """Do source points take their values from the surface?"""
        return bool(self._request.settings["source_heights"] == library.HEIGHTS_FROM_SURFACE)

    def _lacking_rows(self, given: np.ndarray) -> int:
        """How many rows values lack: those of source points, if these take them from the surface. ValueError unless
        there is one for each other point."""
        added: int = self._counts["source_points"]
        count = self._counts["input_points"] + added
        if self._is_from_surface and given.ndim and len(given) == count - added:
            return added
        if given.ndim < 1 or len(given) != count:
            last = ", the last %d of which are those of the constraints" % added if added else ""
            raise ValueError("values must have a row for each of %d points%s, not the shape %s" % (
                count, last, given.shape))  # fmt: skip
        return 0

    def _numbers_of(self, values: Any, kinds: str) -> np.ndarray:
        """With a row for each point of the input and of a source."""
        given = unmasked("values", values)
        lacking = self._lacking_rows(given)
        if given.dtype.kind not in kinds:
            raise TypeError("values must be real numbers, not of type %s" % given.dtype)
        if lacking:
            given = np.concatenate((given, np.full((lacking, *given.shape[1:]), np.nan)))
        return given

    def raster(
        self,
        cell_size: Union[None, float, Sequence[float]] = None,
        *,
        shape: Optional[Sequence[int]] = None,
        bounds: Any = None,
        align: bool = False,
        like: Any = None,
    ) -> Raster:
        """A raster over the triangulation, for `interpolate`.

        Parameters
        ----------
        cell_size : float or (dx, dy), greater than 0, in the unit of the points
            The size of a cell. As many cells as cover the bounds, at least one; a bound within rounding of a border
            between cells counts as that border.
        shape : (rows, columns) of int, from 1 to 2**31 - 1
            The number of cells; they fill the bounds, and a side of length 0 has one row. Give either `cell_size` or
            `shape`.
        bounds : (xmin, xmax, ymin, ymax) of float, or what has an area, optional
            The area to cover; by default that of the vertices, in the plane of the triangulation. A geometry
            (shapely's, a GeoDataFrame, anything with `__geo_interface__`), a Raster or rasterio's BoundingBox is taken
            as it is. Numbers in the order of shapely and rasterio, xmin, ymin, xmax, ymax, are refused where the
            vertices tell.
        align : bool, default False
            With `cell_size`: are the borders of the cells multiples of it (as with -tap of GDAL's programs)? Else
            the first cell begins at xmin and ymin.
        like : Raster, data set of rasterio or GDAL, xarray.DataArray or Dataset, optional
            Instead of all others: its cells, see `Raster.like`.

        Returns
        -------
        Raster
            Its places are the centres of the cells, row 0 is in the south (`Raster.north_up`: in the north).

        Raises
        ------
        ValueError, TypeError
            A size is not greater than 0, bounds are not ascending or not finite, or there are none without vertices;
            cells are so small that float64 cannot tell them apart.
        MemoryError
            There are more than 2**31 - 1 rows or columns.

        Examples
        --------
        >>> from adaptivehilbertdelaunay import delaunay
        >>> made = delaunay([[1, 1], [9, 1], [9, 5], [1, 5]])
        >>> made.raster(shape=(2, 4))
        Raster(origin=(2.0, 2.0), spacing=(2.0, 2.0), shape=(2, 4))
        >>> made.raster(cell_size=5, align=True)
        Raster(origin=(2.5, 2.5), spacing=(5.0, 5.0), shape=(1, 2))
        """
        if like is not None:
            if not (cell_size is None and shape is None and bounds is None) or align:
                raise ValueError("like is a whole raster: cell_size, shape, bounds and align cannot be given beside it")
            return Raster.like(like)
        if bounds is None:
            bounds = self._box()
            if bounds[0] != bounds[0]:
                raise ValueError("there are no vertices: bounds must be given")
        else:
            check_order(bounds, self._box)
        return raster_over(bounds, cell_size, shape, align)

    def _box(self) -> Sequence[float]:
        """xmin, xmax, ymin, ymax of the vertices in the plane; NaN if there are none."""
        with self._locked():
            box: Sequence[float] = self._engine().array("vertex_bounds").ravel().tolist()
        return box

    @overload
    def interpolate(
        self,
        values: Any,
        at: Any = None,
        method: Method = "linear",
        *,
        outside: Outside = np.nan,
        gradient: Literal[False] = False,
        progress: Optional[ProgressFunction] = None,
    ) -> np.ndarray: ...

    @overload
    def interpolate(
        self,
        values: Any,
        at: Any,
        method: Literal["linear"] = "linear",
        *,
        outside: Outside = np.nan,
        gradient: Literal[True],
        progress: Optional[ProgressFunction] = None,
    ) -> Tuple[np.ndarray, np.ndarray]: ...

    def interpolate(
        self,
        values: Any,
        at: Any = None,
        method: Method = "linear",
        *,
        outside: Outside = np.nan,
        gradient: bool = False,
        progress: Optional[ProgressFunction] = None,
    ) -> Any:
        """Values between the points, at any places; or, without `at`, for all points, also for added ones.

        The triangle, edge or vertex of a place is determined exactly: a place on a vertex gets the value of that
        vertex, one on an edge a value from its two ends alone, the same from either side. Outside the triangles (of the
        hull, in a hole, in removed triangles) there is no value; but outside by no more than rounding, 16 units in the
        last place of the largest coordinate, that of the nearest place of them (not for `locate`).

        Parameters
        ----------
        values : (m,) or (m, ...) array of numbers
            One row for each given point: `points` and then, if there are any, `source_points`. NaN is allowed: with
            'linear' the whole triangle of such a point is NaN, with 'natural' and 'laplace' the point is left out and
            the other neighbours get its weight. Of several points at one place the row of the one that represents the
            vertex is used (`point_status`). With duplicates='mean_z' a column that is the z of the points as
            they were given becomes that of `points`, the means among them; any other is not averaged.
        at : (..., 2) array of real numbers, tuple (x, y), or Raster, optional
            Places in the plane of the triangulation, in the unit of the points, anywhere; at those with NaN there is no
            value. A tuple of two is always x and y, which broadcast. A warning tells if none of the places is on the
            surface, unless `outside` is given.
        method : {'linear', 'natural', 'laplace', 'nearest'}, default 'linear'
            'linear': on each triangle the plane through its corners. 'natural': natural neighbours, after Sibson:
            smooth but at the points, by the area that the place would take of their Voronoi cells. 'laplace': the same
            neighbours, by the borders of the cells; not as smooth. 'nearest': of the nearest vertex, not across a hole
            or outline; of several the one of smallest (x, y). All but the last give back functions that are linear.
        outside : number, 'nearest' or 'boundary', default NaN
            The value outside the triangles, and at places that are not finite. 'nearest': the value of the nearest
            vertex. 'boundary': at the nearest place of the triangles. NaN that comes from `values` stays.
        gradient : bool, default False
            With 'linear': the slopes too.
        progress : function of (str, float), optional
            Is told ('outputs', the fraction that is done, 0 to 1). To stop the work, raise an exception.

        Returns
        -------
        (...) float64, or complex128 if `values` are complex
            Integers become float64. Of the shape of the places, (rows, columns) of a raster, row 0 in the south, and
            of that of a row of `values`.
        gradients : (..., 2) of the same type, with `gradient` only
            For each of them d/dx and d/dy; NaN outside.

            Without `at`: (n, ...) float64, `values` and, at crossings, the mean of linear interpolation along both
            segments; with source_heights='surface', at source points, in place of their own, what linear interpolation
            on the surface gives; NaN at bounding points.

        Raises
        ------
        ValueError, TypeError
            An array is of another shape or type, a word is none of those above.
        MemoryError
            There is not enough memory, or `memory_limit` leaves less than is needed: at once, with figures.

        Examples
        --------
        >>> from adaptivehilbertdelaunay import delaunay
        >>> made = delaunay([[0, 0], [4, 0], [4, 4], [0, 4], [1, 2]])
        >>> heights = [0, 4, 8, 4, 3]  # x + y
        >>> made.interpolate(heights, [[1, 1], [3, 2.5], [9, 9]])
        array([2. , 5.5, nan])
        >>> made.interpolate(heights, made.raster(shape=(2, 2)), "natural")
        array([[2., 4.],
               [4., 6.]])
        >>> made.interpolate(heights, [9, 9], outside="nearest")
        array(8.)
        """
        if at is None:
            if method != "linear" or gradient or np.ndim(outside) or not _is_nan(outside):
                raise ValueError("method, outside and gradient are for values at places: give these as `at`")
            given = self._numbers_of(values, "biuf")
            return self._for_points(given, self._columns_of_z(given))
        return self._at(values, at, method, outside, gradient, progress, True)

    def weights(self, at: Any, method: Method = "linear") -> Weights:
        """The weights of the points in the value at each place: to interpolate many times at the same places, or to
        interpolate something other than an array of numbers.

        Parameters
        ----------
        at : (..., 2) array of real numbers, tuple (x, y), or Raster
            Places, as in `interpolate`.
        method : {'linear', 'natural', 'laplace', 'nearest'}, default 'linear'
            As there.

        Returns
        -------
        Weights
            `offsets`, `points` and `weights`; of ids of `points`, added ones included. For heights multiply
            with the z of `points`, which has the means of duplicates='mean_z'.

        Raises
        ------
        ValueError, TypeError, MemoryError
            As in `interpolate`.

        Examples
        --------
        >>> from adaptivehilbertdelaunay import delaunay
        >>> made = delaunay([[0, 0], [4, 0], [4, 4], [0, 4]])
        >>> offsets, points, weights = made.weights([[0, 1], [7, 7], [4, 4]])
        >>> offsets.tolist(), points.tolist(), weights.tolist()
        ([0, 2, 2, 3], [3, 0, 2], [0.25, 0.75, 1.0])
        """
        places, _ = places_of(at)
        with self._locked():
            job = self._for_places()
            job.sample_weights(places, method_of(method))
            return Weights(
                job.array("weight_offsets"), job.array("weight_points", self._dtype), job.array("weights")
            )  # fmt: skip

    def _at(
        self,
        values: Any,
        at: Any,
        method: Method,
        outside: Outside,
        gradient: bool = False,
        progress: Optional[ProgressFunction] = None,
        tells: bool = False,
    ) -> Any:
        """See interpolate(). `tells`: of places that are all outside, where that is NaN."""
        chosen = method_of(method)
        if gradient and chosen != library.SAMPLE_LINEAR:
            raise ValueError("there are gradients with the method 'linear' only")
        fills = OUTSIDE.get(outside) if isinstance(outside, str) else library.OUTSIDE_NO_VALUE
        if fills is None:
            raise ValueError("outside must be a number, 'nearest' or 'boundary', not %r" % (outside,))
        places, shape = places_of(at)
        given = self._numbers_of(values, "biufc")
        if not isinstance(outside, str) and outside is not np.nan:
            check_outside("outside", outside, ", 'nearest' or 'boundary'", given.dtype.kind)
        isFilled = not isinstance(outside, str) and not _is_nan(outside)
        ofZ = self._columns_of_z(given)
        rows = self._for_points(given, ofZ) if self._counts["added_points"] or len(ofZ) else given
        dtype = _COMPLEX if given.dtype.kind == "c" else _REAL
        flat = np.ascontiguousarray(rows, dtype)
        if dtype is _COMPLEX or flat.ndim > 2:
            flat = flat.reshape(len(rows), math.prod(given.shape[1:])).view(_REAL)
        with self._locked():
            found = self._sampled(places, flat, chosen, fills, gradient, progress, isFilled)
        made = found.values[0] if dtype is _REAL else found.values[0].view(dtype)
        if isFilled:
            made[found.mask == 0] = outside
        elif tells and fills == library.OUTSIDE_NO_VALUE and made.size and made[0, 0] != made[0, 0]:
            self._tell_if_none(places, made)
        made = made.reshape(shape + given.shape[1:])
        return (made, _slopes(found.gradients[0], dtype).reshape(made.shape + (2,))) if gradient else made

    def _tell_if_none(self, places: Union[Raster, np.ndarray], made: np.ndarray) -> None:
        """Warns of places of which none is on the surface. `made`: the values there."""
        if not np.isnan(made).all():
            return
        with self._locked():
            if self._for_places().sample(places, []).mask.any():
                return
        if isinstance(places, Raster):
            finite, count = np.array([(places.x[k], places.y[k]) for k in (0, -1)]), math.prod(places.shape)
        else:
            finite = places[np.isfinite(places).all(axis=1)]
            count = len(finite)
        low, high, box = finite.min(axis=0, initial=np.inf), finite.max(axis=0, initial=-np.inf), self._box()
        said = say(SAY_PLACES, WORDS_OF_NUMPY, {
            "sampled_places": count, "sampled_outside": count, "triangles": self._counts["triangles"],
            "wanted": [low[0], high[0], low[1], high[1]],
            "surface": box if box[0] == box[0] else "nowhere"})  # fmt: skip
        warn_of(said.values())

    def _nearest_ids(self, places: np.ndarray) -> np.ndarray:
        """The id of the point nearest to each place, (k, 2); NaN where there is none."""
        ids = self._made("ids", lambda: np.arange(self._counts["points"], dtype=np.float64)[:, None])
        with self._locked():
            found = self._sampled(np.ascontiguousarray(places), ids, library.SAMPLE_NEAREST, 0, False, None, False)
        made: np.ndarray = found.values[0].reshape(-1)
        return made

    def _nearest_places(self, places: np.ndarray) -> np.ndarray:
        """The place of the triangles that is nearest to each place, (k, 2)."""
        rows = np.ascontiguousarray(self._array("plane_points", np.float64)[:, :2])
        with self._locked():
            found = self._sampled(places, rows, library.SAMPLE_LINEAR, library.OUTSIDE_BOUNDARY, False, None, False)
        made: np.ndarray = found.values[0]
        return made

    def _for_points(self, given: np.ndarray, ofZ: np.ndarray) -> np.ndarray:
        """The values with those of points that were added, and of those that lie on a surface; the columns `ofZ` are
        that of `points`, which follows `duplicates`."""
        dtype = np.complex128 if given.dtype.kind == "c" else np.float64
        made = np.full((self._counts["points"],) + given.shape[1:], np.nan, dtype)
        made[: len(given)] = given
        if made.size:
            rows = made.reshape(len(made), -1)
            with self._locked():
                self._engine().interpolate(rows.view(np.float64))
            first = len(given) + self._counts["points_added_to_lines"]
            bounding = slice(first, len(rows) - self._counts["split_crossings"])
            for column in ofZ:
                rows[:, column] = self.points[:, 2]
                rows[bounding, column] = np.nan
        return made

    def _columns_of_z(self, given: np.ndarray) -> np.ndarray:
        """Which columns of values are the z of the points as they were given, where duplicates='mean_z' gives points
        another one."""
        request = self._request
        moves = request.settings["duplicates"] == library.DUPLICATES_MEAN_Z and self._counts["duplicates"]
        if not moves or request.columns < 3 or not given.size:
            return _NO_COLUMNS
        z, columns = self._made("given_z", self._given_z)[:, None], given.reshape(len(given), -1)
        found = np.arange(columns.shape[1])
        for most in (64, len(z)):  # a few points tell most others apart
            some, own = columns[:most, found], z[:most]
            found = found[((some == own) | ((some != some) & (own != own))).all(axis=0)]
        return found

    def _given_z(self) -> np.ndarray:
        self._check_input()
        return frozen(self._request.z)

    def _sampled(
        self,
        places: Union[Raster, np.ndarray],
        rows: np.ndarray,
        method: int,
        outside: int,
        gradient: bool,
        progress: Optional[ProgressFunction],
        mask: bool,
    ) -> Samples:
        """Requires: the lock."""
        job = self._for_places()
        job.refuse_if_busy()  # a running call keeps its callback
        if progress is not None:
            tell = progress
            job.set_progress(lambda phase, fraction: tell(library.PHASES[phase], fraction) and None)
        try:
            return job.sample(places, [rows], method=method, outside=outside, gradients=gradient, has_mask=mask)
        finally:
            job.set_progress(None)


def _is_nan(number: Any) -> bool:
    return not isinstance(number, str) and bool(number != number)


def _slopes(found: np.ndarray, dtype: Any) -> np.ndarray:
    """Of each number x and y: of complex ones those of both their parts are side by side in `found`."""
    if dtype is _REAL:
        return found
    parts = found.reshape(len(found), found.shape[1] // 4, 2, 2)
    made: np.ndarray = np.ascontiguousarray(np.swapaxes(parts, 2, 3)).view(dtype)
    return made
