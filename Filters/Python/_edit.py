# SPDX-License-Identifier: BSD-3-Clause
"""Points and segments that come, go and move."""

from __future__ import annotations

import ctypes
from typing import Any, Dict, NamedTuple, NoReturn, Optional, Sequence, Tuple, Union

import numpy as np

from . import _library as library
from ._input import DEFAULTS, Request, points_of, settings_of
from ._keywords import KEYWORDS
from ._raster import real_numbers, unmasked, xy_of
from ._segments import pairs_of
from ._triangulation import Triangulation
from ._warnings import warn

_FEW = 16  #: requests that take less time than to listen to Ctrl-C
_REFUSED = {
    library.EDIT_NO_POINT: "no point has the id %s",
    library.EDIT_END_OF_SEGMENT: "point %s is the end of a segment: release that first",
    library.EDIT_SEGMENTS_MEET:
        "point %s lies where two segments meet, which would cross without it: release one first",
    library.EDIT_NOT_FINITE: "segment %s has an end that is not finite",
    library.EDIT_NO_LENGTH: "segment %s has both ends at one place",
    library.EDIT_NO_SEGMENT: "there is no segment %s",
}
# Keywords that a triangulation may have had that is edited.
_KEPT = {"insertion_order", "nmax", "control_points", "gene_rotation", "count_work", "threads", "memory_limit",
         "voronoi_clip", "fill_rule", "crossings"}  # fmt: skip


class EditPlaces(NamedTuple):
    """Where places lie, in an Edit."""

    kind: np.ndarray  #: (k,) int32: a Kind for each place
    points: np.ndarray  #: (k, 3) int64: ids of the triangle's corners, the edge's ends or the point; the rest is -1


class Edit:
    """Points and segments that come, go and move, with their triangulation always known.

    After any history `done` gives, to the byte, what `delaunay` gives of the points and segments that are left. Which
    of two segments that cross was accepted is history: the first.

    The id of a point is the number of points that came before it: it stays, and is not used again. Of points at one
    place the one of smallest id represents the vertex; when it goes, the next one does. A segment through points is a
    row of edges.

    One point takes one to three microseconds wherever it is, a call ten more: give many at once. A call that refuses
    one request has done the others; one that is interrupted, those before; `insert` does all or nothing. For one
    thread at a time. ``with`` frees its memory at the end.

    Parameters
    ----------
    points : (n, 2) or (n, 3) array of real numbers, or table
        The first points, with the ids 0 to n - 1. All that come later have as many columns.
    segments : (m, 2) array of ids, optional
        As for `constrain`; those that cross earlier ones are left out.
    threads, memory_limit
        As for `delaunay`.

    Examples
    --------
    >>> from adaptivehilbertdelaunay import Edit
    >>> with Edit([[0, 0], [4, 0], [4, 4], [0, 4]]) as edit:
    ...     new = edit.insert([[1, 2], [3, 2]])
    ...     accepted = edit.constrain([[0, 2], [1, 3], [4, 5]])
    ...     edit.move([5], [[3, 1]])
    ...     edit.remove([4])
    ...     print(new, accepted, edit.locate([[2, 2], [9, 9]]).kind)
    ...     made = edit.done()
    ...     print(made, edit.ids)
    [4 5] [ True False False] [1 3]
    <Triangulation of 5 points: 4 triangles>
    [0 1 2 3 5]
    """

    _job: Optional[library.Job]

    def __init__(
        self, points: Any = (), segments: Any = (), *, threads: int = 0, memory_limit: Union[int, str] = 0
    ) -> None:
        self._keywords = {**DEFAULTS, "threads": threads, "memory_limit": memory_limit}
        self._begin(points, settings_of(self._keywords), np.dtype(np.int32))
        if len(segments):
            self.constrain(segments)

    def _begin(self, points: Any, settings: Dict[str, Any], id_dtype: Any) -> None:
        self._settings, self._dtype = settings, id_dtype
        self._z = np.empty(0)  # by id, where points have one; longer than that
        self._columns = 0  # of the points that came
        self._job = library.take_job()
        usual = library.defaults()
        own = {"threads": library.threads_for(settings["threads"]), "memory_limit": settings["memory_limit"]}
        self._job.set(**{name: value for name, value in own.items() if value != usual[name]})
        self.insert(points)

    @classmethod
    def _of(cls, made: Triangulation) -> Edit:
        """Of what a triangulation was made of. ValueError if it was more than points and segments."""
        request = made._request
        usual = settings_of({})
        others = [name for name, row in KEYWORDS.items()
                  if name not in _KEPT and request.settings[row.setting] != usual[row.setting]]  # fmt: skip
        others += ["plane"] * (request.settings["plane"] != library.PLANE_XY)
        more = set(request.arrays) - {"points", "line_ids", "line_offsets", "loop_offsets", "voronoi_polygon"}
        others += sorted("loops" if name == "loop_ids" else name for name in more)
        if made.counts["added_points"]:
            others.append("crossings")
        if others:
            raise ValueError("a triangulation of points, segments and lines can be edited, not one with %s" %
                             ", ".join(dict.fromkeys(others)))  # fmt: skip
        edit = cls.__new__(cls)
        edit._keywords = dict(DEFAULTS)
        with made._locked():
            made._check_input()
            edit._begin(request.points, request.settings, made._dtype)
            pairs = pairs_of(request)
        wanted = pairs[_longer(pairs, request.points)]
        if len(wanted):
            edit.constrain(wanted)
        return edit

    # --- calls ---

    def _own(self) -> library.Job:
        if self._job is None:
            raise ValueError("the edit was closed")
        if self._job.isLost:
            raise RuntimeError("the edit was at work in another thread when the process was forked: it is lost here")
        return self._job

    def _call(self, name: str, count: int, *arguments: Any, arrays: Sequence[np.ndarray] = ()) -> None:
        """With so many requests; with few Ctrl-C waits for their end, unless all points are looked at."""
        job = self._own()
        isBrief = count <= _FEW
        if isBrief:
            ready = ctypes.c_int32()
            job._call("ahd_edit_ready", ready, isBrief=True)
            isBrief = ready.value == 1
        job._call(name, *arguments, arrays=arrays, isBrief=isBrief)

    def _request(self, function: str, given: np.ndarray) -> np.ndarray:
        """Outcomes of requests, one for each row of `given`, which is int64."""
        outcomes = np.empty(len(given), np.uint8)
        addresses = given.ctypes.data, len(given), outcomes.ctypes.data
        self._call(function, len(given), *addresses, arrays=(given, outcomes))
        return outcomes

    def _check(self, name: str, outcomes: np.ndarray, given: np.ndarray) -> None:
        refused = np.flatnonzero(outcomes)
        if len(refused):
            _refuse(name, int(outcomes[refused[0]]), given[refused[0]], len(refused))

    def _points(self, given: Any) -> Tuple[np.ndarray, np.ndarray]:
        """x and y, (n, 2) float64, and z, (n,)."""
        points = points_of("points", given)
        if len(points) and points.shape[1] != self._columns:
            if self._next_id():
                raise ValueError("points must be of shape (n, %d) like the first ones, not %s"
                                 % (self._columns, points.shape))  # fmt: skip
            self._columns = points.shape[1]
        return np.ascontiguousarray(points[:, :2], np.float64), points[:, 2:].astype(np.float64).ravel()

    def _next_id(self) -> int:
        first = ctypes.c_int64()
        self._call("ahd_edit_insert", 0, None, 0, first)
        return first.value

    # --- changes ---

    def insert(self, points: Any) -> np.ndarray:
        """Inserts points, (n, 2) or (n, 3), all or none, and returns their ids, (n,) int64. A point that is not finite
        has an id, and no vertex."""
        xy, z = self._points(points)
        if len(z):  # before they are there: those of a call that fails are written over
            begin = self._next_id()
            end = begin + len(z)
            if end > len(self._z):
                self._z = np.concatenate((self._z, np.zeros(max(end, 2 * len(self._z)) - len(self._z))))
            self._z[begin:end] = z
        first = ctypes.c_int64()
        self._call("ahd_edit_insert", len(xy), xy.ctypes.data, len(xy), first, arrays=(xy,))
        return np.arange(first.value, first.value + len(xy))

    def remove(self, ids: Any) -> None:
        """Removes points. ValueError names the first that cannot go: there is none with the id, or a segment ends
        there, or two meet there that would cross without it. The others are gone."""
        given = _ids("ids", ids, 1)
        self._check("remove", self._request("ahd_edit_remove", given), given)

    def move(self, ids: Any, points: Any) -> None:
        """Moves points; they keep their ids. Refused as by `remove`."""
        given = _ids("ids", ids, 1)
        xy, z = self._points(points)
        if len(xy) != len(given):
            raise ValueError("there are %d ids and %d points" % (len(given), len(xy)))
        outcomes = np.ones(len(given), np.uint8)
        try:
            addresses = given.ctypes.data, xy.ctypes.data, len(given), outcomes.ctypes.data
            self._call("ahd_edit_move", len(given), *addresses, arrays=(given, xy, outcomes))
        finally:
            if self._columns == 3:
                moved = outcomes == library.EDIT_DONE
                self._z[given[moved]] = z[moved]
        self._check("move", outcomes, given)

    def constrain(self, segments: Any) -> np.ndarray:
        """Makes segments, (m, 2) ids, edges, in this order. Returns (m,) bool: was it accepted? One that crosses an
        accepted one is not. ValueError names the first without two points at different, finite places; the others are
        as they would be without it."""
        given = _ids("segments", segments, 2)
        outcomes = self._request("ahd_edit_constrain", given)
        self._check("constrain", np.where(outcomes == library.EDIT_CROSSES, library.EDIT_DONE, outcomes), given)
        accepted: np.ndarray = outcomes == library.EDIT_DONE
        return accepted

    def release(self, segments: Any) -> None:
        """The segments, given in either direction, are gone. ValueError names the first that was not there."""
        given = _ids("segments", segments, 2)
        self._check("release", self._request("ahd_edit_release", given), given)

    # --- what there is ---

    def locate(self, places: Any) -> EditPlaces:
        """Where places, (k, 2) or (x, y), lie; exact. The corners of a triangle are counterclockwise from the smallest
        id, the smaller end of an edge comes first."""
        xy = np.ascontiguousarray(real_numbers("places", unmasked("places", xy_of(places))))
        if xy.ndim != 2 or xy.shape[1] != 2:
            raise ValueError("places must be of shape (k, 2), not %s" % (xy.shape,))
        found = EditPlaces(np.empty(len(xy), np.int32), np.empty((len(xy), 3), np.int64))
        addresses = [array.ctypes.data for array in (xy, *found)]
        self._call("ahd_edit_locate", len(xy), addresses[0], len(xy), *addresses[1:], arrays=(xy, *found))
        return found

    def _written(self) -> Tuple[np.ndarray, np.ndarray, np.ndarray]:
        points, segments = self._sizes()
        ids, xy, pairs = np.empty(points, np.int64), np.empty((points, 2)), np.empty((segments, 2), np.int64)
        made = (ids, xy, pairs)
        self._call("ahd_edit_write", points, *(array.ctypes.data for array in made), arrays=made)
        return made

    def _sizes(self) -> Tuple[int, int]:
        points, segments = ctypes.c_uint64(), ctypes.c_uint64()
        self._own()._call("ahd_edit_size", points, segments, isBrief=True)
        return points.value, segments.value

    def __len__(self) -> int:
        """The number of points."""
        return self._sizes()[0]

    @property
    def ids(self) -> np.ndarray:
        """(n,) int64: the ids of the points, ascending: row i of the points of `done` is that with ``ids[i]``."""
        return self._written()[0]

    @property
    def segments(self) -> np.ndarray:
        """(m, 2) int64: the ids of the ends of the segments, the smaller first, in ascending order."""
        ids, _, pairs = self._written()
        ends: np.ndarray = ids[pairs]
        return ends

    def done(self) -> Triangulation:
        """The triangulation of what is left, as `delaunay` makes it; editing may go on."""
        ids, xy, pairs = self._written()
        points = np.column_stack((xy, self._z[ids])) if self._columns == 3 else xy
        request = Request(points, None, None, {"segments": pairs}, "xy", self._keywords)
        request.settings.update({**self._settings, "voronoi_clip": request.settings["voronoi_clip"]})
        made = Triangulation(request, self._dtype, (), None)
        warn(made._job, {})
        return made

    # --- as an object ---

    def __repr__(self) -> str:
        if self._job is None or self._job.isLost:
            return "<Edit, closed>"
        points, segments = self._sizes()
        return "<Edit of %d points and %d segments>" % (points, segments)

    def __enter__(self) -> Edit:
        return self

    def __exit__(self, *_: Any) -> None:
        """Frees its memory: it cannot be used any more."""
        job, self._job = self._job, None
        if job is not None:
            library.give_back(job)

    def __reduce__(self) -> NoReturn:
        raise TypeError("an Edit cannot be copied or pickled: what done() gives can")


def _refuse(name: str, outcome: int, what: Any, count: int) -> NoReturn:
    more = "" if count == 1 else ", and %d more are refused" % (count - 1)
    raise ValueError("%s: %s%s" % (name, _REFUSED[outcome] % (what.tolist() if what.ndim else what,), more))


def _ids(name: str, given: Any, columns: int) -> np.ndarray:
    """(k,) or (k, columns) int64, contiguous. TypeError, ValueError."""
    ids = np.asarray(given)
    shape = (-1,) if columns == 1 else (-1, columns)
    if ids.size == 0:
        return np.empty(0, np.int64).reshape(shape)
    if ids.dtype.kind not in "iu":
        raise TypeError("%s must be whole numbers, the ids of points, not of type %s" % (name, ids.dtype))
    if ids.shape[1:] != shape[1:] or ids.ndim != len(shape):
        raise ValueError("%s must be of shape %s, not %s" % (name, "(k,)" if columns == 1 else "(k, 2)", ids.shape))
    if ids.dtype.kind == "u" and int(ids.max()) >= 2**63:  # NumPy 1 compares doubles
        raise ValueError("%s: no point has the id %d" % (name, ids.max()))
    return np.ascontiguousarray(ids, np.int64)


def _longer(pairs: np.ndarray, points: np.ndarray) -> np.ndarray:
    """Which segments have two finite ends at different places? The rest is nothing, and counted by the run."""
    a, b = (points[pairs[:, k], :2] for k in range(2))
    longer: np.ndarray = np.isfinite(a).all(axis=1) & np.isfinite(b).all(axis=1) & (a != b).any(axis=1)
    return longer
