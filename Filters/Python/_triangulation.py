# SPDX-License-Identifier: BSD-3-Clause
"""The result of `delaunay`."""

from __future__ import annotations

import functools
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, Dict, Iterable, Literal, Mapping, Optional, Tuple, Union

import numpy as np

from . import _library as library
from ._input import CHOICES, DEFAULTS, Corners, Request, polygon_of
from ._made import frozen
from ._picture import svg
from ._results import Adjacency, Boxes, Location, Outline, Voronoi, chained
from ._raster import real_numbers, unmasked, xy_of
from ._refined import Refined


_TRIANGLES = library.names(library.COUNTS).index("triangles")


def _arrays_of(made: Any) -> Iterable[np.ndarray]:
    if isinstance(made, Voronoi):
        return made.points, made.offsets, made.corners, made.sites
    if isinstance(made, Outline):
        return made.points, made.corners, made.rings, made.polygons
    return made if isinstance(made, (Adjacency, Boxes)) else (made,)


def _view(array: np.ndarray) -> np.ndarray:
    return frozen(array.view())


_NAMES_OF_SCIPY = {
    "simplices": "triangles",
    "find_simplex": "locate(places).triangle",
    "convex_hull": "boundary, or hull in order",
    "vertex_neighbor_vertices": "vertex_neighbors",
    "vertex_to_simplex": "vertex_triangles",
    "coplanar": "point_status",
    "transform": "weights(places)",
    **dict.fromkeys(
        ("add_points", "equations", "lift_points", "max_bound", "min_bound", "npoints", "nsimplex", "plane_distance"),
        "adaptivehilbertdelaunay.scipy.Delaunay",
    ),
}


class Triangulation(Refined):
    """A Delaunay triangulation, made by `delaunay`. It never changes; its arrays are read-only.

    Ids are rows of `points`. All results depend on the points, constraints and settings alone, the same to the byte
    for any number of threads and on any machine.

    Attributes are computed when first used, and kept; `triangles`, `counts` and those in the keyword `want` of
    `delaunay` are available at once. For this it keeps the engine's memory, 64 bytes per point, later 110, until it is
    deleted or `release` is called, and reads the arrays that it was given: these must not be changed. If they were, it
    raises RuntimeError instead of returning inconsistent results.

    Several threads may use one triangulation. It can be pickled, with its input and all computed attributes.
    `copy.copy` returns the same object, `copy.deepcopy` one with its own points.

    Examples
    --------
    >>> from adaptivehilbertdelaunay import Kind, delaunay
    >>> made = delaunay([[0, 0], [4, 0], [4, 4], [0, 4], [1, 2]])
    >>> made
    <Triangulation of 5 points: 4 triangles>
    >>> print(made.triangles)
    [[0 4 3]
     [0 1 4]
     [4 2 3]
     [4 1 2]]
    >>> made.neighbors[0].tolist()
    [1, 2, -1]
    >>> where = made.locate([[2, 1], [1, 2], [5, 5]])
    >>> where.triangle.tolist(), [Kind(kind).name for kind in where.kind]
    ([1, 0, -1], ['IN_TRIANGLE', 'ON_VERTEX', 'OUTSIDE'])
    >>> made.counts["inserted"], made.counts["duplicates"]
    (5, 0)
    """

    def __init__(self, request: Request, id_dtype: Any, wanted: Tuple[str, ...], progress: Any) -> None:
        self._start(request, id_dtype)
        self._fingerprint = request.fingerprint()  # before the run, in which the input may change, too
        job = self._run(set(wanted), progress)
        self._numbers = job.numbers(library.COUNTS), job.numbers(library.MEASURES)
        triangles = np.empty((self._numbers[0][_TRIANGLES], 3), self._dtype)
        self._cached["triangles"] = frozen(job.array("triangles", out=triangles))
        for name in wanted:
            self.voronoi() if name == "voronoi" else getattr(self, name)
        job.set_progress(None)

    @functools.cached_property
    def _counts(self) -> Dict[str, int]:
        return dict(zip(library.names(library.COUNTS), self._numbers[0]))

    @functools.cached_property
    def _measures(self) -> Dict[str, float]:
        return dict(zip(library.names(library.MEASURES), self._numbers[1]))

    def _of_triangles(self, name: str, dtype: Any = None) -> np.ndarray:
        """Rows of an array of cells that are triangles."""

        def make() -> np.ndarray:
            cells = self._engine(name).array(name, dtype or self._dtype)
            return frozen(cells[self._others :]) if self._others else frozen(cells)

        made: np.ndarray = self._made(name, make)
        return made

    @property
    def _others(self) -> int:
        """Cells that come before the triangles."""
        return self._counts["lines"] + self._counts["vertices"]

    def release(self) -> None:
        """Returns the engine's memory to the system. Computed attributes stay; others are computed later by
        triangulating once more."""
        with self._locked():
            self._job = None

    # --- points ---

    @property
    def points(self) -> np.ndarray:
        """(n, 2) or (n, 3) float32 or float64: the points that ids refer to. The given points, not copied; or, if
        points are added (source points, bounding points, crossings, in this order after the others) or moved
        (duplicates='mean_z'), a copy in float64."""

        def make() -> np.ndarray:
            request = self._request
            if not self._counts["added_points"] and request.settings["duplicates"] != library.DUPLICATES_MEAN_Z:
                self._check_input()
                return _view(request.points)
            return frozen(self._engine().array("points", np.float64)[:, : request.columns])

        made: np.ndarray = self._made("points", make)
        return made

    @property
    def plane_points(self) -> np.ndarray:
        """(n, 3) float64: all points in the plane of the triangulation, x and y, and the height above it."""
        return self._array("plane_points", np.float64)

    @property
    def plane_matrix(self) -> np.ndarray:
        """(4, 4) float64: the matrix that moves a point (x, y, z, 1) to its position in the plane. NotAvailable, a
        RuntimeError, if the plane is a function."""
        return self._array("plane_matrix", np.float64)

    @property
    def point_status(self) -> np.ndarray:
        """(n,) int: the status of each point. Its own id: it is a vertex. Another id: the vertex that represents it, a
        duplicate or merged point. -1: rejected, x or y is NaN or infinite. -2: not inserted (skipped, or beyond
        insertion_limit). -3: left out within maximum_error, or for maximum_vertices."""
        return self._array("point_status")

    @property
    def errors(self) -> np.ndarray:
        """(n,) float64: how far the surface is from each point, vertically (in a plane: along its normal), or in the
        `values` of `simplify`. 0 for vertices; NaN where there is no surface, and for points that were rejected or
        skipped."""
        return self._array("errors", np.float64)

    @property
    def vertex_of_point(self) -> np.ndarray:
        """(n,) int: the vertex at each point's position, numbered from 0 in canonical order without gaps; -1: none. For
        arrays with one value per vertex; `point_of_vertex` is the inverse."""
        return self._array("vertex_of_point")

    @property
    def point_of_vertex(self) -> np.ndarray:
        """(v,) int: the id of the point that represents each vertex, those beyond insertion_limit included."""
        return self._array("point_of_vertex")

    @property
    def merged(self) -> np.ndarray:
        """(m, 2) int: points merged by `tolerance`, and the points they were merged into."""
        return self._array("merged")

    # --- cells ---

    @property
    def triangles(self) -> np.ndarray:
        """(t, 3) int: the ids of the corners, counterclockwise in the plane, in canonical order."""
        made: np.ndarray = self._cached["triangles"]
        return made

    @property
    def neighbors(self) -> np.ndarray:
        """(t, 3) int: ``neighbors[i, k]`` is the triangle across the edge of triangle `i` from its corner `k` to the
        next one; -1: none. (In `scipy.spatial.Delaunay` it is the one across the edge opposite to corner `k`.)"""

        def make() -> np.ndarray:
            rows = self._engine().array("neighbors", self._dtype)[self._others :]
            if self._others:
                rows = np.where(rows >= self._others, rows - self._dtype.type(self._others), self._dtype.type(-1))
            return frozen(rows)

        made: np.ndarray = self._made("neighbors", make)
        return made

    @property
    def edges(self) -> np.ndarray:
        """(e, 2) int: the edges of the triangles, each once, in the direction of its first triangle, in the order of
        the triangles."""

        made: np.ndarray = self._made("edges", lambda: self._edges_where(self._is_first()))
        return made

    @property
    def boundary(self) -> np.ndarray:
        """(b, 2) int: the edges with a triangle on one side only, their left, in the order of the triangles."""
        made: np.ndarray = self._made("boundary", lambda: self._edges_where(self.neighbors < 0))
        return made

    def _is_first(self) -> np.ndarray:
        """(t, 3): is the triangle the first one with the edge?"""
        beyond = self.neighbors
        return (beyond < 0) | (beyond > np.arange(len(beyond), dtype=beyond.dtype)[:, None])

    def _edges_where(self, chosen: np.ndarray) -> np.ndarray:
        triangle, corner = np.nonzero(chosen)
        return frozen(np.stack((self.triangles[triangle, corner], self.triangles[triangle, (corner + 1) % 3]), axis=1))

    @property
    def hull(self) -> np.ndarray:
        """(h,) int: the ids of the vertices on the boundary of the convex hull of all, counterclockwise, those on its
        straight edges included; empty if all vertices are collinear. If loops, alpha, lengths or the rim removed
        triangles, it is still the hull of all: `boundary` bounds the remaining triangles."""
        made: np.ndarray = self._made("hull", lambda: frozen(self._find_hull()))
        return made

    def _find_hull(self) -> np.ndarray:
        counts = self._counts
        if counts["delaunay_triangles"] == 0:
            return np.empty(0, self._dtype)
        if len(self.triangles) < counts["delaunay_triangles"]:
            status = self.point_status
            ids = np.flatnonzero(status == np.arange(len(status))).astype(self._dtype)
            places = np.ascontiguousarray(self.plane_points[ids, :2])
            settings = {**DEFAULTS, **{name: self._request.settings[name] for name in ("threads", "memory_limit")}}
            whole = Triangulation(Request(places, None, None, {}, "xy", settings), self._dtype, (), None)
            found: np.ndarray = ids[whole.hull]
            return found
        return chained(self.boundary)

    @property
    def lines(self) -> np.ndarray:
        """(l, 2) int: with `alpha`, edges of at most twice alpha whose triangles are all too large."""
        return self._array("lines")

    @property
    def vertices(self) -> np.ndarray:
        """(v,) int: with `alpha`, points in no triangle and on no line."""
        return self._array("vertices")

    # --- constraints ---

    @property
    def constraint_edges(self) -> np.ndarray:
        """(c, 2) int: the edges of the triangles that are constraints, each once, as in `edges`."""

        made: np.ndarray = self._made(
            "constraint_edges_ids", lambda: self._edges_where(self.is_constraint & self._is_first())
        )
        return made

    @property
    def is_constraint(self) -> np.ndarray:
        """(t, 3) bool: is the edge of a triangle from corner `k` to the next one a constraint?"""

        bits = self._of_triangles("constraint_edges", np.uint8)
        made: np.ndarray = self._made(
            "is_constraint", lambda: frozen((bits[:, None] & np.array([1, 2, 4], np.uint8)) != 0)
        )
        return made

    @property
    def regions(self) -> np.ndarray:
        """(t,) int: the region of each triangle; regions are separated by constraints and numbered from 0 in the order
        of the triangles."""
        return self._of_triangles("regions")

    @property
    def left_out(self) -> np.ndarray:
        """(o, 4) int: segments left out because they cross earlier ones: chain and segment of each, and of the
        one it crosses first. Chains are numbered from 0: segments, lines, loops; segments from 0 within each."""
        return self._array("left_out")

    @property
    def crossing_ends(self) -> np.ndarray:
        """(x, 4) int: for each point added by crossings='split', the last x of `points`: the ends of the two segments
        that cross there."""
        return self._array("crossing_ends")

    @property
    def crossing_fractions(self) -> np.ndarray:
        """(x, 2) float64: the position of the crossing on each of the two segments, from 0, the first end, to 1."""
        return self._array("crossing_fractions", np.float64)

    # --- insertion ---

    @property
    def order(self) -> np.ndarray:
        """(v,) int: the ids of the vertices in the order in which they were inserted."""
        return self._array("order", told="order")

    @property
    def insertion_ranks(self) -> np.ndarray:
        """(n,) int: the position of each point in that order, those beyond insertion_limit included; -1: none."""
        return self._array("insertion_ranks", told="insertion_ranks")

    @property
    def boxes(self) -> Boxes:
        """The boxes of the grid behind the insertion order; none with 'as_given'."""

        def make() -> Boxes:
            job = self._engine("boxes")
            return Boxes(
                frozen(job.array("box_bounds")),
                frozen(job.array("box_levels")),
                frozen(job.array("box_counts", self._dtype)),
            )

        made: Boxes = self._made("boxes", make)
        return made

    # --- questions ---

    def voronoi(self, clip: Union[None, Literal["hull", "bounds"], Corners] = None) -> Voronoi:
        """The Voronoi diagram of the vertices, without regard to constraints and removed triangles.

        Its topology is exact, like the triangles; corners are rounded to float64.

        Parameters
        ----------
        clip : {'hull', 'bounds'}, (n, 2) array or geometry, optional
            Clip the cells at the convex hull of the vertices; at their bounding box; or at the convex polygon that has
            these corners, in their order, of two corners at the box between them: coordinates in the plane of the
            triangulation, or a geometry as for `constraints` of `delaunay`. Default: `voronoi_clip` of the
            triangulation, 'hull' if it was not given.

        Returns
        -------
        Voronoi
            One cell for each vertex, by ascending smallest id of the points at its place; in a polygon it may be empty,
            and then has no corners. Collinear vertices have no cells in their hull, and strips in a polygon or a
            bounding box that has an area.

        Examples
        --------
        >>> from adaptivehilbertdelaunay import delaunay
        >>> diagram = delaunay([[0, 0], [4, 0], [4, 4], [0, 4], [2, 2]]).voronoi()
        >>> len(diagram), diagram.sites.tolist(), diagram[4].tolist()
        (5, [0, 1, 2, 3, 4], [[2.0, 4.0], [0.0, 2.0], [2.0, 0.0], [4.0, 2.0]])
        >>> delaunay([[1, 1], [3, 1]]).voronoi([[0, 0], [4, 2]])[1].tolist()
        [[2.0, 2.0], [2.0, 0.0], [4.0, 0.0], [4.0, 2.0]]
        """
        number = self._request.settings["voronoi_clip"]
        corners = None if clip is None or isinstance(clip, str) else polygon_of("clip", clip)
        if corners is not None:
            number = library.CLIP_POLYGON
        elif clip is not None:
            if clip not in CHOICES["voronoi_clip"]:
                raise ValueError("clip must be 'hull' or 'bounds', not %r" % (clip,))
            number = CHOICES["voronoi_clip"].index(clip)
        name = "voronoi %d" % number if corners is None else "voronoi %r" % corners.tolist()
        made: Voronoi = self._made(name, lambda: self._make_voronoi(int(number), corners))
        return made

    def _make_voronoi(self, clip: int, corners: Optional[np.ndarray]) -> Voronoi:
        if corners is None and clip == self._request.settings["voronoi_clip"]:
            job = self._engine("voronoi")
        else:
            self._engine()
            job = self._request.job(["voronoi"])
            job.set(voronoi_clip=clip)
            if corners is not None:
                job.set_array("voronoi_polygon", corners)
            job.run()
        made = Voronoi(
            frozen(job.array("voronoi_points")),
            *(frozen(job.array("voronoi_" + name, self._dtype)) for name in ("offsets", "corners", "sites")),
        )
        if job is not self._job:
            library.give_back(job)
        if corners is not None:  # of those in such polygons the last is kept
            for name in [name for name in self._cached if name.startswith("voronoi [")]:
                del self._cached[name]
        return made

    def locate(self, places: Any) -> Location:
        """Locates places in the triangulation; exact.

        Parameters
        ----------
        places : (k, 2) array of real numbers, or tuple (x, y)
            Places in the plane of the triangulation, in the unit of the points. Any values are allowed, NaN included.

        Returns
        -------
        Location
            In removed triangles (by loops, alpha, ...), `kind` and `corners`
            are those of the whole triangulation, and `triangle` is -1.
        """
        given = unmasked("places", xy_of(places))
        if given.ndim != 2 or given.shape[1] != 2:
            raise ValueError("places must be of shape (k, 2), not %s" % (given.shape,))
        places = real_numbers("places", given)
        with self._locked():
            job = self._for_places()
            kinds, corners, cells = job.locate(places, self._dtype)
        if self._others:
            cells = np.where(cells < 0, cells, cells - self._dtype.type(self._others))
        return Location(kinds, cells, corners)

    @property
    def counts(self) -> Mapping[str, int]:
        """Counts by name: points, inserted, duplicates, not_finite, skipped, merged_points, beyond_limit,
        within_error, added_points, triangles, constraint_edges, segments_crossing, unfilled_loops, ...; the C interface
        (``Filters/Engine/Interface/ahd.h``) describes all."""
        return MappingProxyType(self._counts)

    @property
    def measures(self) -> Mapping[str, float]:
        """Measures by name: np and nr (-1 without count_work), trimmed_area, largest_error, the seconds of each
        phase."""
        return MappingProxyType(self._measures)

    # --- as an object ---

    if not TYPE_CHECKING:  # for which any name would be one of a Triangulation

        def __getattr__(self, name: str) -> Any:
            """AttributeError, which gives the name here of an attribute of scipy.spatial.Delaunay."""
            if name in _NAMES_OF_SCIPY:
                raise AttributeError("a Triangulation has no %s: see %s" % (name, _NAMES_OF_SCIPY[name]))
            return object.__getattribute__(self, name)

    def __repr__(self) -> str:
        if "triangles" not in self.__dict__.get("_cached", ()):
            return "<Triangulation that was not made>"
        return "<Triangulation of %d points: %d triangles>" % (self._counts["points"], len(self.triangles))

    def _repr_html_(self) -> str:
        """A small picture, for notebooks, and what became of the points."""
        words = [repr(self)[1:-1]]
        words += ["%s: %d" % (name.replace("_", " "), self._counts[name]) for name in (
            "source_points", "constraint_edges", "segments_crossing", "duplicates", "not_finite", "skipped",
            "within_error") if self._counts[name]]  # fmt: skip
        isPlain = self._request.settings["plane"] == library.PLANE_XY
        picture = svg(self.triangles, self.points if isPlain else self.plane_points)
        return "<div>%s<br>%s</div>" % (picture, "; ".join(words))

    def __copy__(self) -> Triangulation:
        return self

    def __getstate__(self) -> Dict[str, Any]:
        names = ("_request", "_dtype", "_cached", "_counts", "_measures", "_fingerprint")
        with self._locked():
            cached = {name: made for name, made in self._cached.items() if name != "points"}
            return {**{name: getattr(self, name) for name in names}, "_cached": cached}

    def __setstate__(self, state: Dict[str, Any]) -> None:
        self._start(state["_request"], state["_dtype"])
        self.__dict__.update(state)
        for made in self._cached.values():
            for array in _arrays_of(made):
                frozen(array)
