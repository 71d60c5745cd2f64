# SPDX-License-Identifier: BSD-3-Clause
"""The part of a Triangulation that is about triangles to compute on, and these."""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from typing import TYPE_CHECKING, Any, Callable, Dict, Optional, Union

import numpy as np

from . import _library as library
from ._found import Found, count_of, limit_of, spread
from ._input import DEFAULTS, Request, real_of
from ._made import frozen
from ._names import by_any_name
from ._raster import real_numbers
from ._segments import Segments
from ._simplified import Simplified

if TYPE_CHECKING:
    from ._triangulation import Triangulation

_LIMITS = ("alpha", "maximum_edge_length")  # which leave triangles out of the output alone


class BadReason(IntEnum):
    """Why a triangle of a Mesh is not as it was wished."""

    INPUT_ANGLE = library.REFINE_INPUT_ANGLE  #: it lies in an angle below 60 degrees between two segments
    BUDGET = library.REFINE_BUDGET  #: there are as many new points as were allowed
    RESOLUTION = library.REFINE_RESOLUTION  #: an edge is shorter than 1024 units in the last place


@dataclass(frozen=True, eq=False, repr=False)
class Mesh:
    """A refined triangulation, made by `Triangulation.refine`: triangles to compute on. Its arrays are read-only.

    The first `n` points are those of the triangulation that was refined, with their ids; new ones follow. Points that
    are no corner of a triangle (duplicates, points outside the outline) stay among them: a finite-element program that
    takes none has those of ``np.unique(mesh.triangles, return_inverse=True)``.

    Attributes
    ----------
    points : (m, 2) or (m, 3) float64
        The coordinates of new points are x and y of the plane, and a z between those of `corners`; in a plane that is
        not that of x, y, all are between them.
    triangles : (t, 3) int
        The ids of the corners, counterclockwise.
    regions : (t,) int
        The region of each triangle, with the number it has in the triangulation that was refined.
    edges : (e, 2) int
        The pieces of segments that are edges of triangles: of constraints, and of what bounds the triangles, which are
        on the left of it.
    markers : (e, 2) int
        Of each piece the constraint that it lies on, the first if there are more: the number of its chain, and that of
        the segment within it. Chains are numbered from 0, as in `left_out`: segments, lines, loops. -1: no constraint.
    on_boundary : (e,) bool
        Does the piece bound the triangles? Others have triangles on both sides.
    corners, weights : (m - n, 3) int, (m - n, 3) float64
        Where data of new points come from: the ids of the points at the ends of the segment, then -1, or at the corners
        of the triangle that it lies in; and their weights, whose sum is 1.
    bad : (b,) int
        Triangles that are not as wished, rows of `triangles`.
    reasons : (b,) int32
        Why: a `BadReason` each.
    encroached_pieces : int
        Pieces of segments that could not be split though a point lies close to them.
    triangulation : Triangulation
        Of these points and pieces, in the plane: neighbours, areas, places, contours, matplotlib.

    Examples
    --------
    >>> import numpy as np
    >>> from adaptivehilbertdelaunay import delaunay
    >>> square, hole = [[0, 0], [9, 0], [9, 9], [0, 9]], [[3, 3], [6, 3], [6, 6], [3, 6]]
    >>> mesh = delaunay(square + hole, loops=[[0, 1, 2, 3], [4, 5, 6, 7]]).refine(30, maximum_area=0.5)
    >>> mesh
    <Mesh of 138 points, 130 of them new: 228 triangles>
    >>> float(mesh.triangulation.areas.max()) <= 0.5, len(mesh.bad)
    (True, 0)
    >>> around_the_hole = mesh.edges[mesh.markers[:, 0] == 1]
    >>> bottom = np.unique(mesh.edges[(mesh.markers == [0, 0]).all(axis=1)])
    >>> set(mesh.points[bottom, 1].tolist())
    {0.0}
    >>> mesh.interpolate(range(8)).shape
    (138,)
    """

    points: np.ndarray
    triangles: np.ndarray
    regions: np.ndarray
    edges: np.ndarray
    markers: np.ndarray
    on_boundary: np.ndarray
    corners: np.ndarray
    weights: np.ndarray
    bad: np.ndarray
    reasons: np.ndarray
    encroached_pieces: int
    triangulation: Triangulation
    _refined: Refined

    @property
    def is_added(self) -> np.ndarray:
        """(m,) bool: is the point new?"""
        return frozen(np.arange(len(self.points)) >= len(self.points) - len(self.corners))

    def interpolate(self, values: Any) -> np.ndarray:
        """(m, ...): the values of all points, of those at the points that were given, as for
        `Triangulation.interpolate`: linear along segments and in the triangles of before."""
        given = self._refined.interpolate(values)
        return np.concatenate((given, spread(given, self.corners, self.weights)))

    def __repr__(self) -> str:
        return "<Mesh of %d points, %d of them new: %d triangles>" % (
            len(self.points), len(self.corners), len(self.triangles))  # fmt: skip

    def __setstate__(self, state: Dict[str, Any]) -> None:
        self.__dict__.update(state)
        for made in state.values():
            if isinstance(made, np.ndarray):
                frozen(made)


class Refined(Simplified):
    """The part of a Triangulation that adds points for the shape and the size of triangles."""

    if TYPE_CHECKING:

        @property
        def point_status(self) -> np.ndarray: ...

        @property
        def regions(self) -> np.ndarray: ...

    @by_any_name()
    def refine(
        self,
        minimum_angle: float = 20.0,
        *,
        maximum_area: Optional[float] = None,
        maximum_length: Optional[float] = None,
        sizes: Union[None, Any, Callable[[np.ndarray], Any]] = None,
        maximum_added: Optional[int] = None,
    ) -> Mesh:
        """A mesh to compute on: points are added until no angle is smaller and no triangle is larger than wished.

        All triangles are refined that loops (or a trimmed rim) leave. Segments are their outline and the constraints;
        they are split where needed, and stay in their places. Angles between segments stay, too. The result is the
        exact constrained Delaunay triangulation of the points and the new ones, the same for any order of the points.

        Parameters
        ----------
        minimum_angle : float, 0 to 34, default 20
            In degrees. It ends by theorem up to 20.7, where segments meet in 60 degrees or more, and in practice up to
            34: give `maximum_added` above 30. Also `min_angle`.
        maximum_area, maximum_length : float, greater than 0, optional
            Of a triangle, and of an edge, in the plane. Also `max_area`, `max_length`.
        sizes : (m,) array of real numbers, or function, optional
            The longest edge wished at each given point, as values are given to `interpolate`, linear between them; all
            finite and greater than 0. Or a function of the places of all points in the plane, (n, 2), that returns
            them. Also `size`.
        maximum_added : int, 0 or more, optional
            New points. Triangles that are not as wished by then are `bad`.

        Raises
        ------
        ValueError, TypeError
            A number is none of those above; this triangulation has `insertion_limit`, `alpha` or `maximum_edge_length`.
        MemoryError, KeyboardInterrupt
            As `delaunay`.

        Examples
        --------
        >>> from adaptivehilbertdelaunay import delaunay
        >>> made = delaunay([[0, 0], [9, 0], [9, 9], [0, 9], [1, 4]])
        >>> made.refine(30)
        <Mesh of 23 points, 18 of them new: 31 triangles>
        >>> len(made.refine(sizes=lambda xy: 0.2 + xy[:, 0] / 9).triangles) > 500
        True
        """
        request = library.RefineRequest(
            real_of("minimum_angle", minimum_angle, (0.0, 34.0)), limit_of("maximum_area", maximum_area),
            limit_of("maximum_length", maximum_length), None, count_of("maximum_added", maximum_added))  # fmt: skip
        for name in _LIMITS:
            if self._request.settings[name]:
                raise ValueError("a triangulation with %s cannot be refined: give an outline as loops" % name)
        wished = self._wished(sizes)
        if wished is not None:
            request.sizes = library.address_of(wished)
        with self._locked():
            job = self._engine()
            return self._mesh(Found(job, request, wished), job)

    def _wished(self, sizes: Any) -> Optional[np.ndarray]:
        """One number for each point, contiguous."""
        if sizes is None:
            return None
        wished = real_numbers("sizes", sizes(self.plane_points[:, :2]) if callable(sizes) else sizes)
        count = self._counts["points" if callable(sizes) else "input_points"]
        if not callable(sizes) and (wished.shape != (count,) or not self._is_from_surface):
            count += self._counts["source_points"]
        if wished.shape != (count,):
            raise ValueError("sizes must be one number for each of %d points, not of shape %s" % (count, wished.shape))
        return np.ascontiguousarray(wished if callable(sizes) else self.interpolate(wished))

    def _mesh(self, found: Found, job: library.Job) -> Mesh:
        isPlain = self._request.settings["plane"] == library.PLANE_XY
        segments = Segments(self._request, self.point_status, self.plane_points)
        run = self._run_with(found, isPlain)
        points = run.points if isPlain else _joined(self.points.astype(np.float64), found)
        regions, bad, _ = found.described(job, run.triangles, run.regions)
        regions, ids, markers, corners, bad = (array.astype(self._dtype) for array in (
            regions, found.pieces, found.marked(segments), found.corners, bad))  # fmt: skip
        onBoundary = np.arange(len(ids)) >= found.report.inner_pieces
        arrays = (points, run.triangles, regions, ids, markers, onBoundary, corners, found.weights, bad, found.reasons)
        members: Any = (*map(frozen, arrays), int(found.report.encroached_pieces), run, self)
        return Mesh(*members)

    def _run_with(self, found: Found, isPlain: bool) -> Triangulation:
        """The triangulation of the vertices and the new points, with the pieces of segments; of nothing where loops
        leave nothing, as there are no pieces then that would leave it out."""
        points = _joined((self.points if isPlain else self.plane_points).astype(np.float64), found)
        points[len(points) - len(found.places) :, :2] = found.places
        status = self.point_status
        skip = np.zeros(len(points), np.bool_)
        skip[: len(status)] = (status != np.arange(len(status))) | (found.report.triangles == 0)
        settings = {**DEFAULTS, **{name: self._request.settings[name] for name in ("threads", "memory_limit")}}
        request = Request(points, skip, None, {}, "xy", settings)
        for kind, chains in found.chains().items():
            request._set_chains(kind, chains, ())
        made: Triangulation = type(self)(request, self._dtype, (), None)  # type: ignore[assignment]
        return made


def _joined(values: np.ndarray, found: Found) -> np.ndarray:
    return np.concatenate((values, spread(values, found.corners, found.weights)))
