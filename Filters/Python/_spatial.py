# SPDX-License-Identifier: BSD-3-Clause
"""What scipy.spatial has of triangulations in the plane."""

from __future__ import annotations

from functools import cached_property
from typing import Any, Optional, Tuple, Union

import numpy as np

from ._cubic import cross, weights_in
from ._input import DEFAULTS, Request
from ._made import frozen
from ._measured import length
from ._raster import real_numbers
from ._triangulation import Triangulation

# Options of Qhull without which, too, this package does what they ask for: all triangles, however the numbers lie.
_OPTIONS = frozenset(("QJ", "Q12", "Qb", "QbB", "Qbb", "Qc", "Qt", "Qx", "Qz", "Pp"))


class QhullError(RuntimeError):
    """There is no triangle: all points are on one line, or they are fewer than three."""


class Delaunay:
    """The Delaunay triangulation of points in the plane, with the attributes of `scipy.spatial.Delaunay`.

    Exact. It differs from scipy's where that one rounds, and in what follows from it:

    - Of points on one circle the coordinates decide which diagonals there are, and the order of triangles differs.
    - `coplanar` are the points at the place of another. No point is left out because it is close to others.
    - `find_simplex` finds the triangle exactly. `bruteforce` has no effect. A place outside counts as in the triangle
      at the nearest place of the hull if its weights there are not below -`tol`.
    - `lift_points` and `equations` are of the paraboloid x^2 + y^2: `paraboloid_scale` is 1, `paraboloid_shift` 0.
    - Of Qhull's options those are accepted that ask for what is done in any case; 'QJ' moves no points, and equal ones
      stay `coplanar`. `furthest_site` is refused, and so are points in space.
    - `add_points` triangulates all points anew.
    - `triangulation`, which scipy's has not, is the `Triangulation` behind it.

    Parameters
    ----------
    points : (n, 2) array of real numbers, finite; or Triangulation
        Copied. A `Triangulation`, as made by `delaunay`, may have constraints and holes.
    furthest_site : False
    incremental : bool, default False
        Allow `add_points`.
    qhull_options : str, optional

    Raises
    ------
    QhullError
        There is no triangle.
    ValueError, TypeError
        Points are masked, NaN, infinite or not in the plane; an option is not one of those above.

    Examples
    --------
    >>> from adaptivehilbertdelaunay.scipy import Delaunay
    >>> tri = Delaunay([[0, 0], [4, 0], [4, 4], [0, 4], [1, 2]])
    >>> tri.simplices.tolist(), tri.neighbors[0].tolist()
    ([[0, 4, 3], [0, 1, 4], [4, 2, 3], [4, 1, 2]], [2, -1, 1])
    >>> tri.find_simplex([[2, 1], [1, 2], [5, 5]]).tolist()
    [1, 0, -1]
    """

    ndim = 2
    paraboloid_scale, paraboloid_shift = 1.0, 0.0
    furthest_site = False

    def __init__(
        self,
        points: Any,
        furthest_site: bool = False,
        incremental: bool = False,
        qhull_options: Union[None, str, bytes] = None,
    ) -> None:
        if furthest_site:
            raise NotImplementedError("furthest_site: there is no triangulation of the furthest points here")
        words = qhull_options.decode() if isinstance(qhull_options, bytes) else qhull_options or ""
        unknown = [word for word in words.split() if word not in _OPTIONS]
        if unknown:
            raise ValueError("qhull_options: %s is not available without Qhull" % unknown[0])
        self._incremental = bool(incremental)
        self._start(points if isinstance(points, Triangulation) else triangulated(plane_points(points)))

    def _start(self, made: Triangulation) -> None:
        if not len(made.triangles):
            raise QhullError(
                "there is no triangle: the points, %d of them, are fewer than three or on one line" % len(made.points)
            )
        for name in [name for name, member in vars(Delaunay).items() if isinstance(member, cached_property)]:
            self.__dict__.pop(name, None)
        self.triangulation = made

    @cached_property
    def points(self) -> np.ndarray:
        """(n, 2) float64: they are read-only."""
        return frozen(np.ascontiguousarray(self.triangulation.plane_points[:, :2]))

    @property
    def npoints(self) -> int:
        """The number of points."""
        return len(self.points)

    @property
    def nsimplex(self) -> int:
        """The number of triangles."""
        return len(self.triangulation.triangles)

    @property
    def min_bound(self) -> np.ndarray:
        """(2,) float64: the least x and y of the points."""
        found: np.ndarray = np.nanmin(self.points, axis=0)
        return found

    @property
    def max_bound(self) -> np.ndarray:
        """(2,) float64: the greatest x and y of the points."""
        found: np.ndarray = np.nanmax(self.points, axis=0)
        return found

    @cached_property
    def simplices(self) -> np.ndarray:
        """(t, 3) int32: the ids of the corners, counterclockwise."""
        return self.triangulation.triangles.astype(np.int32)

    @cached_property
    def neighbors(self) -> np.ndarray:
        """(t, 3) int32: ``neighbors[i, k]`` is the triangle across the edge opposite to corner `k`; -1: none."""
        return np.ascontiguousarray(self.triangulation.neighbors[:, [1, 2, 0]], np.int32)

    @cached_property
    def convex_hull(self) -> np.ndarray:
        """(b, 2) int32: the edges with one triangle."""
        return self.triangulation.boundary.astype(np.int32)

    @cached_property
    def coplanar(self) -> np.ndarray:
        """(c, 3) int32: each point at the place of another one, a triangle at this place, and the point that is its
        corner."""
        status = self.triangulation.point_status
        ids = np.flatnonzero((status >= 0) & (status != np.arange(len(status))))
        return np.stack((ids, self.vertex_to_simplex[ids], status[ids]), axis=1).astype(np.int32)

    @cached_property
    def vertex_to_simplex(self) -> np.ndarray:
        """(n,) int32: a triangle at the place of each point; -1: none."""
        offsets, items = self.triangulation.vertex_triangles
        has = offsets[1:] > offsets[:-1]
        first = np.full(len(has), -1, np.int32)
        first[has] = items[offsets[:-1][has]]
        status = self.triangulation.point_status
        found: np.ndarray = np.where(status >= 0, first[status], np.int32(-1))
        return found

    @cached_property
    def vertex_neighbor_vertices(self) -> Tuple[np.ndarray, np.ndarray]:
        """Two arrays of int32, `indptr` and `indices`: ``indices[indptr[i]:indptr[i + 1]]`` are the points that an edge
        leads to from point `i`, ascending."""
        offsets, items = self.triangulation.vertex_neighbors
        return offsets.astype(np.int32), items.astype(np.int32)

    @cached_property
    def transform(self) -> np.ndarray:
        """(t, 3, 2) float64: the weights of the first two corners of triangle `i` at a place p are
        ``transform[i, :2] @ (p - transform[i, 2])``. NaN for slivers whose area is lost in rounding."""
        corners = self.points[self.triangulation.triangles]
        first, second = corners[:, 0] - corners[:, 2], corners[:, 1] - corners[:, 2]
        area = cross(first, second)
        lost = abs(area) <= 1000 * np.finfo(float).eps * length(*first.T) * length(*second.T)
        rows = np.stack((second[:, 1], -second[:, 0], -first[:, 1], first[:, 0]), axis=1)
        rows /= np.where(lost, np.nan, area)[:, None]
        made = np.concatenate((rows.reshape(-1, 2, 2), corners[:, 2:]), axis=1)
        made[lost] = np.nan
        return made

    @cached_property
    def equations(self) -> np.ndarray:
        """(t, 4) float64: the unit normal of each triangle on the paraboloid, which points down, and its offset."""
        corners = self.lift_points(self.points)[self.triangulation.triangles]
        normals = np.cross(corners[:, 2] - corners[:, 0], corners[:, 1] - corners[:, 0])
        x, y, z = normals.T
        normals /= length(length(x, y), z)[:, None]
        return np.concatenate((normals, -(normals * corners[:, 0]).sum(axis=1)[:, None]), axis=1)

    def lift_points(self, x: Any) -> np.ndarray:
        """Places, (..., 2), with their height on the paraboloid: (..., 3) float64."""
        places = _places(x)
        return np.concatenate((places, (places**2).sum(axis=-1)[..., None]), axis=-1)

    def plane_distance(self, xi: Any) -> np.ndarray:
        """(..., t) float64: the distance of lifted places, (..., 2), from the plane of each of `equations`."""
        distances: np.ndarray = self.lift_points(xi) @ self.equations[:, :3].T + self.equations[:, 3]
        return distances

    def find_simplex(self, xi: Any, bruteforce: bool = False, tol: Optional[float] = None) -> np.ndarray:
        """The triangle of each place.

        Parameters
        ----------
        xi : (..., 2) array of real numbers
        bruteforce : bool
            Has no effect.
        tol : float, optional
            How far below 0 the weights of a place outside may be. Default: as far as rounding takes a place.

        Returns
        -------
        (...) int32
            -1: outside, or not finite.
        """
        places = _places(xi)
        flat = np.ascontiguousarray(places.reshape(-1, 2))
        found = self.triangulation.locate(flat).triangle
        outside = np.flatnonzero((found < 0) & np.isfinite(flat).all(axis=1))
        if len(outside):
            found[outside] = self._beside(flat[outside], tol)
        return found.astype(np.int32).reshape(places.shape[:-1])

    def _beside(self, places: np.ndarray, tol: Optional[float]) -> np.ndarray:
        """The triangle at the nearest place of the surface, if that is near enough; -1: none."""
        found = self._within_rounding(places)
        left = np.flatnonzero(found < 0)
        if tol is not None and len(left):
            nearest = self.triangulation._nearest_places(places[left])
            rows = self.triangulation.locate(nearest).triangle
            rows = np.where(rows < 0, self._within_rounding(nearest), rows)
            x, y = np.moveaxis(self.points[self.triangulation.triangles[rows].T], 2, 0)
            found[left] = np.where(weights_in(x, y, places[left]).min(axis=0) >= -tol, rows, -1)
        return found

    def _within_rounding(self, places: np.ndarray) -> np.ndarray:
        """The triangle of each place that is outside by rounding alone; -1: it is farther away."""
        offsets, ids, _ = self.triangulation.weights(places)  # those of a vertex or of the ends of an edge
        some = offsets[1:] > offsets[:-1]
        ends = np.stack((ids[offsets[:-1][some]], ids[offsets[1:][some] - 1]), axis=1)
        found = np.full(len(places), -1, ids.dtype)
        found[some] = np.where(ends[:, 0] == ends[:, 1], self.vertex_to_simplex[ends[:, 0]], self._with_edge(ends))
        return found

    def _with_edge(self, ends: np.ndarray) -> np.ndarray:
        """The triangle of each of these edges of the boundary."""
        edges, count = self.triangulation.boundary.astype(np.int64), self.npoints
        rows = np.nonzero(self.triangulation.neighbors < 0)[0]
        keys, wanted = (pairs.min(axis=1) * count + pairs.max(axis=1) for pairs in (edges, ends.astype(np.int64)))
        order = keys.argsort()
        found: np.ndarray = rows[order[np.minimum(np.searchsorted(keys[order], wanted), len(keys) - 1)]]
        return found

    def add_points(self, points: Any, restart: bool = False) -> None:
        """Adds points, (m, 2), whose ids follow those of the others. `restart` has no effect. RuntimeError without
        `incremental` or after `close`."""
        if not self._incremental:
            raise RuntimeError("add_points needs incremental=True, and is not available after close()")
        self._start(triangulated(np.concatenate((self.points, plane_points(points)))))

    def close(self) -> None:
        """No points can be added any more."""
        self._incremental = False


def _places(given: Any) -> np.ndarray:
    places = real_numbers("places", given)
    if places.ndim < 1 or places.shape[-1] != 2:
        raise ValueError("places must be of shape (..., 2), not %s" % (places.shape,))
    return places


def plane_points(given: Any) -> np.ndarray:
    """A copy. ValueError, as scipy has it, also for masked values."""
    if isinstance(given, np.ma.MaskedArray) and np.ma.is_masked(given):
        raise ValueError("points are a masked array, whose mask would be lost")
    points = real_numbers("points", given)
    if points.ndim != 2 or points.shape[1] != 2:
        raise ValueError("points must be of shape (n, 2), in the plane, not %s" % (points.shape,))
    if not np.isfinite(points).all():
        raise ValueError("points must be finite, and %d are not" % np.count_nonzero(~np.isfinite(points).all(axis=1)))
    return np.array(points)


def triangulated(points: np.ndarray) -> Triangulation:
    """Without warnings."""
    return Triangulation(Request(points, None, None, {}, "xy", DEFAULTS), np.int32, (), None)


def tsearch(tri: Delaunay, xi: Any) -> np.ndarray:
    """``tri.find_simplex(xi)``."""
    return tri.find_simplex(xi)
